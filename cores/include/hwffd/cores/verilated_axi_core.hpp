#pragma once

#include <verilated.h>

#include <cstdint>
#include <memory>
#include <string>

#include "hwffd/cores/axi_core.hpp"
#include "hwffd/cores/waveform.hpp"

namespace hwffd::cores {

/// `AxiCore` over any Verilated `hwffd_axi`: `VDut` is the class that Verilator made.
template <class VDut>
class VerilatedAxiCore final : public AxiCore {
 public:
  /// @param seed  start values of the registers, so that a missing reset shows
  explicit VerilatedAxiCore(std::uint64_t seed) : context_(std::make_unique<VerilatedContext>()) {
    context_->randReset(2);
    context_->randSeed(static_cast<int>(seed % 0x7fffffff) + 1);
    dut_ = std::make_unique<VDut>(context_.get());
    dut_->aclk = 0;
    dut_->aresetn = 0;
    dut_->eval();
  }
  ~VerilatedAxiCore() override {
    Verilated::threadContextp(context_.get());  // final() uses the last one made
    dut_->final();
  }
  VerilatedAxiCore(const VerilatedAxiCore&) = delete;
  VerilatedAxiCore& operator=(const VerilatedAxiCore&) = delete;

  void exchange(bool in_reset, AxiLitePins& registers, AxiPins& bus) override {
    dut_->aresetn = in_reset ? 0 : 1;
    drive(registers.master);
    drive(bus);
    dut_->aclk = 0;
    dut_->eval();
    sample(registers.slave);
    sample(bus);
  }
  void clock() override {
    waveform_.half_clock();
    dut_->aclk = 1;
    dut_->eval();
    waveform_.half_clock();
  }
  bool interrupt() const override { return dut_->irq_o != 0; }

  /// Writes a waveform from now on; throws as Waveform::open does.
  void trace(const std::string& path) { waveform_.open(*dut_, path); }

 private:
  void drive(const AxiLiteMasterPins& pins) {
    dut_->s_axil_awvalid = pins.awvalid;
    dut_->s_axil_awaddr = pins.awaddr & kAddressMask;
    dut_->s_axil_awprot = pins.awprot;
    dut_->s_axil_wvalid = pins.wvalid;
    dut_->s_axil_wdata = pins.wdata;
    dut_->s_axil_wstrb = pins.wstrb;
    dut_->s_axil_bready = pins.bready;
    dut_->s_axil_arvalid = pins.arvalid;
    dut_->s_axil_araddr = pins.araddr & kAddressMask;
    dut_->s_axil_arprot = pins.arprot;
    dut_->s_axil_rready = pins.rready;
  }
  void drive(const AxiPins& bus) {
    dut_->m_axi_arready = bus.ar.ready;
    dut_->m_axi_rvalid = bus.r.valid;
    for (std::size_t i = 0; i < bus.r.data.size(); ++i) dut_->m_axi_rdata[i] = bus.r.data[i];
    dut_->m_axi_rresp = bus.r.response;
    dut_->m_axi_rlast = bus.r.last;
    dut_->m_axi_awready = bus.aw.ready;
    dut_->m_axi_wready = bus.w.ready;
    dut_->m_axi_bvalid = bus.b.valid;
    dut_->m_axi_bresp = bus.b.response;
  }

  void sample(AxiLiteSlavePins& pins) const {
    pins.awready = dut_->s_axil_awready != 0;
    pins.wready = dut_->s_axil_wready != 0;
    pins.bvalid = dut_->s_axil_bvalid != 0;
    pins.bresp = dut_->s_axil_bresp;
    pins.arready = dut_->s_axil_arready != 0;
    pins.rvalid = dut_->s_axil_rvalid != 0;
    pins.rdata = dut_->s_axil_rdata;
    pins.rresp = dut_->s_axil_rresp;
  }
  void sample(AxiPins& bus) const {
    bus.ar.valid = dut_->m_axi_arvalid != 0;
    bus.ar.address = dut_->m_axi_araddr;
    bus.ar.len = dut_->m_axi_arlen;
    bus.ar.size = dut_->m_axi_arsize;
    bus.ar.burst = dut_->m_axi_arburst;
    bus.ar.cache = dut_->m_axi_arcache;
    bus.ar.prot = dut_->m_axi_arprot;
    bus.r.ready = dut_->m_axi_rready != 0;
    bus.aw.valid = dut_->m_axi_awvalid != 0;
    bus.aw.address = dut_->m_axi_awaddr;
    bus.aw.len = dut_->m_axi_awlen;
    bus.aw.size = dut_->m_axi_awsize;
    bus.aw.burst = dut_->m_axi_awburst;
    bus.aw.cache = dut_->m_axi_awcache;
    bus.aw.prot = dut_->m_axi_awprot;
    bus.w.valid = dut_->m_axi_wvalid != 0;
    for (std::size_t i = 0; i < bus.w.data.size(); ++i) bus.w.data[i] = dut_->m_axi_wdata[i];
    bus.w.strobe = dut_->m_axi_wstrb;
    bus.w.last = dut_->m_axi_wlast != 0;
    bus.b.ready = dut_->m_axi_bready != 0;
  }

  static constexpr std::uint32_t kAddressMask = 0xFFF;

  std::unique_ptr<VerilatedContext> context_;
  std::unique_ptr<VDut> dut_;
  Waveform waveform_;
};

}  // namespace hwffd::cores
