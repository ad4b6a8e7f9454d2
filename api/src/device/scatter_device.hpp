#pragma once

#include <memory>

#include "hwffd/device/device.hpp"

namespace hwffd {

/// The simulated core that adds gradients up: it has their transpose, and evaluates nothing.
/// @throws std::invalid_argument where there is none
std::unique_ptr<Device> scatter_device(bool rows);

}  // namespace hwffd
