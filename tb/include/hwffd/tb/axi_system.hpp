#pragma once

#include <cstdint>
#include <string>

#include "hwffd/cores/axi_core.hpp"
#include "hwffd/driver.hpp"
#include "hwffd/register_port.hpp"
#include "hwffd/tb/axi_checker.hpp"
#include "hwffd/tb/axi_memory.hpp"
#include "hwffd/tb/axil_driver.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::tb {

/// How much of a bus was used. Its clocks are those from the first data beat on R or W to the last
/// one, both included; a beat is one that was taken. Descriptors count, as they are beats on R.
struct BusUtilisation {
  std::uint64_t read_beats = 0, write_beats = 0;
  std::uint64_t first = 0, last = 0;              ///< clocks of the first and the last beat
  std::uint64_t first_write = 0, last_write = 0;  ///< the same of W alone

  std::uint64_t clocks() const { return read_beats + write_beats == 0 ? 0 : last - first + 1; }
  double read() const { return share(read_beats); }
  double write() const { return share(write_beats); }
  /// Of both directions together: 1 would be a beat on R and one on W in every clock.
  double both() const { return (read() + write()) / 2; }

 private:
  double share(std::uint64_t beats) const {
    return clocks() == 0 ? 0 : static_cast<double>(beats) / static_cast<double>(clocks());
  }
};

/// A Verilated `hwffd_axi` between a memory and a register port, both buses under a checker, so
/// that `hwffd::Driver` runs on it as on hardware. Time passes in `run` and while the port works;
/// an access takes as many clocks as its bus needs.
class AxiSystem final : public RegisterPort {
 public:
  /// Most outstanding bursts each way, and their longest (defaults of hwffd_axi).
  static constexpr std::uint64_t kOutstanding = 8;
  static constexpr std::uint64_t kMaxBurst = 256;
  /// Clocks after which an access that has no response throws.
  std::uint64_t access_limit = 100'000;

  /// Comes up out of reset. The core must outlive the system.
  AxiSystem(cores::AxiCore& core, std::uint64_t seed);

  AxiMemory memory;
  AxiChecker bus_checker;
  AxiChecker register_checker{true};

  /// Throws RegisterError where the response is an error, std::runtime_error where there is none.
  std::uint32_t read32(std::uint32_t offset) override;
  void write32(std::uint32_t offset, std::uint32_t value) override;
  /// The response code of such an access, of those bytes.
  std::uint8_t try_write(std::uint32_t offset, std::uint32_t value, std::uint8_t strobe = 0xF);
  /// Puts a write on its way, behind those before it, without waiting for its response.
  void post_write(std::uint32_t offset, std::uint32_t value, std::uint8_t strobe = 0xF);

  /// What the checker lets through: what software put into the registers.
  void allow(const AddressWindow& read, const AddressWindow& write);
  /// awprot and arprot of the accesses that follow.
  void protect(std::uint8_t prot) { registers_.protect(prot); }
  /// One throttle for each of the ten channels, by name; "mixed" draws a name for each.
  void set_throttles(const std::string& name);

  /// aresetn low for that many edges: on both sides nothing is left.
  void reset(unsigned clocks = 4);
  void run(std::uint64_t clocks);
  /// Memory and checker forget what is open, and what was reported: after a slave that did not do
  /// as it should, and the soft reset that gave it up.
  void forget_bus();
  bool interrupt() const { return core_.interrupt(); }
  std::uint64_t cycle() const { return cycle_; }
  const BusUtilisation& utilisation() const { return utilisation_; }
  /// The bus as it was last sampled.
  const cores::AxiPins& bus() const { return bus_; }

  /// Empty if no rule was broken on either bus and nothing is open, else the reports.
  std::string faults();

 private:
  void step();
  void count();
  template <class Responses>
  const AxiLiteResponse& answer(const Responses& responses, std::size_t number);

  cores::AxiCore& core_;
  Random random_;
  AxiLiteDriver registers_;
  cores::AxiLitePins register_pins_;
  cores::AxiPins bus_;
  bool in_reset_ = false;
  bool clearing_ = false;  // from a soft reset until STATUS says that it is over
  std::uint64_t cycle_ = 0;
  BusUtilisation utilisation_;
};

}  // namespace hwffd::tb
