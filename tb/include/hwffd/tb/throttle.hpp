#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/tb/random.hpp"

namespace hwffd::tb {

/// Decides each cycle whether one side of a stream is willing: the source to offer a beat, or the
/// sink to take one. A value type without virtual calls, for it is asked in every cycle.
class Throttle {
 public:
  /// Inclusive range of the length of a run, in cycles; at least 1.
  struct Length {
    std::uint64_t least;
    std::uint64_t most;
  };

  /// Willing in every cycle.
  static Throttle always();
  /// Unwilling in every k-th cycle, k >= 2.
  static Throttle gaps(std::uint64_t k);
  /// Willing in every k-th cycle only, k >= 2.
  static Throttle sparse(std::uint64_t k);
  /// Willing with probability p in each cycle, 0 < p <= 1.
  static Throttle bernoulli(double p, std::uint64_t seed);
  /// Random runs, willing and unwilling in turn.
  static Throttle runs(Length willing, Length unwilling, std::uint64_t seed);
  /// Willing for `clocks`, at least 1, then unwilling for so many, and so on.
  static Throttle shut_after(std::uint64_t clocks, std::uint64_t unwilling) {
    return runs({clocks, clocks}, {unwilling, unwilling}, 1);
  }

  /// Asked once a cycle.
  bool willing() {
    if (kind_ == Kind::kRuns) {
      if (left_ == 0) turn();
      --left_;
      return on_;
    }
    return kind_ == Kind::kAlways || random_.chance(probability_);
  }

 private:
  enum class Kind { kAlways, kBernoulli, kRuns };

  Throttle(Kind kind, std::uint64_t seed) : kind_(kind), random_(seed) {}
  void turn();

  Kind kind_;
  Random random_;
  double probability_ = 1.0;
  Length on_length_{1, 1};
  Length off_length_{1, 1};
  std::uint64_t left_ = 0;
  bool on_ = false;
};

/// The names that `make_throttle` knows, for the matrix of source and sink throttles: `always`,
/// `gaps` (every 4th cycle off), `sparse` (every 4th cycle on), `bernoulli` (p = 1/2), `bursts`
/// (runs of 1 to 16 cycles), `long_stall` (pauses of 200 to 500 cycles after 100 to 300 willing).
const std::vector<std::string>& throttle_names();

/// Makes the throttle of that name. Throws std::invalid_argument for an unknown name.
Throttle make_throttle(const std::string& name, std::uint64_t seed);

/// When the master or the slave of an AXI bus is willing on each channel: to offer what is its to
/// offer, or to take the rest. They are independent, so that channels come in any order.
struct AxiThrottles {
  Throttle ar = Throttle::always();
  Throttle r = Throttle::always();
  Throttle aw = Throttle::always();
  Throttle w = Throttle::always();
  Throttle b = Throttle::always();

  /// All five of that name (`throttle_names`), with seeds of their own; "mixed" draws a name for
  /// each.
  static AxiThrottles make(const std::string& name, std::uint64_t seed);
};

}  // namespace hwffd::tb
