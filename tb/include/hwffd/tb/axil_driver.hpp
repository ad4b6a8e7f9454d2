#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/cores/axil_pins.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/throttle.hpp"

namespace hwffd::tb {

struct AxiLiteWrite {
  std::uint32_t address = 0;
  std::uint32_t data = 0;
  std::uint8_t strobe = 0xF;
};

struct AxiLiteResponse {
  std::uint8_t code = cores::kOkay;
  std::uint32_t data = 0;   ///< 0 for a write
  std::uint64_t cycle = 0;  ///< in which it was taken
};

/// The master of an AXI4-Lite bus: a queue of writes and one of reads, each worked off in order,
/// both at once. An offered request stays, with its valid, until it is accepted; what lies on idle
/// channels is random.
///
/// Knows no pins: each cycle call `drive`, put what it gives on them, then `accept` with what was
/// sampled.
class AxiLiteDriver {
 public:
  explicit AxiLiteDriver(std::uint64_t seed, AxiThrottles throttles = {})
      : random_(seed), throttles_(throttles) {}

  /// Appends to the queues.
  void write(const AxiLiteWrite& request) { writes_.push_back(request); }
  void read(std::uint32_t address) { reads_.push_back(address); }
  void throttle(const AxiThrottles& throttles) { throttles_ = throttles; }
  /// awprot and arprot of what is offered from now on.
  void protect(std::uint8_t prot) { pins_.awprot = pins_.arprot = prot; }
  /// Drops queues, offers and responses, as a reset does.
  void clear();

  /// Decides the pins of this cycle.
  const cores::AxiLiteMasterPins& drive();
  /// Ends the cycle.
  void accept(const cores::AxiLiteSlavePins& slave, std::uint64_t cycle);

  /// Everything was sent and answered.
  bool idle() const;
  const std::vector<AxiLiteWrite>& writes() const { return writes_; }
  const std::vector<std::uint32_t>& reads() const { return reads_; }
  /// Responses, in the order of the requests. A response too many is there as well.
  const std::vector<AxiLiteResponse>& write_responses() const { return written_; }
  const std::vector<AxiLiteResponse>& read_responses() const { return read_; }

 private:
  Random random_;
  AxiThrottles throttles_;
  std::vector<AxiLiteWrite> writes_;
  std::vector<std::uint32_t> reads_;
  std::vector<AxiLiteResponse> written_;
  std::vector<AxiLiteResponse> read_;
  std::size_t next_aw_ = 0;
  std::size_t next_w_ = 0;
  std::size_t next_ar_ = 0;
  cores::AxiLiteMasterPins pins_;
};

}  // namespace hwffd::tb
