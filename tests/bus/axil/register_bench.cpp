#include "register_bench.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "hwffd/cores/verilated_pins.hpp"
#include "register_words.hpp"

namespace hwffd::test {

using cores::AxiLiteMasterPins;
using cores::AxiLiteSlavePins;

namespace {
constexpr std::size_t kMaxFailures = 20;
}

RegisterBench::RegisterBench(std::uint64_t seed, const std::string& throttles)
    : sim_(seed, 2'000'000),
      slave_(tb::derive_seed(seed, 3)),
      driver_(tb::derive_seed(seed, 1),
              tb::AxiThrottles::make(throttles, tb::derive_seed(seed, 2))),
      input_ports_(hardware_ports(*sim_.dut().contextp(), "_i")),
      output_ports_(hardware_ports(*sim_.dut().contextp(), "_o")) {
  for (const auto& [name, port] : input_ports_) inputs_[name] = 0;
  for (const auto& [name, port] : output_ports_) high_[name] = 0;
  reset();
}

RegisterBench::~RegisterBench() {
  checker_.finish(clock());
  for (const std::string& report : checker_.reports()) ADD_FAILURE() << report;
  for (const std::string& failure : failures_) ADD_FAILURE() << failure;
  EXPECT_GT(compared_, 0u);
}

void RegisterBench::fail(const std::string& what) {
  if (failures_.size() < kMaxFailures) {
    failures_.push_back(fmt::format("clock {}: {}", clock(), what));
  }
}

void RegisterBench::reset(unsigned clocks) {
  // A request that acted in the last clock before is still followed in the first clock of reset.
  dropped_writes_ = driver_.writes();
  dropped_reads_ = driver_.reads();
  resets_of_["write"] += acted_writes_ > driver_.write_responses().size() ? 1 : 0;
  resets_of_["read"] += acted_reads_ > driver_.read_responses().size() ? 1 : 0;
  resets_of_["address without data"] += ahead_ > 0 ? 1 : 0;
  driver_.clear();
  in_reset_ = true;
  steps(clocks);
  in_reset_ = false;
  acted_writes_ = acted_reads_ = 0;
}

/// The pins of a clock, through to the answers; the words between the two are registers' outputs.
void RegisterBench::drive(const AxiLiteMasterPins& pins) {
  auto& registers = sim_.dut();
  auto& slave = slave_.dut();
  registers.rst = in_reset_ ? 1 : 0;
  registers.eval();
  slave.rst = registers.s_clearing;
  cores::drive_pins(slave, pins);
  slave.eval();
  inputs_["error_any_i"] = inputs_.at("error_event_i") != 0;
  for (const auto& [name, port] : input_ports_) port.drive(inputs_.at(name));
  connect_words(slave, registers);
  registers.eval();
  connect_answers(registers, slave);
  slave.eval();
}

void RegisterBench::follow(const AxiLiteSlavePins& slave) {
  if (was_in_reset_) {
    model_.reset();
    return;
  }
  const auto& writes = in_reset_ ? dropped_writes_ : driver_.writes();
  const auto& reads = in_reset_ ? dropped_reads_ : driver_.reads();
  std::optional<tb::AxiLiteWrite> write;
  std::optional<std::uint32_t> read;
  if (slave.bvalid && (!was_slave_.bvalid || was_master_.bready)) {
    if (acted_writes_ == writes.size()) return fail("a write response too many");
    write = writes[acted_writes_++];
  }
  if (slave.rvalid && (!was_slave_.rvalid || was_master_.rready)) {
    if (acted_reads_ == reads.size()) return fail("a read response too many");
    read = reads[acted_reads_++];
  }
  const auto answers = model_.clock(was_inputs_, write, read);
  if (write && slave.bresp != answers.write.code) {
    fail(fmt::format("write {} of {:03x}: response {}, expected {}", acted_writes_ - 1,
                     write->address, slave.bresp, answers.write.code));
  }
  if (read && (slave.rresp != answers.read.code || slave.rdata != answers.read.data)) {
    fail(fmt::format("read {} of {:03x}: response {} {:08x}, expected {} {:08x}", acted_reads_ - 1,
                     *read, slave.rresp, slave.rdata, answers.read.code, answers.read.data));
  }
  compared_ += (write ? 1 : 0) + (read ? 1 : 0);
}

void RegisterBench::compare_outputs() {
  const PortValues expected = model_.outputs();
  for (const auto& [name, port] : output_ports_) {
    const std::uint64_t value = port.read();
    high_[name] += value != 0 ? 1 : 0;
    const auto it = expected.find(name);
    if (it == expected.end() || it->second != value) {
      fail(fmt::format("{} is {:x}, expected {:x}", name, value,
                       it == expected.end() ? 0 : it->second));
    }
  }
}

void RegisterBench::step() {
  if (each_clock_) each_clock_();
  const AxiLiteMasterPins master = driver_.drive();
  drive(master);
  AxiLiteSlavePins slave;
  cores::sample_pins(slave_.dut(), slave);
  checker_.observe({in_reset_, master, slave}, clock());
  if (known_) {
    follow(slave);
    compare_outputs();
  }
  if (!in_reset_) driver_.accept(slave, clock());
  if (master.awvalid && slave.awready) ++ahead_;
  if (master.wvalid && slave.wready) --ahead_;
  if (in_reset_) ahead_ = 0;
  most_ahead_ = std::max(ahead_, most_ahead_);
  least_ahead_ = std::min(ahead_, least_ahead_);
  if (!master.awvalid) idle_addresses_.insert(master.awaddr);
  known_ = known_ || in_reset_;
  was_in_reset_ = in_reset_;
  was_inputs_ = inputs_;
  was_slave_ = slave;
  was_master_ = master;
  sim_.tick();
  slave_.tick();
}

void RegisterBench::steps(unsigned clocks) {
  for (unsigned i = 0; i < clocks; ++i) step();
}

void RegisterBench::run(std::uint64_t limit) {
  for (std::uint64_t i = 0; i < limit && failures_.size() < kMaxFailures; ++i) {
    if (driver_.idle()) return;
    step();
  }
  fail(fmt::format("watchdog: {} of {} writes and {} of {} reads answered",
                   driver_.write_responses().size(), driver_.writes().size(),
                   driver_.read_responses().size(), driver_.reads().size()));
}

std::uint8_t RegisterBench::write(std::uint32_t address, std::uint32_t data, std::uint8_t strobe) {
  driver_.write({address, data, strobe});
  run();
  return driver_.write_responses().empty() ? cores::kDecErr : driver_.write_responses().back().code;
}

RegisterModel::Answer RegisterBench::read(std::uint32_t address) {
  driver_.read(address);
  run();
  if (driver_.read_responses().empty()) return {cores::kDecErr, 0};
  return {driver_.read_responses().back().code, driver_.read_responses().back().data};
}

std::uint32_t RegisterBench::get(const std::string& reg) {
  const auto answer = read(register_offset(reg));
  EXPECT_EQ(answer.code, cores::kOkay) << reg;
  return answer.data;
}

void RegisterBench::set(const std::string& reg, std::uint32_t data) {
  EXPECT_EQ(write(register_offset(reg), data), cores::kOkay) << reg;
}

void RegisterBench::set_bit(const std::string& path) {
  const RegisterField& field = register_field(path);
  set(field.reg, field.mask());
}

void RegisterBench::pulse(const std::string& port, std::uint64_t value) {
  inputs_.at(port) = value;
  step();
  inputs_.at(port) = 0;
}

std::vector<std::uint32_t> RegisterBench::snapshot() {
  std::vector<std::uint32_t> words;
  std::uint32_t last = ~0u;
  for (const RegisterField& field : register_table()) {
    if (field.offset == last || field.access == "counter" || field.access == "log") continue;
    last = field.offset;
    words.push_back(read(last).data);
  }
  return words;
}

std::uint32_t BenchPort::read32(std::uint32_t offset) {
  const auto answer = bench_.read(offset);
  if (answer.code != cores::kOkay)
    throw RegisterError(fmt::format("read of {:03x} refused", offset));
  return answer.data;
}

void BenchPort::write32(std::uint32_t offset, std::uint32_t value) {
  if (bench_.write(offset, value) != cores::kOkay) {
    throw RegisterError(fmt::format("write of {:03x} refused", offset));
  }
}

}  // namespace hwffd::test
