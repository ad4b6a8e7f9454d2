#pragma once

#include <verilated.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

namespace hwffd::tb {

/// Owns one Verilated design: its context, its clock, its cycle count and a watchdog.
///
/// `Clk` names the clock port, e.g. `&Vunit::clk`. Registers start from random values drawn from
/// the seed, so that a missing reset shows. One `tick` is: settle, rising edge, falling edge;
/// inputs set before it are seen by that edge, outputs read after it are the registers' new values.
template <class VDut>
class Sim {
 public:
  /// @param seed      start values of the registers
  /// @param watchdog  cycles after which `tick` throws
  explicit Sim(std::uint64_t seed, std::uint64_t watchdog = ~std::uint64_t{0})
      : context_(std::make_unique<VerilatedContext>()), watchdog_(watchdog) {
    context_->randReset(2);
    context_->randSeed(static_cast<int>(seed % 0x7fffffff) + 1);
    Verilated::threadContextp(context_.get());  // where ports that are public are entered
    dut_ = std::make_unique<VDut>(context_.get());
    dut_->clk = 0;
    dut_->eval();
  }
  ~Sim() {
    Verilated::threadContextp(context_.get());  // final() uses the last one made
    dut_->final();
  }
  Sim(const Sim&) = delete;
  Sim& operator=(const Sim&) = delete;

  VDut* operator->() { return dut_.get(); }
  VDut& dut() { return *dut_; }
  std::uint64_t cycle() const { return cycle_; }

  /// One clock period. Throws std::runtime_error when the watchdog runs out.
  void tick() {
    if (++cycle_ > watchdog_) {
      throw std::runtime_error("watchdog: no end after " + std::to_string(watchdog_) + " cycles");
    }
    dut_->clk = 1;
    dut_->eval();
    dut_->clk = 0;
    dut_->eval();
  }

 private:
  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<VDut> dut_;
  std::uint64_t cycle_ = 0;
  std::uint64_t watchdog_;
};

}  // namespace hwffd::tb
