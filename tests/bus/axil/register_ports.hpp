#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>

#include "Vaxil_registers.h"

namespace hwffd::test {

/// A port of the Verilated block, by its name: docs/registers.md section 3.
struct InputPort {
  unsigned width;
  std::function<void(Vaxil_registers&, std::uint64_t)> drive;
};
using OutputPort = std::function<std::uint64_t(const Vaxil_registers&)>;

/// The ports to the hardware.
const std::map<std::string, InputPort>& hardware_inputs();
const std::map<std::string, OutputPort>& hardware_outputs();

}  // namespace hwffd::test
