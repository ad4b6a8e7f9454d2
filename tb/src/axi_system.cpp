#include "hwffd/tb/axi_system.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "hwffd/registers.h"

namespace hwffd::tb {

AxiSystem::AxiSystem(cores::AxiCore& core, std::uint64_t seed)
    : memory(derive_seed(seed, 1)),
      core_(core),
      random_(derive_seed(seed, 2)),
      registers_(derive_seed(seed, 3)) {
  AxiChecker::Limits of_registers;
  of_registers.reset_edges = core_.reset_edges();
  register_checker.set_limits(of_registers);
  allow({}, {});
  reset();
}

void AxiSystem::allow(const AddressWindow& read, const AddressWindow& write) {
  bus_checker.set_limits({kMaxBurst, kOutstanding, kOutstanding, read.base, read.limit, write.base,
                          write.limit, core_.data_width(), core_.reset_edges()});
}

void AxiSystem::set_throttles(const std::string& name) {
  registers_.throttle(AxiThrottles::make(name, random_.bits()));
  memory.set_throttles(AxiThrottles::make(name, random_.bits()));
}

void AxiSystem::reset(unsigned clocks) {
  registers_.clear();
  memory.forget_open();
  clearing_ = false;
  bus_checker.allow_ready_to_fall(false);
  in_reset_ = true;
  run(clocks);
  in_reset_ = false;
  run(2);
}

void AxiSystem::forget_bus() {
  memory.forget_open();
  bus_checker.forget();
}

void AxiSystem::run(std::uint64_t clocks) {
  for (std::uint64_t i = 0; i < clocks; ++i) step();
}

void AxiSystem::step() {
  memory.drive(bus_, cycle_);
  register_pins_.in_reset = in_reset_;
  register_pins_.master = registers_.drive();
  core_.exchange(in_reset_, register_pins_, bus_);
  bus_checker.observe(bus_, cycle_, in_reset_);
  register_checker.observe(register_pins_, cycle_);
  if (!in_reset_) {
    memory.observe(bus_, cycle_);
    registers_.accept(register_pins_.slave, cycle_);
    count();
  }
  core_.clock();
  ++cycle_;
}

void AxiSystem::count() {
  const bool read = bus_.r.valid && bus_.r.ready;
  const bool write = bus_.w.valid && bus_.w.ready;
  if (!read && !write) return;
  if (utilisation_.read_beats + utilisation_.write_beats == 0) utilisation_.first = cycle_;
  utilisation_.last = cycle_;
  if (write && utilisation_.write_beats == 0) utilisation_.first_write = cycle_;
  if (write) utilisation_.last_write = cycle_;
  utilisation_.read_beats += read ? 1 : 0;
  utilisation_.write_beats += write ? 1 : 0;
}

template <class Responses>
const AxiLiteResponse& AxiSystem::answer(const Responses& responses, std::size_t number) {
  for (std::uint64_t waited = 0; responses.size() <= number; ++waited) {
    if (waited == access_limit) throw std::runtime_error("watchdog: no response to a register");
    step();
  }
  return responses[number];
}

std::uint32_t AxiSystem::read32(std::uint32_t offset) {
  const std::size_t number = registers_.reads().size();
  registers_.read(offset);
  const AxiLiteResponse response = answer(registers_.read_responses(), number);
  if (response.code != cores::kOkay)
    throw RegisterError(fmt::format("read of {:03x} refused", offset));
  if (offset == HWFFD_LIMITS2_OFFSET)
    bus_checker.set_hardened((response.data & HWFFD_LIMITS2_HARDENED_MASK) != 0);
  if (clearing_ && offset == HWFFD_STATUS_OFFSET &&
      (response.data & (HWFFD_STATUS_IDLE_MASK | HWFFD_STATUS_BUSY_MASK)) ==
          HWFFD_STATUS_IDLE_MASK) {
    clearing_ = false;
    bus_checker.allow_ready_to_fall(false);
    bus_checker.restarted();
  }
  return response.data;
}

void AxiSystem::post_write(std::uint32_t offset, std::uint32_t value, std::uint8_t strobe) {
  registers_.write({offset, value, strobe});
}

std::uint8_t AxiSystem::try_write(std::uint32_t offset, std::uint32_t value, std::uint8_t strobe) {
  if (offset == HWFFD_CONTROL_OFFSET && (value & HWFFD_CONTROL_SOFT_RESET_MASK) != 0) {
    clearing_ = true;
    bus_checker.allow_ready_to_fall(true);
  }
  const std::size_t number = registers_.writes().size();
  post_write(offset, value, strobe);
  return answer(registers_.write_responses(), number).code;
}

void AxiSystem::write32(std::uint32_t offset, std::uint32_t value) {
  if (try_write(offset, value) != cores::kOkay) {
    throw RegisterError(fmt::format("write of {:03x} refused", offset));
  }
}

std::string AxiSystem::faults() {
  bus_checker.finish(cycle_);
  register_checker.finish(cycle_);
  std::string text;
  for (const std::string& report : bus_checker.reports()) text += "bus: " + report + "\n";
  for (const std::string& report : register_checker.reports())
    text += "registers: " + report + "\n";
  if (!memory.quiet()) text += "the memory waits for something\n";
  return text;
}

}  // namespace hwffd::tb
