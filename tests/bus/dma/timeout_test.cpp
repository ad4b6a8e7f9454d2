// A memory that stops to answer on one channel: the time-out is exact to the clock and says which
// channel it was, a soft reset ends, and the next transfer is exact.
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <tuple>

#include "transfer.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kNever = std::uint64_t{1} << 60;

enum Channel : unsigned { kAr, kR, kAw, kW, kB, kChannels };

/// Throttles of which one is shut after some clocks, for that many.
tb::AxiThrottles shut(Channel channel, std::uint64_t after, std::uint64_t clocks) {
  tb::AxiThrottles throttles;
  tb::Throttle* const channels[] = {&throttles.ar, &throttles.r, &throttles.aw, &throttles.w,
                                    &throttles.b};
  *channels[channel] = tb::Throttle::shut_after(after + 1, clocks);
  return throttles;
}

/// What ffd_dma_watch counts, from the pins.
class Watch {
 public:
  /// The clocks that each channel has waited by the end of this one.
  const std::array<std::uint64_t, kChannels>& clock(const cores::AxiPins& pins) {
    const bool waits[] = {pins.ar.valid && !pins.ar.ready, reads_ != 0 && !pins.r.valid,
                          pins.aw.valid && !pins.aw.ready, pins.w.valid && !pins.w.ready,
                          addresses_ != 0 && bursts_ != 0 && !pins.b.valid};
    for (unsigned channel = 0; channel < kChannels; ++channel) {
      waited_[channel] = waits[channel] ? waited_[channel] + 1 : 0;
    }
    reads_ += pins.ar.valid && pins.ar.ready ? 1 : 0;
    reads_ -= pins.r.valid && pins.r.ready && pins.r.last ? 1 : 0;
    addresses_ += pins.aw.valid && pins.aw.ready ? 1 : 0;
    bursts_ += pins.w.valid && pins.w.ready && pins.w.last ? 1 : 0;
    if (pins.b.valid && pins.b.ready) {
      --addresses_;
      --bursts_;
    }
    return waited_;
  }

 private:
  std::array<std::uint64_t, kChannels> waited_{};
  std::uint64_t reads_ = 0, addresses_ = 0, bursts_ = 0;
};

const Transfer kTimedTransfer{
    {{kPackets, 30}, {kPackets + 0x1000, 30}, {kPackets + 0x2000, 30}, {kPackets + 0x3000, 30}},
    40};

/// After a soft reset has ended: the memory is as new, the next transfer whole.
void expect_next(DmaBench& bench) {
  bench.memory.forget_open();
  bench.memory.set_throttles({});
  bench.checker.forget();
  bench.set_windows(kEverywhere, kEverywhere);
  kTimedTransfer.expect_next(bench);
}

class Timeout : public testing::TestWithParam<std::tuple<Channel, DmaSize>> {
 protected:
  static Channel channel() { return std::get<0>(GetParam()); }
  static const DmaSize& size() { return std::get<1>(GetParam()); }
};
std::string channel_name(const testing::TestParamInfo<Timeout::ParamType>& info) {
  static const char* const kNames[] = {"AR", "R", "AW", "W", "B"};
  const DmaSize& size = std::get<1>(info.param);
  const std::string width = size.width == 128 ? "" : std::to_string(size.width);
  return kNames[std::get<0>(info.param)] + width;
}
INSTANTIATE_TEST_SUITE_P(Dma, Timeout,
                         testing::Combine(testing::Values(kAr, kR, kAw, kW, kB),
                                          testing::ValuesIn(watched_dma_sizes())),
                         channel_name);

/// The pulse comes in the clock after the last of so many, once, and not for one clock fewer.
TEST_P(Timeout, IsExactToTheClock) {
  const std::uint64_t limit = size().timeout;
  unsigned timeouts = 0;
  for (std::uint64_t after = 0; after < 60; after += 3) {
    for (const std::uint64_t clocks : {limit / 2, limit + 60}) {
      SCOPED_TRACE(testing::Message() << "shut after " << after << " for " << clocks);
      DmaBench bench(size(), after);
      bench.memory.set_throttles(shut(channel(), after, clocks));
      kTimedTransfer.start(bench, kArea);
      Watch watch;
      unsigned expected = 0;
      for (int clock = 0; clock < 600; ++clock) {
        ASSERT_EQ(bench.status.timeout, expected) << "clock " << bench.cycle();
        const auto& waited = watch.clock(bench.bus());
        expected = 0;
        for (unsigned channel = 0; channel < kChannels; ++channel) {
          expected |= waited[channel] == limit ? 1U << channel : 0U;
        }
        timeouts += expected >> channel() & 1;
        bench.step();
      }
      bench.memory.set_throttles({});
      bench.run(300);
      EXPECT_EQ(bench.faults(), "") << "what waits stays";
    }
  }
  EXPECT_GE(timeouts, 10U);
}

