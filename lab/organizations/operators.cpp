#include "operators.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "hwffd/error.hpp"

namespace hwffd::organizations {
namespace {

Operators operators_of(const nlohmann::json& json) {
  return {json.at("mul").get<int>(), json.at("add").get<int>(), json.at("fma").get<int>()};
}

}  // namespace

std::map<std::string, OperatorCount> read_operators(const std::filesystem::path& file) {
  try {
    std::ifstream stream(file);
    const nlohmann::json json = nlohmann::json::parse(stream);
    std::map<std::string, OperatorCount> counts;
    for (const auto& [name, count] : json.items()) {
      counts[name] = {operators_of(count.at("operators")), operators_of(count.at("drawn")),
                      count.at("evaluators").get<int>()};
    }
    return counts;
  } catch (const nlohmann::json::exception&) {
    throw Error(fmt::format("{}: not a count of operators: run python3 -m tools.synth.operators {}",
                            file.string(), file.string()));
  }
}

}  // namespace hwffd::organizations
