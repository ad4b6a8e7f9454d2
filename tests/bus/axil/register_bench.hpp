#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "Vaxil_slave.h"
#include "Vbus_registers.h"
#include "hwffd/driver.hpp"
#include "hwffd/tb/axi_checker.hpp"
#include "hwffd/tb/axil_driver.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"
#include "register_model.hpp"
#include "register_ports.hpp"

namespace hwffd::test {

/// The register block behind ffd_axil_slave, between an AxiLiteDriver, an AxiChecker and the model:
/// in every clock all output ports, and every response as it appears, are compared.
///
/// Which write and which read act in a clock is seen on the bus: their response appears at the end
/// of it (docs/registers.md section 3).
class RegisterBench {
 public:
  explicit RegisterBench(std::uint64_t seed, const std::string& throttles = "always");
  /// Nothing may be wrong in the end.
  ~RegisterBench();

  /// That many clocks in reset; drops all requests.
  void reset(unsigned clocks = 2);
  void step();
  void steps(unsigned clocks);
  /// Steps until every request is answered. A failure after `limit` clocks.
  void run(std::uint64_t limit = 200'000);

  /// One request, to its response.
  std::uint8_t write(std::uint32_t address, std::uint32_t data, std::uint8_t strobe = 0xF);
  RegisterModel::Answer read(std::uint32_t address);
  /// By name: whole register, must be OKAY.
  std::uint32_t get(const std::string& reg);
  void set(const std::string& reg, std::uint32_t data);
  /// By path: the write that sets that bit alone.
  void set_bit(const std::string& path);
  /// All registers in order, without those of access counter or log.
  std::vector<std::uint32_t> snapshot();

  /// The ports to the hardware, and what is on the inputs, kept until changed.
  const HardwarePorts& input_ports() const { return input_ports_; }
  const HardwarePorts& output_ports() const { return output_ports_; }
  PortValues& inputs() { return inputs_; }
  /// One clock in which that input has this value, and is 0 again.
  void pulse(const std::string& port, std::uint64_t value = 1);
  /// Called at the start of every clock, to change them.
  void each_clock(std::function<void()> callback) { each_clock_ = std::move(callback); }
  std::uint64_t output(const std::string& port) const { return output_ports_.at(port).read(); }
  std::uint64_t clock() const { return sim_.cycle(); }
  /// Clocks in which that output was high.
  std::uint64_t high_clocks(const std::string& port) const { return high_.at(port); }

  tb::AxiLiteDriver& driver() { return driver_; }
  const RegisterModel& model() const { return model_; }
  /// Whether an address of a write came before its data, and data before its address; what lay on
  /// the channel of addresses while none was offered.
  bool address_first() const { return most_ahead_ > 0; }
  bool data_first() const { return least_ahead_ < 0; }
  const std::set<std::uint32_t>& idle_addresses() const { return idle_addresses_; }
  /// Resets that came over something under way: "write" and "read" are such that had acted, and
  /// whose responses nobody had taken; "address without data".
  std::uint64_t resets_of(const std::string& what) { return resets_of_[what]; }
  std::uint64_t compared() const { return compared_; }
  const std::vector<std::string>& failures() const { return failures_; }

 private:
  void drive(const cores::AxiLiteMasterPins& pins);
  void follow(const cores::AxiLiteSlavePins& slave);
  void compare_outputs();
  void fail(const std::string& what);

  tb::Sim<Vbus_registers> sim_;
  tb::Sim<Vaxil_slave> slave_;
  tb::AxiLiteDriver driver_;
  tb::AxiChecker checker_{true};
  RegisterModel model_;
  HardwarePorts input_ports_, output_ports_;
  PortValues inputs_;
  std::function<void()> each_clock_;
  std::map<std::string, std::uint64_t> high_;
  bool in_reset_ = true;
  // The clock before.
  bool known_ = false;  // it was in reset, or after one
  bool was_in_reset_ = false;
  PortValues was_inputs_;
  cores::AxiLiteSlavePins was_slave_;
  cores::AxiLiteMasterPins was_master_;
  std::vector<tb::AxiLiteWrite> dropped_writes_;
  std::vector<std::uint32_t> dropped_reads_;
  std::size_t acted_writes_ = 0;
  std::size_t acted_reads_ = 0;
  int ahead_ = 0, most_ahead_ = 0, least_ahead_ = 0;  // addresses taken before their data
  std::set<std::uint32_t> idle_addresses_;
  std::map<std::string, std::uint64_t> resets_of_;
  std::uint64_t compared_ = 0;
  std::vector<std::string> failures_;
};

/// The bench as the way of software to the registers.
class BenchPort final : public RegisterPort {
 public:
  explicit BenchPort(RegisterBench& bench) : bench_(bench) {}
  std::uint32_t read32(std::uint32_t offset) override;
  void write32(std::uint32_t offset, std::uint32_t value) override;

 private:
  RegisterBench& bench_;
};

}  // namespace hwffd::test
