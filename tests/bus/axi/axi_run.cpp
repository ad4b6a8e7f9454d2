#include "axi_run.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/beat_text.hpp"

namespace hwffd::test {

using ::testing::AssertionFailure;
using ::testing::AssertionResult;
using ::testing::AssertionSuccess;

namespace {
constexpr std::uint64_t kGuardBytes = 3 * kBeat;  // between two areas
}  // namespace

std::vector<Configuration> axi_configurations() { return rows_where(cores::has_axi_core); }

AxiRun::AxiRun(const Configuration& row, std::uint64_t seed, const std::string& throttles)
    : AxiRun(row, cores::make_axi_core(row, seed), seed, throttles) {}

AxiRun::AxiRun(const Configuration& row, std::unique_ptr<cores::AxiCore> core, std::uint64_t seed,
               const std::string& throttles, const PageCore& has)
    : row_(row),
      codec_(row.format),
      random_(tb::derive_seed(seed, 11)),
      core_(std::move(core)),
      system_(std::make_unique<tb::AxiSystem>(*core_, seed)),
      driver_(*system_),
      model_(row, has.features, has.axis, has.pages, has.spans, has.grid_limit) {
  system_->memory.set_latency({1, 1 + random_.below(40)});
  system_->set_throttles(throttles);
  set_up();
}

void AxiRun::set_up() {
  driver_.probe();
  driver_.set_windows(places_.read, places_.write);
  driver_.lock_windows();
  driver_.enable_interrupts(HWFFD_IRQ_ENABLE_DONE_MASK | HWFFD_IRQ_ENABLE_ERROR_MASK |
                            HWFFD_IRQ_ENABLE_REFUSED_MASK);
  system_->allow(places_.read, places_.write);
  ring_.emplace(system_->memory, driver_, places_.ring, places_.buffers);
  ring_->open();
  written_.push_back(ring_->ring_range());
  written_.push_back({places_.buffers.base, places_.buffers.limit});
  next_area_ = places_.write.base;
}

void AxiRun::hard_reset(unsigned clocks) {
  system_->allow({}, {});
  system_->reset(clocks);
  model_.reset();
  expected_.clear();
  set_up();
}

void AxiRun::move_to(const Places& places) {
  places_ = places;
  hard_reset(4);
}

void AxiRun::send(const std::vector<Beat>& packets) {
  if (driver_.pending() == 0) ring_->set_next_buffer(places_.buffers.base);
  ring_->put(packets);
  expect(packets);
}

void AxiRun::expect(const std::vector<Beat>& packets) {
  const std::vector<Beat> results = model_.run(packets);
  expected_.insert(expected_.end(), results.begin(), results.end());
}

void AxiRun::send_bspline() { send(coefficients_packet(watertight_bspline(codec_), codec_)); }

void AxiRun::choose_area(std::optional<std::uint64_t> results) {
  area_results_ = std::max<std::uint64_t>(1, results.value_or(expected_.size()));
  const std::uint64_t bytes = area_results_ * kBeat;
  if (next_area_ + bytes > places_.write.limit) next_area_ = places_.write.base;
  area_ = next_area_;
  next_area_ += bytes + kGuardBytes;
  areas_.push_back({area_, area_ + bytes - 1});
  driver_.set_results({area_, static_cast<std::uint32_t>(bytes)});
}

void AxiRun::start(std::optional<std::uint64_t> results) {
  choose_area(results);
  driver_.start();
}

void AxiRun::start(std::optional<std::uint64_t> results, const std::function<void()>& behind) {
  choose_area(results);
  system_->write32(HWFFD_STATUS_OFFSET, HWFFD_STATUS_DONE_MASK);
  system_->post_write(HWFFD_CONTROL_OFFSET, HWFFD_CONTROL_START_MASK);
  behind();
}

AssertionResult AxiRun::wait() {
  if (driver_.wait_done(kPolls)) return AssertionSuccess();
  return AssertionFailure() << "no end; " << driver_.result_count() << " of " << expected_.size()
                            << " results, " << driver_.pending() << " packets pending";
}

std::uint64_t AxiRun::results_in_memory() const {
  for (std::size_t i = 0; i < expected_.size(); ++i) {
    if (system_->memory.beat(area_ + i * kBeat) != expected_[i].words) return i;
  }
  return expected_.size();
}

std::uint32_t AxiRun::result_word(std::uint64_t index, unsigned word) const {
  return system_->memory.beat(area_ + index * kBeat)[word];
}

void AxiRun::start_in(std::uint64_t base, std::uint32_t bytes) {
  system_->write32(HWFFD_RESULT_BASE_LO_OFFSET, static_cast<std::uint32_t>(base));
  system_->write32(HWFFD_RESULT_BASE_HI_OFFSET, static_cast<std::uint32_t>(base >> 32));
  system_->write32(HWFFD_RESULT_SIZE_OFFSET, bytes);
  driver_.start();
}

void AxiRun::start_with_memory_shut(std::uint64_t clocks) {
  tb::AxiThrottles shut;
  shut.w = tb::Throttle::shut_after(1, 2 * clocks);
  system_->memory.set_throttles(shut);
  start();
  system_->run(clocks);
}

AssertionResult AxiRun::finish() {
  const AssertionResult ended = wait();
  if (!ended) return ended;
  const std::uint64_t count = driver_.result_count();
  if (count != expected_.size()) {
    return AssertionFailure() << count << " results, not " << expected_.size();
  }
  const std::uint64_t right = results_in_memory();
  if (right != expected_.size()) {
    return AssertionFailure() << fmt::format(
               "result {} of {}, at {:#x}\n  expected {}\n  got      {}", right, expected_.size(),
               area_ + right * kBeat, tb::beat_text({expected_[right].words, false}),
               tb::beat_text({system_->memory.beat(area_ + right * kBeat), false}));
  }
  areas_.back().second = area_ + count * kBeat - 1;
  if (count == 0) areas_.pop_back();
  checked_ += expected_.size();
  expected_.clear();
  return AssertionSuccess();
}

AssertionResult AxiRun::go() {
  start();
  return finish();
}

AssertionResult AxiRun::soft_reset() {
  if (!driver_.soft_reset(kPolls)) return AssertionFailure() << "the soft reset has no end";
  model_.reset();
  expected_.clear();
  ring_->open();
  return AssertionSuccess();
}

void AxiRun::forget_expected() { expected_.clear(); }

AssertionResult AxiRun::good_run() {
  const std::uint64_t saturated = model_.events()[kSaturated];
  send_bspline();
  send_lattice(6);
  send_vertices(5);
  send(interleaved_packet(make_stimulus("random", codec_, 2, random_.bits())));
  const AssertionResult ran = go();
  if (!ran) return AssertionFailure() << "good run: " << ran.message();
  const CoreErrors errors = driver_.take_errors();
  // A point within half a step of 1 saturates on entry; the model knows when.
  const std::uint32_t expected = model_.events()[kSaturated] != saturated ? 1U << kSaturated : 0;
  if (errors.status == expected) return AssertionSuccess();
  return AssertionFailure() << "good run: errors " << std::hex << errors.status;
}

AssertionResult AxiRun::clean() {
  system_->run(300);  // nothing comes after
  std::string faults = system_->faults();
  std::vector<tb::AxiMemory::Range> ranges = areas_;
  ranges.insert(ranges.end(), written_.begin(), written_.end());
  const std::uint64_t changed = system_->memory.changed_outside(ranges);
  if (changed != 0) faults += fmt::format("{} guard bytes changed\n", changed);
  if (checked_ == 0) faults += "nothing was checked\n";
  if (faults.empty()) return AssertionSuccess();
  return AssertionFailure() << faults;
}

AssertionResult AxiRun::ends_well() {
  const AssertionResult ran = good_run();
  return ran ? clean() : ran;
}

AssertionResult AxiRun::only_error(const FirstError& first, std::uint32_t count) {
  const auto text = [](const CoreErrors& errors) {
    const FirstError at = errors.first.value_or(FirstError{});
    return fmt::format("status {:x}, {} errors, first {} in packet {}, beat {}, at {:#x}",
                       errors.status, errors.count, at.code, at.packet, at.beat, at.address);
  };
  const CoreErrors errors = driver_.take_errors();
  driver_.clear_counters();
  if (driver_.take_errors().first) return AssertionFailure() << "the first error stays";
  const std::string got = text(errors), wanted = text({1U << first.code, count, first});
  if (errors.first && got == wanted) return AssertionSuccess();
  return AssertionFailure() << got << "\nwanted " << wanted;
}

void expect_words_and_bytes(tb::AxiSystem& system) {
  constexpr std::uint32_t kWord = HWFFD_RESULT_BASE_LO_OFFSET, kWords = 0x1000;
  for (unsigned strobe = 0; strobe < 16; ++strobe) {
    system.write32(kWord, 0x11223344);
    ASSERT_EQ(system.try_write(kWord, 0xAABBCCDD, static_cast<std::uint8_t>(strobe)), cores::kOkay);
    std::uint32_t expected = 0;
    for (unsigned byte = 0; byte < 4; ++byte) {
      const std::uint32_t from = (strobe >> byte & 1) != 0 ? 0xAABBCCDD : 0x11223344;
      expected |= from & 0xFFU << 8 * byte;
    }
    EXPECT_EQ(system.read32(kWord), expected) << strobe;
  }
  for (std::uint32_t bit = 0x200; bit < kWords; bit *= 2) {
    EXPECT_THROW(system.read32(kWord | bit), RegisterError) << bit;
    EXPECT_EQ(system.try_write(kWord | bit, 0), cores::kSlvErr) << bit;
  }
  EXPECT_EQ(system.read32(kWord), 0xAABBCCDDU);
}

}  // namespace hwffd::test
