#pragma once

#include <array>
#include <string>

#include "hwffd/device/device.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd {

/// The functions of s, t and u as words for a row; the uniform B-spline in its watertight form.
/// @param device  its name, for the message
/// @throws Error where the row takes only functions that sum to one, or has the B-spline wired in,
///   and these are others
std::array<AxisWords, 3> function_words(const Device::Blending& blending, const WordCodec& codec,
                                        const Configuration& row, const std::string& device);

/// Where the stream's origin lies for functions.
Normalization::Origin origin_for(const Device::Blending& blending);

}  // namespace hwffd
