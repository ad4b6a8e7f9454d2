#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/stream/beat.hpp"

namespace hwffd::tb {

/// Watches a stream and collects its accepted beats, each with its clock.
class StreamMonitor {
 public:
  /// One cycle's samples. True when a beat was transferred.
  bool observe(bool valid, bool ready, const Beat& beat, std::uint64_t cycle) {
    if (!valid || !ready) return false;
    ++count_;
    if (record_) {
      beats_.push_back(beat);
      clocks_.push_back(cycle);
    }
    return true;
  }

  /// Forgets the beats and their clocks.
  void clear();
  /// Makes room for that many more beats, so that nothing is allocated while the clock runs.
  void reserve(std::size_t more);
  /// Whether beats and clocks are kept (the default); a soak of many runs does without.
  void record(bool on) { record_ = on; }

  /// Beats transferred since construction.
  std::uint64_t count() const { return count_; }
  /// The beats since the last `clear`, and the clock of each.
  const std::vector<Beat>& beats() const { return beats_; }
  const std::vector<std::uint64_t>& clocks() const { return clocks_; }

 private:
  std::vector<Beat> beats_;
  std::vector<std::uint64_t> clocks_;
  std::uint64_t count_ = 0;
  bool record_ = true;
};

}  // namespace hwffd::tb
