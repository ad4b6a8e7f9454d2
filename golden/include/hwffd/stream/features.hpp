// Made from rtl/bus/registers.csv by tools/tables/registers.py; changes here are lost.
#pragma once

#include <cstdint>

namespace hwffd::model {

/// What a core has, as the register FEATURES says it.
enum Feature : std::uint32_t {
  kPagesFeature = 1U << 0,
  kLargeFeature = 1U << 1,
  kFourthFeature = 1U << 2,
  kSpansFeature = 1U << 3,
  kGridsFeature = 1U << 4,
  kPackedFeature = 1U << 5,
  kMarksFeature = 1U << 6,
  kResidentFeature = 1U << 8,
  kInterleavedFeature = 1U << 9,
  kDerivativesFeature = 1U << 10,
  kDeterminantFeature = 1U << 11,
  kHalvesFeature = 1U << 12,
};

}  // namespace hwffd::model
