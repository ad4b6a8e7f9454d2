#pragma once

#include <verilated.h>

#include <cstdint>

namespace hwffd::cores {

/// A Verilated model in a context of its own: `VDut` is the class that Verilator made.
template <class VDut>
class VerilatedModel {
 public:
  /// @param seed  start values of the registers, so that a missing reset shows
  explicit VerilatedModel(std::uint64_t seed) : dut_(start(context_, seed)) {}
  ~VerilatedModel() {
    Verilated::threadContextp(&context_);  // final() uses the last one made
    dut_.final();
  }
  VerilatedModel(const VerilatedModel&) = delete;
  VerilatedModel& operator=(const VerilatedModel&) = delete;

  VDut* operator->() { return &dut_; }
  const VDut* operator->() const { return &dut_; }
  VDut& operator*() { return dut_; }
  const VDut& operator*() const { return dut_; }
  VerilatedContext& context() const { return context_; }

 private:
  static VerilatedContext* start(VerilatedContext& context, std::uint64_t seed) {
    context.randReset(2);
    context.randSeed(static_cast<int>(seed % 0x7fffffff) + 1);
    return &context;
  }

  mutable VerilatedContext context_;
  VDut dut_;
};

}  // namespace hwffd::cores
