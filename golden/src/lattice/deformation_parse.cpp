#include <fmt/format.h>

#include <array>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "read_number.hpp"

namespace hwffd {
namespace {

using Kind = Deformation::Kind;
using Arguments = Deformation::Arguments;

constexpr const char* kAccepted =
    "accepted are none, twist:DEGREES, shear:AMOUNT, bend:DEGREES, taper:FACTOR, scale:F, "
    "scale:FX,FY,FZ, random:SEED, move:I,J,K:DX,DY,DZ and to:FILE";

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

bool read_seed(std::string_view text, Arguments& to) { return read_number(text, to.seed); }

bool read_scale(std::string_view text, Arguments& to) {
  double factor = 0.0;
  if (!read_number(text, factor)) return read_three(text, to.vector);
  to.vector.setConstant(factor);
  return true;
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

/// A name, what stands for a missing argument (nothing if there must be one), and how one is read.
struct Entry {
  std::string_view name;
  Kind kind;
  std::string_view otherwise;
  bool (*read)(std::string_view text, Arguments& to);
  const char* expected;
};

constexpr const char* kNumber = "a finite number";
constexpr std::array<Entry, 8> kEntries{{
    {"twist", Kind::kTwist, "90", read_amount, kNumber},
    {"shear", Kind::kShear, "0.5", read_amount, kNumber},
    {"bend", Kind::kBend, "90", read_amount, kNumber},
    {"taper", Kind::kTaper, "0.5", read_amount, kNumber},
    {"scale", Kind::kScale, "1.5", read_scale, "one finite number or three"},
    {"random", Kind::kRandom, "1", read_seed, "an integer from 0 to 2^64 - 1"},
    {"move", Kind::kMove, "", read_move, "a point and three finite numbers"},
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
        fmt::format("deformation '{}': none takes no argument; {}", excerpt(text), kAccepted));
  }
  for (const Entry& entry : kEntries) {
    if (entry.name != name) continue;
    const std::string_view argument = has_argument ? text.substr(colon + 1) : entry.otherwise;
    Arguments arguments;
    if (entry.read(argument, arguments)) return Deformation(entry.kind, std::move(arguments));
    throw UsageError(fmt::format("deformation '{}': '{}' is not {}; {}", excerpt(text),
                                 excerpt(argument), entry.expected, kAccepted));
  }
  throw UsageError(fmt::format("deformation '{}' is unknown; {}", excerpt(text), kAccepted));
}

}  // namespace hwffd
