#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "hwffd/cores/signal.hpp"
#include "signal_table.hpp"

namespace hwffd::web {

/// What chosen ports of a core (ports.csv) were in its last clocks.
class PortRecorder {
 public:
  static constexpr std::size_t kClocks = 4096;

  explicit PortRecorder(const SignalTable& signals) : signals_(signals) {}

  /// Records these from now on, and forgets what there is. Throws Error for an unknown one.
  void watch(const std::vector<std::string>& names);
  /// Once a clock, when the core has settled.
  void sample(std::uint64_t clock);

  /// Name -> what it was in the last clock, in hexadecimal.
  std::map<std::string, std::string> values() const;
  /// All that is recorded, as a Value Change Dump: a clock is 10 ns, and signals change with its
  /// rising edge.
  std::string vcd() const;

 private:
  struct Watched {
    std::string name;
    cores::Signal signal;
  };
  struct Sample {
    std::uint64_t clock;
    std::vector<std::uint8_t> bytes;  ///< of one signal after the other
  };

  const SignalTable& signals_;
  std::vector<Watched> watched_;
  std::deque<Sample> samples_;
};

}  // namespace hwffd::web
