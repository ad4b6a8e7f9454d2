#pragma once

#include <cstdint>
#include <memory>

#include "hwffd/cores/axi_core_factory.hpp"
#include "hwffd/tb/axi_system.hpp"

namespace hwffd::test {

/// A Verilated hwffd_axi with a buffer of memory that its bus may reach, for programs that drive it
/// as a device.
struct SimulatedCore {
  static constexpr std::uint64_t kAddress = 0x1'4000'0000;
  static constexpr std::uint64_t kBytes = 2 << 20;
  static constexpr std::uint64_t kLatestInterrupt = 3'000'000;  // clocks

  explicit SimulatedCore(const Configuration& row)
      : core(cores::make_axi_core(row, 5)), system(*core, 5) {
    allow(kAddress);
  }
  void allow(std::uint64_t base) {
    const AddressWindow buffer{base, base + kBytes - 1};
    system.allow(buffer, buffer);
  }
  /// Whether the interrupt comes within so many clocks, which pass until it does.
  bool interrupt_within(std::uint64_t clocks) {
    constexpr std::uint64_t kStep = 100;
    for (std::uint64_t clock = 0; clock < clocks; clock += kStep) {
      system.run(kStep);
      if (system.interrupt()) return true;
    }
    return false;
  }

  std::unique_ptr<cores::AxiCore> core;
  tb::AxiSystem system;
};

}  // namespace hwffd::test
