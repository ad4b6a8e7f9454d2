#pragma once

#include <verilated.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/cores/verilated_model.hpp"
#include "hwffd/cores/verilated_signals.hpp"
#include "hwffd/cores/waveform.hpp"
#include "hwffd/stream/beat.hpp"

namespace hwffd::cores {

/// Whether a Verilated class has a pin upset_o.
template <class VDut, class = void>
constexpr bool kHasUpset = false;
template <class VDut>
constexpr bool kHasUpset<VDut, std::void_t<decltype(std::declval<VDut>().upset_o)>> = true;

/// Whether it has a pin grid_stop_i.
template <class VDut, class = void>
constexpr bool kHasGridStop = false;
template <class VDut>
constexpr bool kHasGridStop<VDut, std::void_t<decltype(std::declval<VDut>().grid_stop_i)>> = true;

/// Whether it has a pin second_o.
template <class VDut, class = void>
constexpr bool kHasSecond = false;
template <class VDut>
constexpr bool kHasSecond<VDut, std::void_t<decltype(std::declval<VDut>().second_o)>> = true;

/// `StreamCore` over any Verilated `hwffd_stream`, `hwffd_scatter` or `hwffd_adjoint`: `VDut` is
/// the class that Verilator made.
///
/// Starts with the clock low, in reset, nothing offered and nothing taken.
template <class VDut>
class VerilatedStreamCore final : public StreamCore {
 public:
  /// @param seed  start values of the registers, so that a missing reset shows
  explicit VerilatedStreamCore(std::uint64_t seed) : dut_(seed) {
    dut_->aclk = 0;
    dut_->aresetn = 0;
    dut_->s_axis_tvalid = 0;
    dut_->m_axis_tready = 0;
    drive_grid_stop(false);
    dut_->eval();
  }

  void drive_reset(bool asserted) override { dut_->aresetn = asserted ? 0 : 1; }
  void drive_input(bool valid, const Beat& beat) override {
    dut_->s_axis_tvalid = valid ? 1 : 0;
    for (std::size_t i = 0; i < beat.words.size(); ++i) dut_->s_axis_tdata[i] = beat.words[i];
    dut_->s_axis_tlast = beat.last ? 1 : 0;
  }
  void drive_output_ready(bool ready) override { dut_->m_axis_tready = ready ? 1 : 0; }
  void drive_grid_stop(bool stop) override {
    if constexpr (kHasGridStop<VDut>) dut_->grid_stop_i = stop ? 1 : 0;
  }

  void settle() override {
    dut_->aclk = 0;
    dut_->eval();
  }
  void clock() override {
    if (dut_->aclk != 0) settle();
    waveform_.half_clock();
    dut_->aclk = 1;
    dut_->eval();
    waveform_.half_clock();
  }

  /// Writes a waveform from now on; throws as Waveform::open does.
  void trace(const std::string& path) { waveform_.open(*dut_, path); }

  bool input_ready() const override { return dut_->s_axis_tready != 0; }
  bool output_valid() const override { return dut_->m_axis_tvalid != 0; }
  Beat output() const override {
    Beat beat;
    for (std::size_t i = 0; i < beat.words.size(); ++i) beat.words[i] = dut_->m_axis_tdata[i];
    beat.last = dut_->m_axis_tlast != 0;
    beat.user = dut_->m_axis_tuser != 0;
    return beat;
  }
  std::uint32_t events() const override { return dut_->event_o; }
  std::uint32_t second() const override {
    if constexpr (kHasSecond<VDut>) {
      return dut_->second_o;
    } else {
      return 0;
    }
  }
  EventPlace event_place() const override { return {dut_->event_packet_o, dut_->event_beat_o}; }
  std::uint32_t waits() const override { return dut_->wait_o; }
  bool upset() const override {
    if constexpr (kHasUpset<VDut>) {
      return dut_->upset_o != 0;
    } else {
      return false;
    }
  }
  bool idle() const override { return dut_->idle_o != 0; }
  std::vector<Signal> signals() const override { return visible_signals(dut_.context()); }

 private:
  VerilatedModel<VDut> dut_;
  Waveform waveform_;
};

}  // namespace hwffd::cores
