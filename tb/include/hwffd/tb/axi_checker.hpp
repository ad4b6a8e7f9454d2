#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "hwffd/cores/axi_pins.hpp"
#include "hwffd/cores/axil_pins.hpp"

namespace hwffd::tb {

/// In so many clocks after that of an error response an address may still be raised.
constexpr std::uint64_t kAxiAddressesAfterError = 3;
/// Of a hardened core so many of each channel may come later: its guard has taken them already.
constexpr unsigned kAxiAddressesInGuard = 2;

/// What a bus without IDs must keep (AXI4 specification, IHI 0022), and what this project promises
/// beyond it (marked "promise"): on AXI4 the master, on AXI4-Lite the slave.
enum class AxiRule : std::size_t {
  kStable,    ///< valid fell or payload changed before ready, on any channel
  kReset,     ///< valid in reset, or in the first cycle after it; promise: ready too
  kShape,     ///< size not the bus's, burst not INCR, 16 bytes not wholly written (promise); EXOKAY
  kAligned,   ///< address not a multiple of 16 (promise)
  kBoundary,  ///< burst crosses 4 KB, or the end of the address space
  kLength,    ///< burst longer than the limit set, or than 256 beats
  kWriteLast,    ///< WLAST not exactly on the last beat of its burst
  kReadLast,     ///< RLAST not exactly on the last beat of its burst
  kUnasked,      ///< read data or write response without a request that is due
  kUnanswered,   ///< at the end: a request without all of its answers, or data without address
  kOutstanding,  ///< more bursts outstanding than the limit set
  kWindow,       ///< a byte outside the window (promise)
  kStall,        ///< write data paused inside a burst (promise; at 256 bits for two clocks)
  kReadyFell,    ///< RREADY or BREADY fell outside reset (promise: room is kept; at 256 bits RREADY
                 ///< may fall for the clock after a beat)
  kAfterError,   ///< an address was raised later than promised after an error response (promise)
  kCount
};

const char* axi_rule_name(AxiRule rule);

/// Watches one bus, both sides: AXI4, or AXI4-Lite, of which the rules of bursts and windows, of
/// stalls and of errors do not hold, but a reset must have been seen.
class AxiChecker {
 public:
  static constexpr std::size_t kMaxReports = 20;

  /// A burst's is in 16 bytes; the bus's width in bits.
  struct Limits {
    std::uint64_t burst = 256;
    std::uint64_t reads = 64;
    std::uint64_t writes = 64;
    std::uint64_t read_first = 0, read_last = ~std::uint64_t{0};
    std::uint64_t write_first = 0, write_last = ~std::uint64_t{0};
    std::uint64_t width = 128;
    std::uint64_t reset_edges = 1;
  };
  explicit AxiChecker(bool lite = false) : lite_(lite) {}
  void set_limits(const Limits& limits) { limits_ = limits; }

  /// One cycle. In reset nothing but kReset is looked at; outstanding bursts are forgotten.
  void observe(const cores::AxiPins& pins, std::uint64_t cycle, bool in_reset);
  void observe(const cores::AxiLitePins& pins, std::uint64_t cycle);
  /// After the last cycle: everything has been answered.
  void finish(std::uint64_t cycle);
  /// Begins anew, limits apart: after a rule was broken on purpose.
  void forget() {
    const Limits limits = limits_;
    const bool hardened = hardened_;
    *this = AxiChecker(lite_);
    limits_ = limits;
    hardened_ = hardened;
  }
  /// Addresses may be raised again after an error response.
  void restarted() {
    error_seen_ = false;
    late_reads_ = late_writes_ = 0;
  }
  /// From now on both readies may fall (soft reset).
  void allow_ready_to_fall(bool allowed) { ready_may_fall_ = allowed; }
  /// The core has a guard: addresses may come later after an error, and beats of which no byte is
  /// written in a soft reset.
  void set_hardened(bool hardened) { hardened_ = hardened; }

  std::uint64_t violations() const;
  std::uint64_t violations(AxiRule rule) const { return counts_[static_cast<std::size_t>(rule)]; }
  const std::vector<std::string>& reports() const { return reports_; }
  std::uint64_t most_reads() const { return most_reads_; }
  std::uint64_t most_writes() const { return most_writes_; }

 private:
  void report(AxiRule rule, std::uint64_t cycle, const std::string& what);
  void check_reset(const cores::AxiPins& pins, std::uint64_t cycle, bool in_reset);
  void check_lite_reset(const cores::AxiPins& pins, std::uint64_t cycle, bool in_reset);
  void check_stable(const cores::AxiPins& pins, std::uint64_t cycle);
  void check_address(const cores::AxiAddressChannel& channel, bool read, std::uint64_t cycle);
  void check_errors(const cores::AxiPins& pins, std::uint64_t cycle);
  void check_write_data(const cores::AxiPins& pins, std::uint64_t cycle);
  bool errs(const cores::AxiPins& pins);
  void observe_reads(const cores::AxiPins& pins, std::uint64_t cycle);
  void observe_writes(const cores::AxiPins& pins, std::uint64_t cycle);
  void pair_writes(std::uint64_t cycle);

  bool lite_;
  Limits limits_;
  bool reset_seen_ = false;
  std::uint64_t edges_in_reset_ = 0;  // before this one
  bool before_known_ = false;
  cores::AxiPins before_;
  bool ready_may_fall_ = false;
  bool hardened_ = false;
  bool error_seen_ = false;
  std::uint64_t error_cycle_ = 0;
  unsigned late_reads_ = 0, late_writes_ = 0;  // addresses that came later
  bool half_error_ = false;                    // of the first half of 16 bytes, at 64 bits
  std::uint64_t pause_ = 0;                    // clocks without write data inside a burst
  std::deque<std::uint64_t> reads_;            // beats still to come, a burst each
  std::deque<std::uint64_t> writes_;           // lengths of addresses without their data
  std::deque<std::uint64_t> data_;             // lengths of data without their address
  std::uint64_t data_beats_ = 0;               // of the burst under way
  std::uint64_t unanswered_ = 0;               // writes with address and data
  std::uint64_t most_reads_ = 0, most_writes_ = 0;
  std::array<std::uint64_t, static_cast<std::size_t>(AxiRule::kCount)> counts_{};
  std::vector<std::string> reports_;
};

}  // namespace hwffd::tb
