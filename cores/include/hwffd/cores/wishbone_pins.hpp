#pragma once

#include <cstdint>

namespace hwffd::cores {

/// What the master of a Wishbone bus drives: 32 bits of data.
struct WishboneMasterPins {
  bool cyc = false;
  bool stb = false;
  bool we = false;
  std::uint32_t adr = 0;  ///< of a byte
  std::uint32_t dat = 0;
  std::uint8_t sel = 0;

  bool asks() const { return cyc && stb; }
};

/// What its slave drives.
struct WishboneSlavePins {
  bool ack = false;
  bool err = false;
  std::uint32_t dat = 0;
};

/// Pins of a bus on the ports `s_wb_*` of a Verilated module.
template <class VDut>
void drive_pins(VDut& dut, const WishboneMasterPins& pins) {
  constexpr std::uint32_t kAddressMask = 0xFFF;
  dut.s_wb_cyc = pins.cyc;
  dut.s_wb_stb = pins.stb;
  dut.s_wb_we = pins.we;
  dut.s_wb_adr = pins.adr & kAddressMask;
  dut.s_wb_dat_w = pins.dat;
  dut.s_wb_sel = pins.sel;
}

template <class VDut>
void sample_pins(const VDut& dut, WishboneSlavePins& pins) {
  pins.ack = dut.s_wb_ack != 0;
  pins.err = dut.s_wb_err != 0;
  pins.dat = dut.s_wb_dat_r;
}

}  // namespace hwffd::cores
