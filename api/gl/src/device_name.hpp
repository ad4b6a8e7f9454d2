#pragma once

#include "hwffd/device/device.hpp"

namespace hwffd::gl {

/// "model", "rtl" or "reference", perhaps with organization and format: "rtl:parallel:fx18".
/// @throws UsageError for more or empty parts
DeviceChoice parse_device(const std::string& name);

/// What the environment's HWFFD_DEVICE says; the model, a core's bits, where it says nothing.
/// @throws UsageError, which names the variable
DeviceChoice device_of_environment();

}  // namespace hwffd::gl
