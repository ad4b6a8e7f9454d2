#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hwffd::words {
std::string json_report(const std::vector<Result>& results) {
  nlohmann::ordered_json rows = nlohmann::ordered_json::array();
  for (const Result& r : results) {
    rows.push_back({{"form", r.form},
                    {"format", r.format},
                    {"word_length", r.word_length},
                    {"max_error", r.max_error},
                    {"rms_error", r.rms_error},
                    {"bound", r.bound},
                    {"vertices", r.vertices}});
  }
  return nlohmann::ordered_json{{"rows", std::move(rows)}}.dump(2) + "\n";
}

std::string faults(const std::vector<Result>& results) {
  std::string text;
  for (const Result& r : results) {
    if (r.vertices > 0 && r.max_error <= r.bound) continue;
    text += fmt::format("{} {}: error {:.3e} over {} vertices, {:.3e} is proved\n", r.form,
                        r.format, r.max_error, r.vertices, r.bound);
  }
  return text;
}

}  // namespace hwffd::words
