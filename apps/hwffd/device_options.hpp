#pragma once

#include "hwffd/device/device.hpp"

namespace CLI {
class App;
}

namespace hwffd::command {

/// Adds the options --device, --org and --format to a command.
void add_device_options(CLI::App& app, DeviceChoice& choice);

}  // namespace hwffd::command
