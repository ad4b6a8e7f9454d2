#pragma once

#include <deque>
#include <optional>

#include "hwffd/cores/axil_pins.hpp"
#include "hwffd/cores/wishbone_pins.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::test {

/// An access of a Wishbone master.
struct WishboneAccess {
  bool write = false;
  std::uint32_t address = 0;
  std::uint32_t data = 0;
  std::uint8_t select = 0xF;
};

/// The master of a Wishbone bus: classic standard cycles, one access after the other. It begins one
/// in a share of the clocks in which it has one, keeps it as it is until it is answered, and holds
/// cyc between two of them or not. What lies on idle lines is random.
class WishboneMaster {
 public:
  explicit WishboneMaster(std::uint64_t seed, double willing = 1)
      : random_(seed), willing_(willing) {}

  void ask(const WishboneAccess& access) { waiting_.push_back(access); }
  /// Gives up an unanswered access in that share of the clocks.
  void give_up(double share) { give_up_ = share; }
  bool idle() const { return !now_ && waiting_.empty(); }
  /// The access on the bus.
  const std::optional<WishboneAccess>& now() const { return now_; }
  std::uint64_t given_up() const { return given_up_; }

  const cores::WishboneMasterPins& drive();
  /// Ends the clock. True: the access on the bus has its answer.
  bool accept(const cores::WishboneSlavePins& slave);
  void clear();

 private:
  tb::Random random_;
  double willing_;
  double give_up_ = 0;
  std::deque<WishboneAccess> waiting_;
  std::optional<WishboneAccess> now_;
  cores::WishboneMasterPins pins_;
  std::uint64_t given_up_ = 0;
};

}  // namespace hwffd::test
