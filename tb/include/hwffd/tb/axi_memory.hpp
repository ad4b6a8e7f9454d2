#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <unordered_map>
#include <utility>
#include <vector>

#include "hwffd/cores/axi_pins.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/throttle.hpp"

namespace hwffd::tb {

/// An AXI4 slave with 2^64 bytes, without IDs: in order, several bursts outstanding. It is as wide
/// as a beat of each burst says, up to 256 bits.
///
/// Every byte that nobody wrote is a guard byte, a hash of its address, so a byte written where it
/// should not be shows anywhere (`changed_outside`). Data of a burst is written with its last beat.
///
/// A cycle is: `drive`, settle, sample the master's pins, `observe`, clock.
class AxiMemory {
 public:
  /// Clocks from an accepted address (or last write beat) to the first answer, both included.
  struct Latency {
    std::uint64_t least = 1;
    std::uint64_t most = 1;
  };
  /// An address that was accepted. `beats` counts 16 bytes, whatever the bus, to the end of its
  /// last beat; for a write whose data has come, those written.
  struct Burst {
    std::uint64_t address;
    std::uint64_t beats;
    std::uint64_t cycle;
    std::uint8_t cache, prot;
    std::uint16_t id;
  };
  /// First and last byte.
  using Range = std::pair<std::uint64_t, std::uint64_t>;

  explicit AxiMemory(std::uint64_t seed) : random_(derive_seed(seed, 77)), seed_(seed) {}

  void set_latency(Latency latency) { latency_ = latency; }
  void set_throttles(const AxiThrottles& throttles) { throttles_ = throttles; }
  /// As the bus allows: ready of AR, AW and W comes only where valid was seen in the clock before.
  void let_ready_wait_for_valid() { ready_waits_ = true; }

  /// The beat with 16 bytes number `beat` of the read burst accepted as number `burst` from now (0
  /// the next) fails; where those are two beats, the first or the second, as `beat` is even or odd.
  void fail_read(std::uint64_t burst, std::uint64_t beat, cores::AxiResponse response);
  /// The write burst accepted as number `burst` from now fails; its data is not written.
  void fail_write(std::uint64_t burst, cores::AxiResponse response);
  /// The same of every read burst at that address.
  void fail_read_at(std::uint64_t address, std::uint64_t beat, cores::AxiResponse response);
  /// RLAST of the read burst accepted as number `burst` from now comes with beat `beat`, not with
  /// its last one; beyond that: with none.
  void misplace_last(std::uint64_t burst, std::uint64_t beat);
  /// Every read burst at that address has so many beats more, which nobody asked for, and RLAST
  /// with the last of them.
  void lengthen_read_at(std::uint64_t address, std::uint64_t beats);
  void fail_nothing();
  /// Breaks a rule of the bus: a beat of read data that nobody asked for comes while no read is
  /// open.
  void answer_unasked(cores::AxiResponse response, bool last);
  /// Breaks a rule of the bus: a write is answered when its address has come, before its data.
  void answer_before_data() { early_ = true; }
  /// As aresetn of the whole bus: what is open is forgotten, write data without its last beat too.
  void forget_open();

  std::uint8_t byte(std::uint64_t address) const;
  void set_byte(std::uint64_t address, std::uint8_t value);
  cores::AxiData beat(std::uint64_t address) const;
  void set_beat(std::uint64_t address, const cores::AxiData& data);
  /// The guard byte of that address.
  std::uint8_t guard(std::uint64_t address) const;
  /// How many bytes differ from their guard bytes outside all ranges.
  std::uint64_t changed_outside(const std::vector<Range>& ranges) const;

  /// Drives ready of AR, AW, W and all of R and B.
  void drive(cores::AxiPins& pins, std::uint64_t cycle);
  /// The pins just before the rising edge.
  void observe(const cores::AxiPins& pins, std::uint64_t cycle);

  const std::vector<Burst>& reads() const { return reads_; }
  const std::vector<Burst>& writes() const { return writes_; }
  /// Beats of the bus.
  std::uint64_t read_beats() const { return read_beats_; }
  std::uint64_t write_beats() const { return write_beats_; }
  /// Bursts accepted and not yet answered wholly, and write data without an address.
  bool quiet() const;
  /// Drops what it holds and has logged; only while it is quiet.
  void forget();

 private:
  static constexpr std::uint64_t kPage = 4096;
  static constexpr std::uint64_t kNever = ~std::uint64_t{0};
  struct Open {
    std::uint64_t address;  ///< of its first beat, a multiple of `bytes`
    std::uint64_t bytes;    ///< of a beat
    std::uint64_t beats;
    std::uint64_t due;  ///< cycle of the first answer
    std::uint64_t failing_beat;
    std::uint8_t response;
    std::uint64_t marked;  ///< the beat with RLAST
    std::size_t number;    ///< in the log
    std::uint64_t done = 0;
  };
  struct Failure {
    bool by_address;
    std::uint64_t burst;  ///< its number, or its address
    std::uint64_t beat;
    cores::AxiResponse response;
  };

  std::uint64_t due(std::uint64_t cycle) {
    return cycle + random_.between(latency_.least, latency_.most);
  }
  Open open(const cores::AxiAddressChannel& channel, std::uint64_t cycle, std::vector<Burst>& log,
            std::vector<Failure>& failures);
  void commit(std::uint64_t cycle);
  void write_beat(const Open& open, std::uint64_t beat, const cores::AxiWriteChannel& data);
  cores::AxiBusData read_beat(const Open& open) const;

  Random random_;
  std::uint64_t seed_;
  Latency latency_;
  AxiThrottles throttles_;
  bool ready_waits_ = false, early_ = false;
  bool ar_waits_ = false, aw_waits_ = false, w_waits_ = false;  // valid, and was not taken
  std::vector<Failure> failing_reads_, failing_writes_;
  std::unordered_map<std::uint64_t, std::uint64_t> misplaced_;  // of bursts by number
  std::unordered_map<std::uint64_t, std::uint64_t> surplus_;    // of bursts by address
  std::unordered_map<std::uint64_t, std::array<std::uint8_t, kPage>> pages_;

  std::deque<Open> read_queue_;
  std::deque<Open> write_queue_;   // waiting for data
  std::deque<Open> answer_queue_;  // waiting for their response
  std::deque<cores::AxiWriteChannel> data_queue_;
  std::deque<cores::AxiReadChannel> unasked_queue_;
  bool unasked_ = false;  // what R shows
  cores::AxiReadChannel r_;
  cores::AxiResponseChannel b_;
  std::vector<Burst> reads_, writes_;
  std::uint64_t read_beats_ = 0, write_beats_ = 0;
};

}  // namespace hwffd::tb
