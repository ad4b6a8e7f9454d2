#include "outputs.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <map>
#include <system_error>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "program.hpp"

namespace hwffd::command {
namespace {

namespace fs = std::filesystem;

/// One name for one place, however it is written.
std::string place_of(const std::string& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);  // what is not there yet stays relative else
  if (error) return path;
  const fs::path place = fs::weakly_canonical(absolute, error);
  return error ? path : place.string();
}

/// A device takes as much as one likes.
bool is_device(const std::string& path) {
  std::error_code ignored;
  return fs::is_other(path, ignored);
}

}  // namespace

void check_not_read(const Output& output, const std::vector<std::string>& inputs) {
  if (output.path.empty() || output.path == "-" || is_device(output.path)) return;
  for (const std::string& input : inputs) {
    std::error_code none;
    if (!fs::equivalent(output.path, input, none)) continue;
    throw UsageError(
        fmt::format("{} {}: is read from; name another file", output.option, excerpt(output.path)));
  }
}

void check_outputs(const std::vector<Output>& outputs, const std::vector<std::string>& inputs) {
  std::map<std::string, const char*> options;
  for (const Output& output : outputs) {
    if (output.path.empty() || is_device(output.path)) continue;
    const bool standard = output.path == "-";
    const auto [other, is_new] =
        options.emplace(standard ? output.path : place_of(output.path), output.option);
    if (!is_new) {
      throw UsageError(fmt::format("{} {}: {} goes there already; name another file", output.option,
                                   output.path, other->second));
    }
    check_not_read(output, inputs);
    if (!standard) check_writable(output.path);
  }
}

void write_output(const std::string& path, const std::string& text) {
  if (path == "-") {
    write_standard_output(text);
  } else {
    write_files({{path, text}});
  }
}

}  // namespace hwffd::command
