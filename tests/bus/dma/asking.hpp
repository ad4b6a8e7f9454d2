#pragma once

#include "dma_bench.hpp"

namespace hwffd::test {

/// What a bench that is new makes of a transfer where that is the window: its code, or 0. What was
/// refused has left nothing on the bus and no half running; the error has the address.

/// A ring there, and in its first entry a packet.
unsigned ask_read(DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t ring,
                  unsigned entries_log2, std::uint64_t packet, std::uint64_t beats);

/// An area for so many results. Those that it refused go to the next one.
unsigned ask_area(DmaBench& bench, tb::AxiMemory::Range window, std::uint64_t base,
                  std::uint32_t bytes, std::uint64_t results);

/// What has been read of a ring below kPackets and of packets from there on.
struct Asked {
  std::uint64_t descriptors = 0;
  std::uint64_t beats = 0;  ///< of packets
};
Asked asked_for(const DmaBench& bench);

}  // namespace hwffd::test
