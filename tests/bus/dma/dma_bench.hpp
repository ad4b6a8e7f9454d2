#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <vector>

#include "dma_core.hpp"
#include "hwffd/tb/axi_checker.hpp"
#include "hwffd/tb/axi_memory.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/throttle.hpp"
#include "named.hpp"

namespace hwffd::test {

constexpr std::uint64_t kBeat = cores::kAxiBeatBytes;

/// Where the tests put a ring of 8, packets and results, unless they say otherwise.
constexpr std::uint64_t kRing = 0x7000;
constexpr std::uint64_t kPackets = 0x100000;
constexpr std::uint64_t kArea = 0x900000;

/// Codes of errors (docs/interface.md).
enum DmaCode : unsigned {
  kZeroLength = 1,
  kMisaligned = 2,
  kWraps = 3,
  kOutside = 4,
  kFlags = 5,
  kSlaveError = 6,
  kDecodeError = 7,
  kBadRing = 8
};

struct Descriptor {
  std::uint64_t address = 0;
  std::uint32_t length = 0;
  std::uint32_t flags = 0;
};

/// A descriptor that is refused, and the code of it.
struct BadDescriptor {
  Descriptor descriptor;
  unsigned code;
};
/// One of each kind, where kReadable is the window.
constexpr tb::AxiMemory::Range kReadable{kRing, kPackets + 0xfffff};
const std::vector<BadDescriptor>& bad_descriptors();

constexpr tb::AxiMemory::Range kEverywhere{0, ~std::uint64_t{0}}, kNowhere{1, 0};

/// An engine, a memory on its bus, a sink for packets and a source of results.
///
/// Both ends check what they see: packets against what the descriptors named, in order; memory
/// against the results offered.
class DmaBench {
 public:
  DmaBench(const DmaSize& size, std::uint64_t seed);

  DmaControls controls;
  DmaStatus status;
  tb::AxiMemory memory;
  tb::AxiChecker checker;
  tb::Throttle packet_throttle = tb::Throttle::always();
  tb::Throttle result_throttle = tb::Throttle::always();

  const DmaSize& size() const { return size_; }
  /// Blocks of 16 bytes in a beat of the bus, at least one: they are read, and fail, together.
  std::uint64_t blocks() const { return std::max<std::uint64_t>(1, size_.width / 128); }
  std::uint64_t cycle() const { return cycle_; }
  tb::Random& random() { return random_; }
  /// The bus as it was in the last clock.
  const cores::AxiPins& bus() const { return bus_; }

  /// One throttle for each of the five channels, by name.
  void set_bus_throttle(const std::string& name);
  /// The window that the controls set, for the checker too.
  void set_windows(tb::AxiMemory::Range read, tb::AxiMemory::Range write);

  void reset(unsigned cycles = 3);
  void step();
  void run(std::uint64_t cycles);
  /// Runs until idle_o; false after `limit` cycles.
  bool run_until_idle(std::uint64_t limit = 200000);
  template <class Condition>
  bool run_until(Condition condition, std::uint64_t limit = 200000) {
    if (testing::Test::HasFailure()) limit = 0;  // what has failed ends soon
    for (std::uint64_t i = 0; i < limit; ++i) {
      if (condition()) return true;
      step();
    }
    return condition();
  }
  /// Until nothing moves; false where the ring is then not stopped, but waits for its head.
  bool run_until_stopped(std::uint64_t limit = 200000);
  /// Until an error was reported; until so many results of the area are counted.
  bool run_until_error(std::uint64_t limit = 200000);
  bool run_until_counted(std::uint64_t results, std::uint64_t limit = 200000);

  // ---- ring and packets
  void place_ring(std::uint64_t base, unsigned entries_log2);
  /// Writes the descriptor at the software's end of the ring (the head moves with `ring_doorbell`).
  void put_descriptor(const Descriptor& descriptor);
  std::uint64_t descriptor_address(unsigned index) const {
    return controls.ring_base + index * kBeat;
  }
  /// Fills memory with random beats there, appends a descriptor for them, expects the packet.
  void put_packet(std::uint64_t address, std::uint64_t beats);
  void expect_packet(std::uint64_t address, std::uint64_t beats);
  /// `count` packets of `beats` each, the first at kPackets, one in each 4 KB.
  void put_packets(std::uint64_t count, std::uint64_t beats);
  void ring_doorbell() { controls.ring_head = software_head_; }
  void start_ring();
  /// The same until all of it has been read; false if it does not end.
  bool run_ring();
  std::uint16_t software_head() const { return software_head_; }
  void set_software_head(std::uint16_t head) { software_head_ = head; }
  /// Packet beats that have come, and that should.
  const std::vector<Beat>& packets() const { return packets_; }
  const std::vector<Beat>& expected() const { return expected_; }
  /// Empty if what came is what was expected and not nothing, else the first difference.
  std::string packet_difference() const;
  void forget_packets();

