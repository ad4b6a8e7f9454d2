#pragma once

#include <verilated.h>

#include <string>
#include <vector>

#include "hwffd/cores/evaluator_core.hpp"
#include "hwffd/cores/verilated_model.hpp"
#include "hwffd/cores/verilated_signals.hpp"

namespace hwffd::cores {

/// `EvaluatorCore` over any Verilated `ffd_bench_evaluator`.
template <class VDut>
class VerilatedEvaluatorCore final : public EvaluatorCore {
 public:
  /// @param seed  start values of the registers, so that a missing reset shows
  explicit VerilatedEvaluatorCore(std::uint64_t seed) : dut_(seed) {
    dut_->rst = 1;
    dut_->load_i = 0;
    dut_->write_i = 0;
    dut_->s_vertex_valid = 0;
    dut_->m_result_ready = 0;
  }

  void drive_reset(bool asserted) override { dut_->rst = asserted ? 1 : 0; }

  void load(int axis, int address, int shift, const std::array<std::uint32_t, 4>& words) override {
    dut_->load_i = 1;
    dut_->load_axis_i = static_cast<CData>(axis);
    dut_->load_address_i = static_cast<CData>(address);
    dut_->load_shift_i = static_cast<CData>(shift);
    for (int i = 0; i < 4; ++i) dut_->load_words_i[i] = words[i];
    settle();
    clock();
    dut_->load_i = 0;
  }
  void write(std::uint8_t support, int index, const std::uint32_t* xyz, int exponent) override {
    dut_->write_i = 1;
    dut_->write_support_i = support;
    dut_->write_index_i = static_cast<CData>(index);
    for (int i = 0; i < 3; ++i) dut_->write_words_i[i] = xyz[i];
    dut_->write_exponent_i = static_cast<SData>(exponent & 0x3FF);
    settle();
    clock();
    dut_->write_i = 0;
  }

  void drive_vertex(bool valid, const Vertex& vertex) override {
    dut_->s_vertex_valid = valid ? 1 : 0;
    for (int i = 0; i < 3; ++i) dut_->s_vertex_words[i] = vertex.words[i];
    dut_->s_vertex_second = vertex.second;
    dut_->s_vertex_cell = vertex.cell;
    dut_->s_vertex_support = vertex.support;
    dut_->s_vertex_bank = vertex.bank;
    dut_->s_vertex_changed = vertex.changed ? 1 : 0;
    dut_->s_vertex_exponent = static_cast<SData>(vertex.exponent & 0x3FF);
    dut_->s_vertex_tag = vertex.tag;
  }
  void drive_result_ready(bool ready) override { dut_->m_result_ready = ready ? 1 : 0; }

  void settle() override {
    dut_->clk = 0;
    dut_->eval();
  }
  void clock() override {
    if (dut_->clk != 0) settle();
    dut_->clk = 1;
    dut_->eval();
  }

  bool vertex_ready() const override { return dut_->s_vertex_ready != 0; }
  bool result_valid() const override { return dut_->m_result_valid != 0; }
  Result result() const override {
    Result result;
    for (int i = 0; i < 3; ++i) result.words[i] = dut_->m_result_words[i];
    result.saturated = (dut_->m_result_flags & 1) != 0;
    result.nan = (dut_->m_result_flags & 2) != 0;
    result.tag = dut_->m_result_tag;
    for (int axis = 0; axis < 3; ++axis) {
      Derivative& along = result.along[axis];
      for (int i = 0; i < 3; ++i) along.words[i] = dut_->m_result_words[3 * (axis + 1) + i];
      along.saturated = (dut_->m_result_flags >> 2 * (axis + 1) & 1) != 0;
      along.nan = (dut_->m_result_flags >> 2 * (axis + 1) & 2) != 0;
    }
    return result;
  }
  bool evaluating() const override { return dut_->evaluating_o != 0; }

  std::vector<Probe> probes() const override {
    std::vector<Probe> probes;
    for (const Signal& signal : visible_signals(dut_.context())) {
      if (signal.bytes != 1) continue;
      probes.push_back(
          {signal.instance, signal.name, static_cast<const std::uint8_t*>(signal.data)});
    }
    return probes;
  }

 private:
  VerilatedModel<VDut> dut_;
};

}  // namespace hwffd::cores
