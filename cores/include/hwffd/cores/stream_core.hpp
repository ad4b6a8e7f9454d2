#pragma once

#include <cstdint>
#include <vector>

#include "hwffd/cores/signal.hpp"
#include "hwffd/stream/beat.hpp"
#include "hwffd/stream/events.hpp"

namespace hwffd::cores {

/// A packet since reset and its beat, both from 0.
struct EventPlace {
  std::uint32_t packet = 0, beat = 0;
};

/// The pins of a Verilated `hwffd_stream`, whatever its configuration, or of a `hwffd_scatter`.
///
/// A cycle is: drive the inputs, `settle`, read ready and valid, `clock`.
class StreamCore {
 public:
  virtual ~StreamCore() = default;

  /// Drives aresetn (asserted = low).
  virtual void drive_reset(bool asserted) = 0;
  /// Drives s_axis_tvalid, _tdata and _tlast.
  virtual void drive_input(bool valid, const Beat& beat) = 0;
  /// Drives m_axis_tready.
  virtual void drive_output_ready(bool ready) = 0;
  /// Drives grid_stop_i, which is low before. A core without grids has none.
  virtual void drive_grid_stop(bool /*stop*/) {}

  /// Lowers aclk and settles the combinational paths.
  virtual void settle() = 0;
  /// One rising edge of aclk. The falling edge is the next `settle`, or the next `clock`.
  virtual void clock() = 0;

  virtual bool input_ready() const = 0;   ///< s_axis_tready
  virtual bool output_valid() const = 0;  ///< m_axis_tvalid
  virtual Beat output() const = 0;        ///< m_axis_tdata, _tlast and _tuser
  /// event_o: bit n is a pulse of event n. A core without events has none.
  virtual std::uint32_t events() const { return 0; }
  /// second_o: bit 0 for a second vertex that left, bit 1 for its event kSaturated.
  virtual std::uint32_t second() const { return 0; }
  /// Where the events of this clock come from: event_packet_o and event_beat_o.
  virtual EventPlace event_place() const { return {}; }
  /// wait_o: bit 0 for what vertices inside still read, bit 1 for room; bit 2 is 0.
  virtual std::uint32_t waits() const { return 0; }
  /// upset_o.
  virtual bool upset() const { return false; }
  /// idle_o.
  virtual bool idle() const = 0;
  /// What its build has made visible inside.
  virtual std::vector<Signal> signals() const { return {}; }
};

}  // namespace hwffd::cores
