#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/stream/beat.hpp"
#include "hwffd/tb/test_identity.hpp"

namespace hwffd::tb {

/// Compares received beats with expected ones, in order, by ==. Reports the first 20 failures in
/// words and counts them all; a run that checked nothing does not pass.
class Scoreboard {
 public:
  static constexpr std::size_t kMaxReports = 20;

  explicit Scoreboard(TestIdentity test) : test_(std::move(test)) {}

  /// Appends expected beats.
  void expect(std::vector<Beat> beats);
  /// Compares the next beat. True when it was expected.
  bool receive(const Beat& got, std::uint64_t cycle) {
    if (next_ < queue_.size() && queue_[next_] == got) {
      ++next_;
      ++checked_;
      return true;
    }
    fail(got, cycle);
    return false;
  }
  /// After a reset: forgets what is outstanding. Beats are numbered from 0 again, and `finish`
  /// wants at least one beat checked from here on.
  void restart();
  /// Ends the test: all expected beats checked, at least one, none missing, none extra, none
  /// wrong. Returns ok().
  bool finish();

  /// Beats expected but not yet received.
  std::size_t outstanding() const { return queue_.size() - next_; }
  std::uint64_t expected() const { return expected_; }  ///< less those dropped by `restart`
  std::uint64_t checked() const { return checked_; }    ///< compared, right or wrong
  std::uint64_t mismatches() const { return mismatches_; }
  std::uint64_t extra() const { return extra_; }  ///< received when none was expected
  bool ok() const { return mismatches_ == 0 && extra_ == 0 && end_reports_.empty(); }
  /// True when 20 failures are reported: going on would tell nothing new.
  bool full() const { return mismatches_ + extra_ >= kMaxReports; }

  /// The reports; those of `finish` at the end.
  std::vector<std::string> reports() const;
  const TestIdentity& test() const { return test_; }

 private:
  void fail(const Beat& got, std::uint64_t cycle);

  TestIdentity test_;
  std::vector<Beat> queue_;
  std::size_t next_ = 0;
  std::uint64_t expected_ = 0;
  std::uint64_t checked_ = 0;
  std::uint64_t checked_before_restart_ = 0;
  std::uint64_t received_before_restart_ = 0;
  std::uint64_t mismatches_ = 0;
  std::uint64_t extra_ = 0;
  std::vector<std::string> reports_;
  std::vector<std::string> end_reports_;
};

}  // namespace hwffd::tb
