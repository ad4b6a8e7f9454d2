// Made from rtl/stream/fields.csv by tools/tables/generated_files.py; changes here are lost.
#pragma once

#include <cstdint>

namespace hwffd {

// Status bits of a result, in its word 3.
constexpr std::uint32_t kStatusSaturated = 1U << 16;  ///< a coordinate did not fit its word
constexpr std::uint32_t kStatusClamped = 1U << 17;    ///< a coordinate was outside and is clamped
constexpr std::uint32_t kStatusNan = 1U << 18;        ///< a coordinate is not a number
constexpr std::uint32_t kStatusOutside = 1U << 19;    ///< the cell is not one of the lattice
constexpr std::uint32_t kStatusTruncated = 1U << 20;  ///< its packet ended too early
constexpr std::uint32_t kStatusUnloaded = 1U << 21;   ///< coefficients or lattice were never loaded
constexpr std::uint32_t kStatusFolded = 1U << 22;     ///< det J is not positive

}  // namespace hwffd
