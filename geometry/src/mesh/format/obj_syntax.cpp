#include "mesh/format/obj_syntax.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mesh/read_scene.hpp"

namespace hwffd {
namespace {

ObjVector vector_in(const LineReader& lines, const char* what) {
  const std::vector<std::string_view>& words = lines.words();
  const auto refuse = [&] { refuse_line(lines, fmt::format("a {} is not three numbers", what)); };
  ObjVector vector;
  if (words.size() < 4) refuse();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    vector.words[axis] = words[1 + axis];
    if (!read_number(words[1 + axis], vector.numbers[axis])) refuse();
  }
  return vector;
}

}  // namespace

void refuse_line(const LineReader& lines, const std::string& what) {
  throw not_a_mesh(fmt::format("line {}: {}", lines.number(), what));
}

ObjVector obj_normal(const LineReader& lines) { return vector_in(lines, "normal"); }

ObjVector obj_vertex(const LineReader& lines) {
  ObjVector vertex = vector_in(lines, "vertex");
  constexpr std::size_t kWeighted = 5;
  if (lines.words().size() != kWeighted) return vertex;
  TextNumber weight;
  if (!read_number(lines.words()[4], weight) || weight.value == 0) {
    refuse_line(lines, "a vertex is not three numbers");
  }
  vertex.weight = weight.value;
  return vertex;
}

ObjCorner obj_corner(const LineReader& lines, std::string_view word) {
  ObjCorner corner;
  std::string_view rest = word;
  for (std::size_t n = 0; n < 3; ++n) {
    const std::size_t end = std::min(rest.find('/'), rest.size());
    const std::string_view number = rest.substr(0, end);
    if (n == 2) corner.normal = number;
    const bool is_good = number.empty() ? n > 0 : read_whole(number, corner.numbers[n]);
    if (!is_good || (!number.empty() && corner.numbers[n] == 0)) {
      refuse_line(lines, in_quotes(word) + " is no corner of a face");
    }
    if (end == rest.size()) return corner;
    rest.remove_prefix(end + 1);
  }
  refuse_line(lines, in_quotes(word) + " is no corner of a face");
}

bool is_obj_element(std::string_view word) { return word == "f" || word == "l" || word == "p"; }

std::size_t corners_of_obj_element(std::string_view keyword, std::size_t words) {
  return keyword == "l" && words > 2 ? 2 * (words - 1) : words;
}

}  // namespace hwffd
