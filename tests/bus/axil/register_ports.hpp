#pragma once

#include <verilated.h>
#include <verilated_syms.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <string>

namespace hwffd::test {

/// A port of the Verilated block to the hardware, as Verilator tells of it (ports.vlt).
struct HardwarePort {
  void* data;
  std::size_t bytes;
  std::uint64_t largest;

  void drive(std::uint64_t value) const { std::memcpy(data, &value, bytes); }
  std::uint64_t read() const {
    std::uint64_t value = 0;
    std::memcpy(&value, data, bytes);
    return value;
  }
};
using HardwarePorts = std::map<std::string, HardwarePort>;

/// Those whose names end so: `_i` are the inputs, `_o` the outputs.
inline HardwarePorts hardware_ports(const VerilatedContext& context, const std::string& ending) {
  HardwarePorts ports;
  for (const auto& [text, port] : *context.scopeFind("TOP.TOP")->varsp()) {
    const std::string name = text;
    if (name.substr(name.size() - ending.size()) != ending) continue;
    ports[name] = {port.datap(), port.entSize(),
                   ~std::uint64_t{0} >> (64 - port.packed().elements())};
  }
  return ports;
}

}  // namespace hwffd::test
