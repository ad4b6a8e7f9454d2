#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "hwffd/cores/axil_pins.hpp"

namespace hwffd::tb {

/// The rules of AXI4-Lite (AMBA AXI, IHI 0022: A3.1.2 reset, A3.2.1 handshake, A3.3 dependencies,
/// B1.1 the Lite subset), of both sides:
/// * a valid stays, with its payload, until it is accepted;
/// * a response comes after its request was accepted, a write's after address and data both;
/// * one response a request: none too many, and at `finish` none too few;
/// * the response is not EXOKAY;
/// * all valids are low in reset, and still in the first cycle after it.
///
/// And of this project: all readies are low there too.
///
/// Every violation is reported with its cycle, the first 20 in words.
class AxiLiteChecker {
 public:
  static constexpr std::size_t kMaxReports = 20;

  /// One cycle's samples.
  void observe(const cores::AxiLitePins& pins, std::uint64_t cycle);
  /// Ends the test: every request must have been answered.
  void finish(std::uint64_t cycle);

  std::uint64_t violations() const { return violations_; }
  const std::vector<std::string>& reports() const { return reports_; }
  /// Responses seen since construction.
  std::uint64_t writes() const { return writes_; }
  std::uint64_t reads() const { return reads_; }

 private:
  /// One channel in one cycle: its payload in one number.
  struct Channel {
    const char* name;
    bool valid;
    bool ready;
    std::uint64_t payload;
  };
  /// A beat on offer that was not accepted.
  struct Held {
    bool waiting = false;
    std::uint64_t payload = 0;
  };

  void report(std::uint64_t cycle, const std::string& what);
  void observe_reset(const cores::AxiLitePins& pins, std::uint64_t cycle);
  void observe_order(const cores::AxiLitePins& pins, std::uint64_t cycle);

  bool cleared_ = false;   // an edge in reset was seen
  bool in_reset_ = false;  // in the cycle before
  std::array<Held, 5> held_{};
  // Accepted and not answered: addresses, data, reads.
  std::uint64_t open_aw_ = 0;
  std::uint64_t open_w_ = 0;
  std::uint64_t open_ar_ = 0;
  bool waits_b_ = false;  // the response was there in the cycle before
  bool waits_r_ = false;
  std::uint64_t writes_ = 0;
  std::uint64_t reads_ = 0;
  std::uint64_t violations_ = 0;
  std::vector<std::string> reports_;
};

}  // namespace hwffd::tb
