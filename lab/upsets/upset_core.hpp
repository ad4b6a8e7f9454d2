#pragma once

#include <verilated.h>

#include <memory>

#include "hwffd/cores/axi_core.hpp"
#include "hwffd/cores/stream_core.hpp"
#include "hwffd/cores/verilated_pins.hpp"
#include "upset.hpp"

namespace hwffd::upsets {

/// A Verilated core of netlist.py, whose clock asks a trigger which bit to invert.
template <class VDut>
class UpsetDut {
 public:
  UpsetDut(std::uint64_t seed, Trigger& trigger)
      : context_(std::make_unique<VerilatedContext>()), trigger_(trigger) {
    context_->randReset(2);
    context_->randSeed(static_cast<int>(seed % 0x7fffffff) + 1);
    dut_ = std::make_unique<VDut>(context_.get());
    dut_->aclk = 0;
    dut_->aresetn = 0;
    for (auto& word : dut_->upset_register.m_storage) word = 0;
    for (auto& word : dut_->upset_memory.m_storage) word = 0;
    dut_->upset_address = 0;
    dut_->upset_bit = 0;
    dut_->eval();
  }
  ~UpsetDut() {
    Verilated::threadContextp(context_.get());
    dut_->final();
  }
  UpsetDut(const UpsetDut&) = delete;
  UpsetDut& operator=(const UpsetDut&) = delete;

  VDut& dut() { return *dut_; }
  const VDut& dut() const { return *dut_; }

  void settle() {
    dut_->aclk = 0;
    dut_->eval();
  }
  void clock() {
    if (dut_->aclk != 0) settle();
    const Upset* upset = trigger_.due();
    if (upset != nullptr) {
      invert(*upset);
      settle();
    }
    dut_->aclk = 1;
    dut_->eval();
    if (upset != nullptr) invert(*upset);
  }

 private:
  /// Sets the pins, and clears them again.
  void invert(const Upset& upset) {
    constexpr std::size_t kWord = 32;
    const std::uint32_t mask = std::uint32_t{1} << upset.place % kWord;
    if (upset.memory) {
      dut_->upset_address = upset.word;
      dut_->upset_bit = upset.bit;
      dut_->upset_memory[upset.place / kWord] ^= mask;
    } else {
      dut_->upset_register[upset.place / kWord] ^= mask;
    }
  }

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<VDut> dut_;
  Trigger& trigger_;
};

template <class VDut>
class UpsetStreamCore final : public cores::StreamCore {
 public:
  UpsetStreamCore(std::uint64_t seed, Trigger& trigger) : dut_(seed, trigger) {
    dut_.dut().grid_stop_i = 0;
  }

  void drive_reset(bool asserted) override { dut_.dut().aresetn = asserted ? 0 : 1; }
  void drive_input(bool valid, const Beat& beat) override {
    VDut& dut = dut_.dut();
    dut.s_axis_tvalid = valid;
    for (std::size_t i = 0; i < beat.words.size(); ++i) dut.s_axis_tdata[i] = beat.words[i];
    dut.s_axis_tlast = beat.last;
  }
  void drive_output_ready(bool ready) override { dut_.dut().m_axis_tready = ready; }
  void settle() override { dut_.settle(); }
  void clock() override { dut_.clock(); }
  bool input_ready() const override { return dut_.dut().s_axis_tready != 0; }
  bool output_valid() const override { return dut_.dut().m_axis_tvalid != 0; }
  Beat output() const override {
    Beat beat;
    for (std::size_t i = 0; i < beat.words.size(); ++i) beat.words[i] = dut_.dut().m_axis_tdata[i];
    beat.last = dut_.dut().m_axis_tlast != 0;
    return beat;
  }
  /// Beyond those of event_o a bit for upset_o.
  std::uint32_t events() const override {
    return dut_.dut().event_o | std::uint32_t{dut_.dut().upset_o} << kStreamEvents;
  }
  bool idle() const override { return dut_.dut().idle_o != 0; }

 private:
  UpsetDut<VDut> dut_;
};

template <class VDut>
class UpsetAxiCore final : public cores::AxiCore {
 public:
  UpsetAxiCore(std::uint64_t seed, Trigger& trigger) : dut_(seed, trigger) {}

  void exchange(bool in_reset, cores::AxiLitePins& registers, cores::AxiPins& bus) override {
    dut_.dut().aresetn = in_reset ? 0 : 1;
    cores::drive_pins(dut_.dut(), registers.master);
    cores::drive_pins(dut_.dut(), bus);
    dut_.settle();
    cores::sample_pins(dut_.dut(), registers.slave);
    cores::sample_pins(dut_.dut(), bus);
  }
  void clock() override { dut_.clock(); }
  bool interrupt() const override { return dut_.dut().irq_o != 0; }

 private:
  UpsetDut<VDut> dut_;
};

}  // namespace hwffd::upsets
