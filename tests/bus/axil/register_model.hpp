#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "hwffd/tb/axil_driver.hpp"
#include "register_table.hpp"

namespace hwffd::test {

/// Port name (without _i, _o, ...; see below) -> value in one clock.
using PortValues = std::map<std::string, std::uint64_t>;

/// The register block clock by clock, as docs/registers.md says: plain and slow. It is told which
/// write and which read act in a clock; where they come from is the bus's affair.
class RegisterModel {
 public:
  struct Answer {
    std::uint8_t code = 0;
    std::uint32_t data = 0;
  };
  struct Answers {
    Answer write;
    Answer read;
  };

  RegisterModel() { reset(); }

  void reset();
  /// One clock: inputs are by their full port name. Answers count for the requests that were given.
  Answers clock(const PortValues& inputs, const std::optional<tb::AxiLiteWrite>& write,
                const std::optional<std::uint32_t>& read);
  /// The output ports, by their full names, as they are now.
  PortValues outputs() const;
  /// How often that happened since construction: "<field> set", "<field> cleared", "<field> set and
  /// cleared" (in one clock), "<start> taken", "<start> refused by <field>" (by it alone).
  std::uint64_t seen(const std::string& what) const {
    const auto it = seen_.find(what);
    return it == seen_.end() ? 0 : it->second;
  }

 private:
  struct Counter {
    std::uint64_t value = 0;
    std::uint32_t latched_high = 0;
    std::uint64_t event = 0;  // of the last clock: counted in this one
  };

  Answer do_read(const PortValues& inputs, std::uint32_t address);
  std::uint8_t code_of(const tb::AxiLiteWrite& write) const;
  std::uint32_t field_value(const PortValues& inputs, const RegisterField& field) const;
  /// Fields that a start is refused by.
  std::vector<std::string> blocks(const PortValues& inputs, const RegisterField& start) const;
  /// Returns the sticky fields that it cleared.
  std::set<std::string> store(const tb::AxiLiteWrite& write);
  void record(const PortValues& inputs, bool held, bool clear);
  void count(const PortValues& inputs, bool clear);

  std::map<std::string, std::uint32_t> fields_;  // by path: rw, w1s, w1c, event, log; w1: pulse
  std::map<std::string, Counter> counters_;      // by port
  unsigned errors_ = 0;                          // of the last clock, as a counter's event
  bool irq_ = false;
  bool located_ = false;  // the record has an address
  std::map<std::string, std::uint64_t> seen_;
};

}  // namespace hwffd::test
