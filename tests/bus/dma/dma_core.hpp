#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "hwffd/cores/axi_pins.hpp"
#include "hwffd/stream/beat.hpp"

namespace hwffd::test {

/// Inputs of `ffd_dma_engine` that come from registers.
struct DmaControls {
  bool rst = false;
  bool soft_reset = false;
  std::uint64_t read_first = 0, read_last = ~std::uint64_t{0};
  bool ring_start = false;
  std::uint64_t ring_base = 0;
  unsigned ring_entries_log2 = 4;
  std::uint16_t ring_head = 0;
  std::uint64_t write_first = 0, write_last = ~std::uint64_t{0};
  bool result_start = false;
  std::uint64_t result_base = 0;
  std::uint32_t result_size = 0;
  bool windows_locked = false;
};

struct DmaError {
  bool valid = false;
  unsigned code = 0;
  std::uint64_t address = 0;
};

/// Outputs of `ffd_dma_engine` that go to registers.
struct DmaStatus {
  bool clearing = false, idle = false, halted = false, fault = false;
  unsigned timeout = 0;  ///< a bit a channel: AR, R, AW, W, B
  std::uint16_t ring_tail = 0;
  bool ring_running = false, result_running = false, result_busy = false, result_overflow = false;
  std::uint32_t result_count = 0;
  bool ring_marked = false, result_marked = false;  ///< interrupts of a descriptor, of a packet
  DmaError read_error, write_error;
  unsigned upset = 0;  ///< of a hardened engine: what was repaired or refused
};

/// Valid, ready and beat of one stream.
struct DmaStream {
  bool valid = false;
  bool ready = false;
  Beat beat;
  bool mark = false;  ///< of results
};

/// The pins of a Verilated engine, whatever its size.
class DmaCore {
 public:
  virtual ~DmaCore() = default;
  /// Drives the controls, the bus's slave side, the results and ready of the packets; settles;
  /// reads the rest into the same structures.
  virtual void exchange(const DmaControls& controls, DmaStatus& status, cores::AxiPins& bus,
                        DmaStream& packets, DmaStream& results) = 0;
  virtual void clock() = 0;
};

/// Parameters that a build has (tests/bus/dma/CMakeLists.txt).
struct DmaSize {
  std::string name;
  std::uint64_t max_burst, depth, outstanding;
  std::uint64_t timeout = 0;
  std::uint64_t width = 128;  ///< of the bus
  bool hardened = false;
  std::uint64_t descriptors = 4;  ///< fetched ahead of packets
  /// Clocks that a burst is in the guard of a hardened engine.
  std::uint64_t guard() const { return hardened ? 4 : 0; }
};
inline void PrintTo(const DmaSize& size, std::ostream* out) { *out << size.name; }
const std::vector<DmaSize>& dma_sizes();
/// The one with the least bursts, depths and queues.
const DmaSize& small_dma_size();
/// Those with a time-out, of each width.
const std::vector<DmaSize>& watched_dma_sizes();
/// The one with flags of descriptors and marks of results.
const DmaSize& marked_dma_size();
std::unique_ptr<DmaCore> make_dma_core(const std::string& name, std::uint64_t seed);

}  // namespace hwffd::test
