#include "dma_bench.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hwffd/tb/beat_text.hpp"

namespace hwffd::test {

using tb::derive_seed;
using testing::AssertionFailure;
using testing::AssertionResult;
using testing::AssertionSuccess;

namespace {

/// A success where nothing is wrong.
AssertionResult verdict(const std::string& wrong) {
  return wrong.empty() ? AssertionSuccess() : AssertionFailure() << wrong;
}

/// Whether the bus answered with an error.
bool of_bus(const DmaError& error) {
  return error.valid && (error.code == kSlaveError || error.code == kDecodeError);
}

}  // namespace

const std::vector<BadDescriptor>& bad_descriptors() {
  static const std::vector<BadDescriptor> bad = {{{kPackets, 0, 0}, kZeroLength},
                                                 {{kPackets + 8, 64, 0}, kMisaligned},
                                                 {{0 - kBeat, 32, 0}, kWraps},
                                                 {{kRing - kBeat, 16, 0}, kOutside},
                                                 {{kPackets, 64, 1}, kFlags}};
  return bad;
}

DmaBench::DmaBench(const DmaSize& size, std::uint64_t seed)
    : memory(seed),
      size_(size),
      random_(derive_seed(seed, 1)),
      core_(make_dma_core(size.name, derive_seed(seed, 2))) {
  checker.set_hardened(size.hardened);
  set_windows(kEverywhere, kEverywhere);
  place_ring(kRing, 3);
  reset();
}

void DmaBench::set_bus_throttle(const std::string& name) {
  const auto make = [&](int i) { return tb::make_throttle(name, random_.bits() + i); };
  memory.set_throttles({make(0), make(1), make(2), make(3), make(4)});
}

void DmaBench::set_windows(tb::AxiMemory::Range read, tb::AxiMemory::Range write) {
  controls.read_first = read.first;
  controls.read_last = read.second;
  controls.write_first = write.first;
  controls.write_last = write.second;
  windows_settled_ = false;
  checker.set_limits({size_.max_burst, size_.outstanding, size_.outstanding, read.first,
                      read.second, write.first, write.second, size_.width});
}

void DmaBench::reset(unsigned cycles) {
  controls.rst = true;
  run(cycles);
  controls.rst = false;
  run(2);
}

void DmaBench::step() {
  memory.drive(bus_, cycle_);
  packet_pins_.ready = packet_throttle.willing();
  if (!result_pins_.valid) {
    result_pins_.valid = result_throttle.willing() && !results_.empty();
    result_pins_.mark = random_.chance(mark_chance_);
  }
  if (results_.empty()) result_pins_.valid = false;
  if (result_pins_.valid) {
    result_pins_.beat = results_.front();
  } else {  // idle data is garbage
    for (std::uint32_t& word : result_pins_.beat.words) word = random_.word();
    result_pins_.beat.last = random_.chance(0.5);
  }
  controls.windows_locked = windows_settled_;
  windows_settled_ = true;
  core_->exchange(controls, status, bus_, packet_pins_, result_pins_);
  observe();
  core_->clock();
  ++cycle_;
  controls.soft_reset = controls.ring_start = controls.result_start = false;
}

void DmaBench::observe() {
  if (controls.ring_start || controls.result_start) checker.restarted();
  checker.allow_ready_to_fall(status.clearing || was_clearing_);  // the halves are reset at its end
  const bool just_cleared = was_clearing_ && !status.clearing;
  was_clearing_ = status.clearing;
  checker.observe(bus_, cycle_, controls.rst);
  if (!controls.rst) memory.observe(bus_, cycle_);

  stream_faults_ += controls.rst && was_reset_ && result_pins_.ready;  // it would be lost
  was_reset_ = controls.rst;
  const bool cleared = controls.rst || status.clearing;
  if (packet_waits_ && !cleared) {
    stream_faults_ += !packet_pins_.valid || packet_pins_.beat != packet_held_;
  }
  packet_waits_ = packet_pins_.valid && !packet_pins_.ready && !cleared;
  packet_held_ = packet_pins_.beat;
  if (packet_pins_.valid && packet_pins_.ready && !controls.rst) {
    packets_.push_back(packet_pins_.beat);
  }
  if (result_pins_.valid && result_pins_.ready && !controls.rst) {
    accepted_.push_back(results_.front());
    marked_.push_back(result_pins_.mark);
    results_.pop_front();
    result_pins_.valid = false;
  }
  if (controls.rst) return;
  fault_pulses_ += status.fault;
  upsets_ += status.upset != 0;
  halted_early_ += status.halted && (both_ran_ || !memory.quiet());
  halted_cleared_ += status.halted && just_cleared;
  both_ran_ = status.ring_running && status.result_running;
  bus_errors_ += of_bus(status.read_error) || of_bus(status.write_error);  // both: one fault
  note(status.read_error, read_errors_);
  note(status.write_error, write_errors_);
}

void DmaBench::note(const DmaError& error, std::vector<DmaError>& errors) {
  if (!error.valid) return;
  errors.push_back(error);
}

void DmaBench::run(std::uint64_t cycles) {
  for (std::uint64_t i = 0; i < cycles; ++i) step();
}

bool DmaBench::run_until_idle(std::uint64_t limit) {
  run(6);  // what was just started is seen
  return run_until([&] { return status.idle; }, limit);
}

bool DmaBench::run_until_stopped(std::uint64_t limit) {
  return run_until_idle(limit) && !status.ring_running;
}

bool DmaBench::run_until_error(std::uint64_t limit) {
  return run_until([&] { return !read_errors_.empty() || !write_errors_.empty(); }, limit);
}

bool DmaBench::run_until_counted(std::uint64_t results, std::uint64_t limit) {
  return run_until([&] { return status.result_count == results; }, limit);
}

void DmaBench::place_ring(std::uint64_t base, unsigned entries_log2) {
  controls.ring_base = base;
  controls.ring_entries_log2 = entries_log2;
  software_head_ = 0;
}

void DmaBench::put_descriptor(const Descriptor& descriptor) {
  memory.set_beat(
      descriptor_address(software_head_),
      {static_cast<std::uint32_t>(descriptor.address),
       static_cast<std::uint32_t>(descriptor.address >> 32), descriptor.length, descriptor.flags});
  software_head_ =
      static_cast<std::uint16_t>((software_head_ + 1u) & ((1u << controls.ring_entries_log2) - 1));
}

void DmaBench::put_packet(std::uint64_t address, std::uint64_t beats) {
  for (std::uint64_t i = 0; i < beats; ++i) {
    memory.set_beat(address + i * kBeat,
                    {random_.word(), random_.word(), random_.word(), random_.word()});
  }
  put_descriptor({address, static_cast<std::uint32_t>(beats * kBeat), 0});
  expect_packet(address, beats);
}

void DmaBench::expect_packet(std::uint64_t address, std::uint64_t beats) {
  for (std::uint64_t i = 0; i < beats; ++i) {
    expected_.push_back({memory.beat(address + i * kBeat), i + 1 == beats});
  }
}

void DmaBench::put_packets(std::uint64_t count, std::uint64_t beats) {
  for (std::uint64_t i = 0; i < count; ++i) put_packet(kPackets + i * 0x1000, beats);
}

std::string DmaBench::packet_difference() const {
  if (expected_.empty()) return packets_.empty() ? "nothing expected" : "nothing was to come";
  for (std::size_t i = 0; i < std::min(packets_.size(), expected_.size()); ++i) {
    if (packets_[i] != expected_[i]) {
      return fmt::format("beat {}: {}, not {}", i, tb::beat_text(packets_[i]),
                         tb::beat_text(expected_[i]));
    }
  }
  if (packets_.size() == expected_.size()) return "";
  return fmt::format("{} beats, not {}", packets_.size(), expected_.size());
}

void DmaBench::start_ring() {
  ring_doorbell();
  controls.ring_start = true;
  step();
}

bool DmaBench::run_ring() {
  start_ring();
  return run_until_idle();
}

void DmaBench::forget_packets() {
  packets_.clear();
  expected_.clear();
}

void DmaBench::place_area(std::uint64_t base, std::uint32_t bytes) {
  controls.result_base = base;
  controls.result_size = bytes;
  controls.result_start = true;
}

void DmaBench::start_results(std::uint64_t base, std::uint32_t bytes) {
  place_area(base, bytes);
  step();
}

void DmaBench::offer_results(std::uint64_t count, std::uint64_t packet) {
  for (std::uint64_t i = 0; i < count; ++i) {
    results_.push_back({{random_.word(), random_.word(), random_.word(), random_.word()},
                        packet != 0 && (i + 1) % packet == 0});
  }
}

void DmaBench::forget_results() {
  results_.clear();
  accepted_.clear();
  marked_.clear();
}

std::uint64_t DmaBench::results_in_memory(std::uint64_t base, std::uint64_t first,
                                          std::uint64_t count) const {
  for (std::uint64_t i = 0; i < count; ++i) {
    if (first + i >= accepted_.size()) return i;
    if (memory.beat(base + i * kBeat) != accepted_[first + i].words) return i;
  }
  return count;
}

std::string DmaBench::faults() {
  checker.finish(cycle_);
  std::string text;
  if (stream_faults_ != 0) text += fmt::format("{} stream faults\n", stream_faults_);
  if (size_.timeout == 0 && fault_pulses_ != bus_errors_) {
    text += fmt::format("{} faults for {} clocks with an error of the bus\n", fault_pulses_,
                        bus_errors_);
  }
  if (size_.timeout == 0 && halted_early_ != 0)
    text += "halted while both halves run or a burst is open\n";
  if (halted_cleared_ != 0) text += "halted after a soft reset\n";
  if (upsets_ != 0) text += fmt::format("upsets in {} clocks, though no bit flipped\n", upsets_);
  for (const std::string& report : checker.reports()) text += report + "\n";
  if (text.empty() && checker.violations() != 0) text = "violations";
  return text;
}

AssertionResult DmaBench::exact() { return verdict(packet_difference() + faults()); }

AssertionResult DmaBench::exact(unsigned tail) {
  if (status.ring_tail == tail) return exact();
  return AssertionFailure() << "tail " << status.ring_tail << ", not " << tail;
}

AssertionResult DmaBench::reads(unsigned tail) {
  if (!run_ring()) return AssertionFailure() << "the ring has no end";
  return status.ring_running ? exact(tail) : AssertionFailure() << "the ring has stopped";
}

AssertionResult DmaBench::refuses(unsigned index, unsigned code) {
  read_errors_.clear();
  start_ring();
  if (!run_until_stopped(20000)) return AssertionFailure() << "the ring does not stop";
  if (status.ring_tail != index) return AssertionFailure() << "stopped at " << status.ring_tail;
  return only(read_errors_, code, descriptor_address(index));
}

AssertionResult DmaBench::writes(std::uint64_t base, std::uint64_t first, std::uint64_t count) {
  if (!run_until_counted(count)) return AssertionFailure() << status.result_count << " results";
  const std::uint64_t right = results_in_memory(base, first, count);
  if (right == count) return verdict(faults());
  return AssertionFailure() << "result " << right << " of " << count << " is wrong";
}

void DmaBench::begin_soft_reset() {
  controls.soft_reset = true;
  step();
  forget_results();
  step();
}

AssertionResult only(const std::vector<DmaError>& errors, unsigned code, std::uint64_t address) {
  auto failure = AssertionFailure();
  for (const DmaError& error : errors) {
    if (errors.size() == 1 && error.code == code && error.address == address) {
      return AssertionSuccess();
    }
    failure << fmt::format("code {} at {:#x}; ", error.code, error.address);
  }
  return failure << fmt::format("wanted one of code {} at {:#x}", code, address);
}

void set_all_throttles(DmaBench& bench, const std::string& bus, const std::string& stream) {
  bench.set_bus_throttle(bus);
  bench.packet_throttle = tb::make_throttle(stream, bench.random().bits());
  bench.result_throttle = tb::make_throttle(stream, bench.random().bits());
}

}  // namespace hwffd::test
