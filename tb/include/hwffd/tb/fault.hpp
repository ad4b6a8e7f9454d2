#pragma once

#include <cstdint>

#include "hwffd/stream/beat.hpp"

namespace hwffd::tb {

/// A deliberate fault in the received results, planted between the core's pins and the scoreboard
/// to prove that the scoreboard can fail.
struct Fault {
  enum class Kind {
    kNone,
    kFlip,       ///< one bit of one beat
    kDrop,       ///< one beat is lost
    kDuplicate,  ///< one beat comes twice
  };
  Kind kind = Kind::kNone;
  std::uint64_t beat = 0;  ///< which result, counted from 0 when the fault is planted
  unsigned bit = 0;        ///< 0 to 127: bit of tdata; 128: last
};

/// Applies one fault to a sequence of beats.
class FaultInjector {
 public:
  FaultInjector() = default;
  /// Throws std::invalid_argument when the bit does not exist.
  explicit FaultInjector(const Fault& fault);

  /// Passes one beat, perhaps changed; returns how often it is to be delivered: 0, 1 or 2.
  unsigned pass(Beat& beat) {
    if (fault_.kind == Fault::Kind::kNone || seen_++ != fault_.beat) return 1;
    return strike(beat);
  }
  /// Whether the fault has happened.
  bool struck() const { return struck_; }

 private:
  unsigned strike(Beat& beat);

  Fault fault_;
  std::uint64_t seen_ = 0;
  bool struck_ = false;
};

}  // namespace hwffd::tb
