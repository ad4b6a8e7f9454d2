#pragma once

#include <array>
#include <cstdint>

namespace hwffd::cores {

/// 16 bytes, what the DMA counts in: byte 0 is the lowest of word 0.
using AxiData = std::array<std::uint32_t, 4>;

constexpr std::uint64_t kAxiBeatBytes = 16;

/// One beat of a bus of up to 256 bits, of which a narrower one uses the lowest words.
using AxiBusData = std::array<std::uint32_t, 8>;

enum AxiResponse : std::uint8_t { kAxiOkay = 0, kAxiExOkay = 1, kAxiSlverr = 2, kAxiDecerr = 3 };

/// AR or AW.
struct AxiAddressChannel {
  bool valid = false;
  bool ready = false;
  std::uint64_t address = 0;
  std::uint8_t len = 0;    ///< beats - 1
  std::uint8_t size = 4;   ///< log2 of the bytes of a beat
  std::uint8_t burst = 1;  ///< 1 is INCR
  std::uint8_t cache = 0;
  std::uint8_t prot = 0;
  std::uint16_t id = 0;
};

/// R.
struct AxiReadChannel {
  bool valid = false;
  bool ready = false;
  AxiBusData data{};
  std::uint8_t response = kAxiOkay;
  bool last = false;
};

/// W.
struct AxiWriteChannel {
  bool valid = false;
  bool ready = false;
  AxiBusData data{};
  std::uint32_t strobe = 0xffff;
  bool last = false;
};

/// B.
struct AxiResponseChannel {
  bool valid = false;
  bool ready = false;
  std::uint8_t response = kAxiOkay;
};

/// All five channels of a bus without IDs in one cycle, sampled just before the rising edge.
struct AxiPins {
  AxiAddressChannel ar;
  AxiReadChannel r;
  AxiAddressChannel aw;
  AxiWriteChannel w;
  AxiResponseChannel b;
};

}  // namespace hwffd::cores
