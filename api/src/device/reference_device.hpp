#pragma once

#include <memory>

#include "hwffd/device/device.hpp"

namespace hwffd {

/// Eq. (1) in double precision: positions by LatticeEvaluator, derivatives by the oracle.
std::unique_ptr<Device> reference_device();

}  // namespace hwffd
