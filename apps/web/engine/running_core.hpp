#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/cores/stream_loop.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::web {

/// What came back for commands, and when.
struct Answers {
  std::vector<Beat> beats;
  std::uint64_t clocks = 0;  ///< from the first command until the last result
  std::uint64_t first = 0;   ///< the clock of the first result, counted from the first command
};

/// The simulated core of a row, clock by clock, with a bit that can be made to stick.
class RunningCore {
 public:
  /// Just out of reset.
  explicit RunningCore(const Configuration& row);

  /// Forgets what is inside and what is loaded.
  void reset();
  /// The first half of a clock, in which a beat is offered where there is one and a result is taken
  /// where there is one: the pins, and all inside, before the rising edge.
  const cores::StreamPins& settle(const Beat* offered);
  /// The rising edge.
  void edge();
  /// Sends commands and takes their results.
  /// @throws Error if no beat moves for a million clocks
  Answers run(const std::vector<Beat>& commands, std::size_t results);

  /// Whether bit 24 of x, in the register in front of the last one, sticks at 1.
  void set_fault(bool on) { fault_ = on; }
  bool fault() const { return fault_; }

  std::uint64_t clocks() const { return loop_.clocks(); }
  const cores::StreamCore& core() const { return *core_; }

 private:
  std::string name_;
  std::unique_ptr<cores::StreamCore> core_;
  cores::StreamLoop loop_;
  cores::Signal stuck_;
  bool fault_ = false;
};

}  // namespace hwffd::web
