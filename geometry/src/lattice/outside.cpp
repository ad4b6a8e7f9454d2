#include "hwffd/lattice/outside.hpp"

#include <fmt/format.h>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "read_number.hpp"

namespace hwffd {
namespace {

constexpr const char* kAccepted = "accepted are keep, clamp and fade:WIDTH";

}  // namespace

Outside Outside::parse(std::string_view text) {
  constexpr std::string_view kFade = "fade:";
  if (text == "keep") return Outside(Kind::kKeep, 0.0);
  if (text == "clamp") return Outside(Kind::kClamp, 0.0);
  if (text.substr(0, kFade.size()) != kFade) {
    throw UsageError(fmt::format("outside '{}' is unknown; {}", excerpt(text), kAccepted));
  }
  const std::string_view argument = text.substr(kFade.size());
  double width = 0.0;
  if (read_number(argument, width) && width > 0.0) return Outside(Kind::kFade, width);
  constexpr std::size_t kQuoted = 40;  // of what is quoted twice
  throw UsageError(fmt::format("outside '{}': '{}' is not a finite number above 0; {}",
                               excerpt(text, kQuoted), excerpt(argument, kQuoted), kAccepted));
}

double Outside::weight(double distance) const {
  if (kind_ == Kind::kKeep) return 0.0;
  if (kind_ == Kind::kClamp) return 1.0;
  if (distance >= width_) return 0.0;
  const double x = distance / width_;
  return 1.0 - x * x * (3.0 - 2.0 * x);
}

double Outside::slope(double distance) const {
  if (kind_ != Kind::kFade || distance >= width_) return 0.0;
  const double x = distance / width_;
  return -6.0 * x * (1.0 - x) / width_;
}

}  // namespace hwffd
