#include "points_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "hwffd/error.hpp"
#include "hwffd/mesh/extension.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd::command {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == ',' || c == ';'; }

/// The words of a line, up to a comment: views of it.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  line = line.substr(0, line.find('#'));
  while (true) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    if (line.empty()) return words;
    std::size_t end = 0;
    while (end < line.size() && !is_blank(line[end])) ++end;
    words.push_back(line.substr(0, end));
    line.remove_prefix(end);
  }
}

/// False where a word is no finite number.
bool read_number(std::string_view word, double& value) {
  if (word.front() == '+') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [next, error] = std::from_chars(word.data(), end, value);
  return next == end && error == std::errc() && std::isfinite(value);
}

/// Whether a line of these words is a row of names of columns.
bool is_heading(const std::vector<std::string_view>& words) {
  double ignored = 0;
  return std::none_of(words.begin(), words.end(),
                      [&](std::string_view word) { return read_number(word, ignored); });
}

/// The first numbers of all lines.
/// @param each  how many, and `what` they should be
/// @param may_have_more  whether a line may have further words, and the first be a heading
/// @param take  is called with each line's number, words and numbers
template <typename Take>
void read_lines(std::string_view text, const std::string& name, std::size_t each, const char* what,
                bool may_have_more, Take take) {
  std::vector<double> numbers(each);
  bool is_first = true;
  if (text.substr(0, kByteOrderMark.size()) == kByteOrderMark) {
    text.remove_prefix(kByteOrderMark.size());
  }
  for (std::size_t number = 1; !text.empty(); ++number) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(0, end));
    text.remove_prefix(std::min(end + (text.substr(end, 2) == "\r\n" ? 2 : 1), text.size()));
    if (words.empty()) continue;
    if (is_first && may_have_more && words.size() >= each && is_heading(words)) continue;
    is_first = false;
    bool good = words.size() == each || (may_have_more && words.size() > each);
    for (std::size_t w = 0; good && w < each; ++w) good = read_number(words[w], numbers[w]);
    if (!good) throw Error(fmt::format("{}: line {} is not {}; mend it", name, number, what));
    take(words, numbers);
  }
}

std::string text_of(std::istream& in, const std::string& name) {
  std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw Error(fmt::format("{}: cannot be read to its end", name));
  return text;
}

constexpr const char* kWhat = "x y z, three finite numbers";

bool is_ply(const std::filesystem::path& path) { return extension_of(path) == ".ply"; }

}  // namespace

bool names_points(const std::string& name) { return name == "-" || extension_of(name) == ".xyz"; }

PointsFile::PointsFile(std::istream& in, std::string name)
    : name_(std::move(name)), text_(text_of(in, name_)) {
  std::vector<double> values;
  read_lines(text_, name_, 3, kWhat, true, [&](const auto& words, const auto& numbers) {
    values.insert(values.end(), numbers.begin(), numbers.end());
    has_more_ = has_more_ || words.size() > 3;
  });
  if (values.empty()) throw Error(fmt::format("{}: no points; give lines of x y z", name_));
  points_ =
      Eigen::Map<const Points>(values.data(), static_cast<Eigen::Index>(values.size() / 3), 3);
}

std::string PointsFile::edited(const Points& points) const {
  std::string text;
  const char* done = text_.data();
  Eigen::Index row = 0;
  read_lines(text_, name_, 3, kWhat, true, [&](const auto& words, const auto& numbers) {
    for (std::size_t w = 0; w < 3; ++w) {
      const double now = points(row, static_cast<Eigen::Index>(w));
      if (now == numbers[w]) continue;
      text.append(done, words[w].data()).append(fmt::format("{}", now));
      done = words[w].data() + words[w].size();
    }
    ++row;
  });
  return text.append(done, text_.data() + text_.size());
}

std::vector<double> read_column(std::istream& in, const std::string& name) {
  std::vector<double> values;
  const std::string text = text_of(in, name);
  read_lines(text, name, 1, "one finite number", false,
             [&](const auto&, const auto& numbers) { values.push_back(numbers[0]); });
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
