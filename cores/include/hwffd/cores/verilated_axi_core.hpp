#pragma once

#include <verilated.h>

#include <cstdint>
#include <string>

#include "hwffd/cores/axi_core.hpp"
#include "hwffd/cores/verilated_model.hpp"
#include "hwffd/cores/verilated_pins.hpp"
#include "hwffd/cores/waveform.hpp"

namespace hwffd::cores {

/// `AxiCore` over any Verilated `hwffd_axi`: `VDut` is the class that Verilator made.
template <class VDut>
class VerilatedAxiCore final : public AxiCore {
 public:
  /// @param seed         start values of the registers, so that a missing reset shows
  /// @param reset_edges  as AxiCore says
  explicit VerilatedAxiCore(std::uint64_t seed, unsigned reset_edges = 1)
      : dut_(seed), reset_edges_(reset_edges) {
    dut_->aclk = 0;
    dut_->aresetn = 0;
    dut_->eval();
  }

  void exchange(bool in_reset, AxiLitePins& registers, AxiPins& bus) override {
    dut_->aresetn = in_reset ? 0 : 1;
    drive_pins(*dut_, registers.master);
    drive_pins(*dut_, bus);
    dut_->aclk = 0;
    dut_->eval();
    sample_pins(*dut_, registers.slave);
    sample_pins(*dut_, bus);
    bus.ar.cache = dut_->m_axi_arcache;
    bus.ar.prot = dut_->m_axi_arprot;
    bus.aw.cache = dut_->m_axi_awcache;
    bus.aw.prot = dut_->m_axi_awprot;
    bus.ar.id = dut_->m_axi_arid;
    bus.aw.id = dut_->m_axi_awid;
  }
  void clock() override {
    waveform_.half_clock();
    dut_->aclk = 1;
    dut_->eval();
    waveform_.half_clock();
  }
  bool interrupt() const override { return dut_->irq_o != 0; }
  unsigned data_width() const override { return 8 * sizeof(dut_->m_axi_wdata); }
  unsigned reset_edges() const override { return reset_edges_; }
  const VDut& dut() const { return *dut_; }

  /// Writes a waveform from now on; throws as Waveform::open does.
  void trace(const std::string& path) { waveform_.open(*dut_, path); }

 private:
  VerilatedModel<VDut> dut_;
  unsigned reset_edges_;
  Waveform waveform_;
};

}  // namespace hwffd::cores
