#include "device/function_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hwffd/error.hpp"
#include "hwffd/model/organizations.hpp"

namespace hwffd {
namespace {

Blending blending_words(const Oracle::Coefficients& axis, const WordCodec& codec) {
  if (axis == Oracle::uniform_bspline()) return watertight_bspline(codec);
  std::array<std::array<double, 4>, 4> rows{};
  for (int function = 0; function < 4; ++function) {
    for (int power = 0; power < 4; ++power) rows[function][power] = axis(function, power);
  }
  return user_blending(rows);
}

bool all_sum_to_one(const Device::Blending& blending) {
  return std::all_of(blending.begin(), blending.end(), Oracle::sum_to_one);
}

bool are_bsplines(const Device::Blending& blending) {
  return std::all_of(blending.begin(), blending.end(), [](const Oracle::Coefficients& axis) {
    return axis == Oracle::uniform_bspline();
  });
}

}  // namespace

std::array<AxisWords, 3> function_words(const Device::Blending& blending, const WordCodec& codec,
                                        const Configuration& row, const std::string& device) {
  if (wired_in(row) && !are_bsplines(blending)) {
    throw Error(
        fmt::format("{}: has the B-spline wired in and takes no other blending functions: take a "
                    "row without powers, or family bspline or clamped",
                    device));
  }
  if (completes(organization_of(row).form) && !all_sum_to_one(blending)) {
    throw Error(
        fmt::format("{}: takes blending functions that sum to one only; these do not: "
                    "take factored",
                    device));
  }
  return {encode(blending_words(blending[0], codec), codec),
          encode(blending_words(blending[1], codec), codec),
          encode(blending_words(blending[2], codec), codec)};
}

Normalization::Origin origin_for(const Device::Blending& blending) {
  return all_sum_to_one(blending) ? Normalization::Origin::kCentre : Normalization::Origin::kWorld;
}

}  // namespace hwffd
