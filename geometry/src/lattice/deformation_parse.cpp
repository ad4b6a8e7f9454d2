#include <fmt/format.h>

#include <array>
#include <cmath>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "read_number.hpp"

namespace hwffd {
namespace {

using Kind = Deformation::Kind;
using Arguments = Deformation::Arguments;

constexpr double kMostDegrees = 1e6;  // beyond it the angle itself would be rounded visibly
constexpr std::size_t kQuoted = 40;   // characters of what the user wrote

/// Reads all of text as three numbers with commas between them.
template <typename Three>
bool read_three(std::string_view text, Three& values) {
  for (int n = 0; n < 3; ++n) {
    const std::size_t comma = text.find(',');
    if ((comma == std::string_view::npos) != (n == 2)) return false;
    if (!read_number(text.substr(0, comma), values[n])) return false;
    text.remove_prefix(n == 2 ? text.size() : comma + 1);
  }
  return true;
}

bool read_amount(std::string_view text, Arguments& to) { return read_number(text, to.amount); }

/// 0, 1, 2 for x, y, z; -1 for anything else.
int axis_of(char name) { return name >= 'x' && name <= 'z' ? name - 'x' : -1; }

/// Reads what may follow an amount: the axis that is up and, where `both`, the one that up bends
/// to.
bool read_axes(std::string_view text, bool both, Arguments& to) {
  if (text.empty() || text.size() > (both ? 2 : 1)) return false;
  to.axis = axis_of(text.front());
  to.towards = text.size() == 2 ? axis_of(text[1]) : (to.axis + 2) % 3;
  return to.axis >= 0 && to.towards >= 0 && to.axis != to.towards;
}

bool read_amount_about(std::string_view text, bool both, Arguments& to) {
  const std::size_t colon = text.find(':');
  const bool good = colon == std::string_view::npos || read_axes(text.substr(colon + 1), both, to);
  return good && read_amount(text.substr(0, colon), to);
}

bool read_taper(std::string_view text, Arguments& to) { return read_amount_about(text, false, to); }

bool read_turn(std::string_view text, Arguments& to) {
  return read_amount_about(text, false, to) && std::abs(to.amount) <= kMostDegrees;
}

bool read_bend(std::string_view text, Arguments& to) {
  return read_amount_about(text, true, to) && std::abs(to.amount) <= kMostDegrees;
}

bool read_seed(std::string_view text, Arguments& to) { return read_number(text, to.seed); }

bool read_scale(std::string_view text, Arguments& to) {
  double factor = 0.0;
  if (read_number(text, factor)) {
    to.vector.setConstant(factor);
  } else if (!read_three(text, to.vector)) {
    return false;
  }
  return (to.vector.array() != 0.0).all();
}

bool read_move(std::string_view text, Arguments& to) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return false;
  std::array<unsigned short, 3> place{};
  if (!read_three(text.substr(0, colon), place)) return false;
  to.place = {place[0], place[1], place[2]};
  return read_three(text.substr(colon + 1), to.vector);
}

bool read_file_name(std::string_view text, Arguments& to) {
  to.file = text;
  return !text.empty();
}

/// A name, what stands for a missing argument (nothing if there must be one), how one is read, and
/// what it looks like.
struct Entry {
  std::string_view name;
  Kind kind;
  std::string_view otherwise;
  bool (*read)(std::string_view text, Arguments& to);
  const char* expected;
};

constexpr const char* kTurn = "DEGREES, up to 1e6, or DEGREES:AXIS, which is x, y or z";
constexpr std::array<Entry, 9> kEntries{{
    {"twist", Kind::kTwist, "90", read_turn, kTurn},
    {"helix", Kind::kHelix, "90", read_turn, kTurn},
    {"shear", Kind::kShear, "0.5", read_amount, "a finite number"},
    {"bend", Kind::kBend, "90", read_bend,
     "DEGREES, up to 1e6, or DEGREES:AXES, such as y, or yz (y towards z)"},
    {"taper", Kind::kTaper, "0.5", read_taper, "FACTOR, or FACTOR:AXIS, which is x, y or z"},
    {"scale", Kind::kScale, "1.5", read_scale, "one finite number other than 0, or three"},
    {"random", Kind::kRandom, "1", read_seed, "an integer from 0 to 2^64 - 1"},
    {"move", Kind::kMove, "", read_move, "I,J,K:DX,DY,DZ, a point and three finite numbers"},
    {"to", Kind::kTo, "", read_file_name, "a file"},
}};

}  // namespace

Deformation Deformation::parse(std::string_view text) {
  const std::size_t colon = text.find(':');
  const bool has_argument = colon != std::string_view::npos;
  const std::string_view name = text.substr(0, colon);
  if (name == "none") {
    if (!has_argument) return Deformation(Kind::kNone, {});
    throw UsageError(
        fmt::format("deformation '{}': none takes no argument", excerpt(text, kQuoted)));
  }
  std::string names = "none";
  for (const Entry& entry : kEntries) {
    names.append(", ").append(entry.name);
    if (entry.name != name) continue;
    const std::string_view argument = has_argument ? text.substr(colon + 1) : entry.otherwise;
    Arguments arguments;
    if (entry.read(argument, arguments)) return Deformation(entry.kind, std::move(arguments));
    throw UsageError(fmt::format("deformation '{}': '{}' is not {}", excerpt(text, kQuoted),
                                 excerpt(argument, kQuoted), entry.expected));
  }
  throw UsageError(
      fmt::format("deformation '{}' is unknown; one of {}", excerpt(text, kQuoted), names));
}

}  // namespace hwffd