  // ---- results
  void start_results(std::uint64_t base, std::uint32_t bytes);
  /// The same with the next step.
  void place_area(std::uint64_t base, std::uint32_t bytes);
  /// Queues results; the last of every `packet` beats is marked, or none where it is 0.
  void offer_results(std::uint64_t count, std::uint64_t packet = 0);
  std::uint64_t results_waiting() const { return results_.size(); }
  const std::vector<Beat>& accepted_results() const { return accepted_; }
  void forget_results();
  /// Chance that a result which is offered has a mark; it is that of `marked_results`.
  void mark_results(double chance) { mark_chance_ = chance; }
  const std::vector<bool>& marked_results() const { return marked_; }
  /// How many of `count` beats from `first` on lie in memory at `base`, counted up to the first
  /// wrong.
  std::uint64_t results_in_memory(std::uint64_t base, std::uint64_t first,
                                  std::uint64_t count) const;

  // ---- errors
  const std::vector<DmaError>& read_errors() const { return read_errors_; }
  const std::vector<DmaError>& write_errors() const { return write_errors_; }
  void forget_read_errors() { read_errors_.clear(); }
  void forget_write_errors() { write_errors_.clear(); }

  /// Empty if no rule was broken on the bus and on the packet stream, else the reports.
  std::string faults();

  // ---- verdicts

  /// No difference of packets, no fault; and the ring ended there.
  testing::AssertionResult exact();
  testing::AssertionResult exact(unsigned tail);
  /// The same of a start that ends, and waits for its head.
  testing::AssertionResult reads(unsigned tail);
  /// A start reads up to descriptor `index` and reports this one only, with that code.
  testing::AssertionResult refuses(unsigned index, unsigned code);
  /// So many results are counted and lie in memory there, from number `first` on; no fault.
  testing::AssertionResult writes(std::uint64_t base, std::uint64_t first, std::uint64_t count);

  // ---- soft reset

  /// Of the engine and of the evaluator, whose results are gone, until clearing_o is seen.
  void begin_soft_reset();
  bool end_soft_reset(std::uint64_t limit = 200000) {
    return run_until([&] { return !status.clearing && status.idle; }, limit);
  }

 private:
  void observe();
  void note(const DmaError& error, std::vector<DmaError>& errors);

  DmaSize size_;
  tb::Random random_;
  std::unique_ptr<DmaCore> core_;
  std::uint64_t cycle_ = 0;
  cores::AxiPins bus_;
  DmaStream packet_pins_, result_pins_;
  bool windows_settled_ = false;  ///< they were those in the clock before
  bool was_clearing_ = false, was_reset_ = false;
  bool packet_waits_ = false;
  Beat packet_held_;
  std::uint64_t stream_faults_ = 0;
  std::uint64_t fault_pulses_ = 0, bus_errors_ = 0, halted_early_ = 0, halted_cleared_ = 0;
  std::uint64_t upsets_ = 0;
  bool both_ran_ = false;  ///< in the clock before
  std::uint16_t software_head_ = 0;
  std::vector<Beat> packets_, expected_, accepted_;
  std::deque<Beat> results_;
  double mark_chance_ = 0;
  std::vector<bool> marked_;  // of accepted_
  std::vector<DmaError> read_errors_, write_errors_;
};

/// Whether there was one error, with that code and address.
testing::AssertionResult only(const std::vector<DmaError>& errors, unsigned code,
                              std::uint64_t address);

/// For tests over the sizes that are built.
class PerDmaSize : public testing::TestWithParam<DmaSize> {};

#define HWFFD_FOR_EACH_DMA_SIZE(suite) \
  INSTANTIATE_TEST_SUITE_P(Dma, suite, testing::ValuesIn(dma_sizes()), by_name)

/// The same with memory latency and throttles for all ends by name.
void set_all_throttles(DmaBench& bench, const std::string& bus, const std::string& stream);

}  // namespace hwffd::test