/// After it no address is raised, and the engine counts as halted although a burst is open.
TEST_P(Timeout, HoldsBothHalves) {
  DmaBench bench(size(), 5);
  bench.memory.set_throttles(shut(channel(), 25, kNever));
  kTimedTransfer.start(bench, kArea);
  ASSERT_TRUE(bench.run_until([&] { return bench.status.timeout != 0; }, 1000));
  EXPECT_EQ(bench.status.timeout, 1U << channel());
  EXPECT_TRUE(bench.run_until([&] { return bench.status.halted; }, 200));
  const std::size_t reads = bench.memory.reads().size(), writes = bench.memory.writes().size();
  bench.run(300);
  EXPECT_LE(bench.memory.reads().size(), reads + 1);
  EXPECT_LE(bench.memory.writes().size(), writes + 1);
  EXPECT_TRUE(bench.status.halted);
}

/// A soft reset ends, whether it comes before the time-out or after it, and at once then.
TEST_P(Timeout, LetsASoftResetEnd) {
  const std::uint64_t limit = size().timeout;
  for (std::uint64_t after = 0; after < 50; after += 2) {
    for (const std::uint64_t wait : {std::uint64_t{0}, limit / 2, 3 * limit}) {
      SCOPED_TRACE(testing::Message() << "shut after " << after << ", reset after " << wait);
      DmaBench bench(size(), after + wait);
      bench.memory.set_throttles(shut(channel(), after, kNever));
      kTimedTransfer.start(bench, kArea);
      bench.run(after + wait);
      bench.begin_soft_reset();
      ASSERT_TRUE(bench.end_soft_reset(2 * limit));
      EXPECT_EQ(bench.status.ring_tail, 0);
      EXPECT_EQ(bench.status.result_count, 0U);
      expect_next(bench);
      ASSERT_FALSE(HasFailure());
    }
  }
}

/// What the memory answers after it was given up is ignored while nothing is open.
TEST_P(Timeout, IgnoresAnAnswerThatComesAfterAll) {
  DmaBench bench(size(), 9);
  bench.memory.set_throttles(shut(channel(), 20, kNever));
  kTimedTransfer.start(bench, kArea);
  bench.run(400);
  bench.begin_soft_reset();
  bench.forget_packets();
  ASSERT_TRUE(bench.end_soft_reset(200));
  bench.memory.set_throttles({});
  bench.run(300);
  EXPECT_TRUE(bench.packets().empty());
  EXPECT_TRUE(bench.status.idle);
  EXPECT_EQ(bench.status.result_count, 0U);
  expect_next(bench);
}

/// A channel that wakes up in time gets its soft reset as if it had not slept.
TEST_P(Timeout, OfAChannelThatWokeUpIsForgotten) {
  DmaBench bench(size(), 3);
  bench.memory.set_throttles(shut(channel(), 25, kNever));
  kTimedTransfer.start(bench, kArea);
  ASSERT_TRUE(bench.run_until([&] { return bench.status.timeout != 0; }, 1000));
  bench.memory.set_throttles({});
  bench.run(3);
  bench.begin_soft_reset();
  ASSERT_TRUE(bench.end_soft_reset(500));
  EXPECT_TRUE(bench.memory.quiet()) << "open bursts are completed";
  EXPECT_EQ(bench.faults(), "");
  expect_next(bench);
}

class ReadTimeout : public testing::TestWithParam<DmaSize> {};
INSTANTIATE_TEST_SUITE_P(Dma, ReadTimeout, testing::ValuesIn(watched_dma_sizes()),
                         [](const auto& info) { return info.param.name; });

/// Nothing comes of read data that the memory wakes up with while a soft reset gives it
/// up, in its last clock neither, be it the beat that fails or any other.
TEST_P(ReadTimeout, ForgetsAnAnswerOfTheClockInWhichASoftResetEnds) {
  std::uint64_t answers = 0;
  for (std::uint64_t failing = 0; failing < 4; ++failing) {
    bool told = false;  // of a beat that came in time
    for (std::uint64_t after = 0; !told; ++after) {
      const std::uint64_t reset = after + GetParam().timeout + 10;
      for (std::uint64_t wakes = reset; wakes < reset + 6; ++wakes) {
        SCOPED_TRACE(testing::Message() << "beat " << failing << ", shut after " << after
                                        << ", wakes " << wakes - reset << " after the reset");
        DmaBench bench(GetParam(), failing);
        bench.memory.set_throttles(shut(kR, after, wakes - after));
        for (const auto& [address, beats] : kTimedTransfer.packets) {
          bench.memory.fail_read_at(address, failing, cores::kAxiSlverr);
        }
        kTimedTransfer.start(bench, kArea);
        bench.run(reset);
        told = !bench.read_errors().empty();
        if (told) break;
        const std::size_t packets = bench.packets().size();
        const std::uint64_t beats = bench.memory.read_beats();
        bench.begin_soft_reset();
        ASSERT_TRUE(bench.end_soft_reset(200));
        bench.run(40);
        answers += bench.memory.read_beats() - beats;
        EXPECT_EQ(bench.packets().size(), packets);
        EXPECT_TRUE(bench.read_errors().empty());
        bench.memory.fail_nothing();
        expect_next(bench);
        ASSERT_FALSE(HasFailure());
      }
    }
  }
  EXPECT_GT(answers, 500U);
}

}  // namespace
}  // namespace hwffd::test
