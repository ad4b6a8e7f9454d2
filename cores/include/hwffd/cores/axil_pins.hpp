#pragma once

#include <cstdint>

namespace hwffd::cores {

/// What the master of an AXI4-Lite bus drives: 32 bits of data.
struct AxiLiteMasterPins {
  bool awvalid = false;
  std::uint32_t awaddr = 0;
  std::uint8_t awprot = 0;
  bool wvalid = false;
  std::uint32_t wdata = 0;
  std::uint8_t wstrb = 0;
  bool bready = false;
  bool arvalid = false;
  std::uint32_t araddr = 0;
  std::uint8_t arprot = 0;
  bool rready = false;
};

/// What its slave drives.
struct AxiLiteSlavePins {
  bool awready = false;
  bool wready = false;
  bool bvalid = false;
  std::uint8_t bresp = 0;
  bool arready = false;
  bool rvalid = false;
  std::uint32_t rdata = 0;
  std::uint8_t rresp = 0;
};

/// The bus in one cycle, sampled just before the rising edge.
struct AxiLitePins {
  bool in_reset = false;
  AxiLiteMasterPins master;
  AxiLiteSlavePins slave;
};

/// Response codes.
inline constexpr std::uint8_t kOkay = 0;
inline constexpr std::uint8_t kExOkay = 1;
inline constexpr std::uint8_t kSlvErr = 2;
inline constexpr std::uint8_t kDecErr = 3;

}  // namespace hwffd::cores
