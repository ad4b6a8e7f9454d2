#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/cores/stream_loop.hpp"
#include "hwffd/stream/beat.hpp"

namespace hwffd::tb {

using cores::StreamPins;

/// The rules of AXI4-Stream on the core's side of both streams:
/// * a valid output stays valid, with the same data and last, until it is accepted;
/// * output valid and input ready are low in reset, from the edge on that first samples it;
/// * output valid is still low in the first cycle after reset.
///
/// Every violation is reported with its cycle, the first 20 in words.
class ProtocolChecker {
 public:
  static constexpr std::size_t kMaxReports = 20;

  /// @param reset_edges  rising edges in reset after which the reset rules hold
  explicit ProtocolChecker(unsigned reset_edges = 1) : reset_edges_(reset_edges) {}

  /// One cycle's samples.
  void observe(const StreamPins& pins, std::uint64_t cycle) {
    const bool cleared = edges_seen_ >= reset_edges_;
    if (pins.in_reset || edges_seen_ != 0) {
      observe_reset(pins, cycle, cleared);
      return;
    }
    if (waiting_ && (!pins.output_valid || pins.output != held_)) report_change(pins, cycle);
    waiting_ = pins.output_valid && !pins.output_ready;
    if (waiting_) held_ = pins.output;
  }

  /// Adds a violation that somebody else found.
  void report(std::uint64_t cycle, const std::string& what);

  std::uint64_t violations() const { return violations_; }
  const std::vector<std::string>& reports() const { return reports_; }

 private:
  void observe_reset(const StreamPins& pins, std::uint64_t cycle, bool cleared);
  void report_change(const StreamPins& pins, std::uint64_t cycle);

  unsigned reset_edges_;
  unsigned edges_seen_ = 0;  // in the current reset; kept for the first cycle after it
  bool waiting_ = false;
  Beat held_;
  std::uint64_t violations_ = 0;
  std::vector<std::string> reports_;
};

}  // namespace hwffd::tb
