#pragma once

#include "hwffd/cores/axi_pins.hpp"
#include "hwffd/cores/axil_pins.hpp"

namespace hwffd::cores {

/// The pins of a Verilated `hwffd_axi`, whatever its configuration.
///
/// A cycle is: `exchange`, `clock`.
class AxiCore {
 public:
  virtual ~AxiCore() = default;

  /// Drives aresetn (asserted = low), the master's side of the registers and the slave's side of
  /// the bus, settles, and reads the other sides into `registers` and `bus`.
  virtual void exchange(bool in_reset, AxiLitePins& registers, AxiPins& bus) = 0;
  /// One rising edge of aclk.
  virtual void clock() = 0;
  /// irq_o.
  virtual bool interrupt() const = 0;
  /// Bits of data of the bus.
  virtual unsigned data_width() const { return 128; }
  /// Edges of aclk with aresetn low until the core is in reset: two with RESET_REGISTER.
  virtual unsigned reset_edges() const { return 1; }
};

}  // namespace hwffd::cores
