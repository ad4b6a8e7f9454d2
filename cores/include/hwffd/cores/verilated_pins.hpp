#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "hwffd/cores/axi_pins.hpp"
#include "hwffd/cores/axil_pins.hpp"

/// Pins of a bus on the ports of a Verilated module: `s_axil_*` and `m_axi_*`.
namespace hwffd::cores {

/// Data of a bus on a port of 64, 128 or 256 bits.
template <class Port>
void put_data(Port& port, const AxiBusData& data) {
  if constexpr (std::is_integral_v<Port>) {
    port = data[0] | std::uint64_t{data[1]} << 32;
  } else {
    for (std::size_t i = 0; i < sizeof(Port) / sizeof(data[0]); ++i) port[i] = data[i];
  }
}
template <class Port>
AxiBusData get_data(const Port& port) {
  AxiBusData data{};
  if constexpr (std::is_integral_v<Port>) {
    data[0] = static_cast<std::uint32_t>(port);
    data[1] = static_cast<std::uint32_t>(port >> 32);
  } else {
    for (std::size_t i = 0; i < sizeof(Port) / sizeof(data[0]); ++i) data[i] = port[i];
  }
  return data;
}

template <class VDut>
void drive_pins(VDut& dut, const AxiLiteMasterPins& pins) {
  constexpr std::uint32_t kAddressMask = 0xFFF;
  dut.s_axil_awvalid = pins.awvalid;
  dut.s_axil_awaddr = pins.awaddr & kAddressMask;
  dut.s_axil_awprot = pins.awprot;
  dut.s_axil_wvalid = pins.wvalid;
  dut.s_axil_wdata = pins.wdata;
  dut.s_axil_wstrb = pins.wstrb;
  dut.s_axil_bready = pins.bready;
  dut.s_axil_arvalid = pins.arvalid;
  dut.s_axil_araddr = pins.araddr & kAddressMask;
  dut.s_axil_arprot = pins.arprot;
  dut.s_axil_rready = pins.rready;
}

template <class VDut>
void sample_pins(const VDut& dut, AxiLiteSlavePins& pins) {
  pins.awready = dut.s_axil_awready != 0;
  pins.wready = dut.s_axil_wready != 0;
  pins.bvalid = dut.s_axil_bvalid != 0;
  pins.bresp = dut.s_axil_bresp;
  pins.arready = dut.s_axil_arready != 0;
  pins.rvalid = dut.s_axil_rvalid != 0;
  pins.rdata = dut.s_axil_rdata;
  pins.rresp = dut.s_axil_rresp;
}

template <class VDut>
void drive_pins(VDut& dut, const AxiPins& bus) {
  dut.m_axi_arready = bus.ar.ready;
  dut.m_axi_rvalid = bus.r.valid;
  put_data(dut.m_axi_rdata, bus.r.data);
  dut.m_axi_rresp = bus.r.response;
  dut.m_axi_rlast = bus.r.last;
  dut.m_axi_awready = bus.aw.ready;
  dut.m_axi_wready = bus.w.ready;
  dut.m_axi_bvalid = bus.b.valid;
  dut.m_axi_bresp = bus.b.response;
}

/// All but cache and prot, which are constants of the top module.
template <class VDut>
void sample_pins(const VDut& dut, AxiPins& bus) {
  bus.ar.valid = dut.m_axi_arvalid != 0;
  bus.ar.address = dut.m_axi_araddr;
  bus.ar.len = dut.m_axi_arlen;
  bus.ar.size = dut.m_axi_arsize;
  bus.ar.burst = dut.m_axi_arburst;
  bus.r.ready = dut.m_axi_rready != 0;
  bus.aw.valid = dut.m_axi_awvalid != 0;
  bus.aw.address = dut.m_axi_awaddr;
  bus.aw.len = dut.m_axi_awlen;
  bus.aw.size = dut.m_axi_awsize;
  bus.aw.burst = dut.m_axi_awburst;
  bus.w.valid = dut.m_axi_wvalid != 0;
  bus.w.data = get_data(dut.m_axi_wdata);
  bus.w.strobe = dut.m_axi_wstrb;
  bus.w.last = dut.m_axi_wlast != 0;
  bus.b.ready = dut.m_axi_bready != 0;
}

}  // namespace hwffd::cores
