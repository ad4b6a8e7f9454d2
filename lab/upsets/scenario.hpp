#pragma once

#include <cstdint>
#include <memory>

#include "hwffd/cores/axi_core.hpp"
#include "hwffd/cores/stream_core.hpp"
#include "hwffd/model/configuration.hpp"
#include "traffic.hpp"
#include "upset.hpp"

namespace hwffd::upsets {

/// A core and its bench, from reset on. The first traffic is that in which bits are inverted; the
/// second, without a reset in between, shows what stays behind.
class Scenario {
 public:
  virtual ~Scenario() = default;

  /// Both traffics, as far as they come.
  virtual void run(Trigger& trigger) = 0;
  /// What happened; resets the core where anything did. Nothing may be run behind it.
  virtual Verdict judge() = 0;
  /// Results compared so far.
  virtual std::uint64_t compared() const = 0;
};

/// What the scenarios share.
struct Plan {
  Plan(const Configuration& row_, std::size_t vertices, std::uint64_t seed_)
      : row(row_),
        seed(seed_),
        first(make_traffic(row_, vertices, seed_)),
        second(make_traffic(row_, 1, seed_ + 1)) {}
  const Configuration& row;
  std::uint64_t seed;
  Traffic first, second;
  std::uint64_t limit = 200'000;  ///< clocks that a traffic may take; set after the first run
};

/// Of hwffd_stream and of hwffd_axi. Core and plan must outlive it.
std::unique_ptr<Scenario> make_scenario(cores::StreamCore& core, const Plan& plan);
std::unique_ptr<Scenario> make_scenario(cores::AxiCore& core, const Plan& plan);

}  // namespace hwffd::upsets
