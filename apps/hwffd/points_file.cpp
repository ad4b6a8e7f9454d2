#include "points_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <string_view>
#include <vector>

#include "hwffd/error.hpp"
#include "hwffd/mesh/extension.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd::command {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

/// The numbers of a line; false where something else stands there.
bool read_numbers(std::string_view line, std::vector<double>& numbers) {
  numbers.clear();
  line = line.substr(0, line.find('#'));
  while (true) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    if (line.empty()) return true;
    if (line.front() == '+') line.remove_prefix(1);
    double value = 0;
    const auto [next, error] = std::from_chars(line.data(), line.data() + line.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return false;
    line.remove_prefix(static_cast<std::size_t>(next - line.data()));
    if (!line.empty() && !is_blank(line.front())) return false;
    numbers.push_back(value);
  }
}

/// The numbers of all lines, as many in each, which should be `what`.
std::vector<double> read_lines(std::istream& in, const std::string& name, std::size_t each,
                               const char* what) {
  std::vector<double> values;
  std::vector<double> numbers;
  std::string line;
  for (std::size_t number = 1; std::getline(in, line); ++number) {
    if (number == 1 && line.rfind(kByteOrderMark, 0) == 0) line.erase(0, kByteOrderMark.size());
    const bool good = read_numbers(line, numbers);
    if (good && numbers.empty()) continue;
    if (!good || numbers.size() != each) {
      throw Error(fmt::format("{}: line {} is not {}; mend it", name, number, what));
    }
    values.insert(values.end(), numbers.begin(), numbers.end());
  }
  if (in.bad()) throw Error(fmt::format("{}: cannot be read to its end", name));
  return values;
}

bool is_ply(const std::filesystem::path& path) { return extension_of(path) == ".ply"; }

}  // namespace

bool names_points(const std::string& name) { return name == "-" || extension_of(name) == ".xyz"; }

Points read_points(std::istream& in, const std::string& name) {
  const std::vector<double> values = read_lines(in, name, 3, "x y z, three finite numbers");
  if (values.empty()) throw Error(fmt::format("{}: no points; give lines of x y z", name));
  return Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
}

std::vector<double> read_column(std::istream& in, const std::string& name) {
  std::vector<double> values = read_lines(in, name, 1, "one finite number");
  if (values.empty()) throw Error(fmt::format("{}: no numbers; give one a line", name));
  return values;
}

std::string points_text(const Points& points, const std::filesystem::path& path) {
  std::string text;
  if (is_ply(path)) {
    text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\n"
        "property double z\nend_header\n",
        points.rows());
  }
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    text += fmt::format("{} {} {}\n", points(i, 0), points(i, 1), points(i, 2));
  }
  return text;
}

void check_points_format(const std::filesystem::path& path) {
  if (is_ply(path) || !Mesh::can_save(path)) return;
  throw UsageError(fmt::format("{}: points make no {} mesh; use the extension ply, or xyz for text",
                               path.string(), extension_of(path)));
}

}  // namespace hwffd::command
