// The driver's side of the protocol.
#include <gtest/gtest.h>

#include <set>

#include "hwffd/tb/stream_driver.hpp"
#include "loopback_core.hpp"

namespace hwffd::tb {
namespace {

TEST(StreamDriver, HoldsABeatUntilItIsAccepted) {
  StreamDriver driver(1);
  const auto beats = random_beats(2, 1);
  driver.push(beats);
  driver.drive(false);
  EXPECT_FALSE(driver.valid());
  EXPECT_FALSE(driver.accept(true, 0));
  driver.drive(true);
  for (std::uint64_t cycle = 1; cycle < 10; ++cycle) {
    EXPECT_TRUE(driver.valid());
    EXPECT_EQ(driver.beat(), beats[0]);
    EXPECT_FALSE(driver.accept(false, cycle));
    driver.drive(false);  // no longer willing, but the beat is offered
  }
  driver.push(random_beats(3, 2));  // nor does a push disturb it
  EXPECT_EQ(driver.beat(), beats[0]);
  EXPECT_EQ(driver.waiting(), 5u);
  EXPECT_TRUE(driver.accept(true, 10));
  driver.drive(true);
  EXPECT_EQ(driver.beat(), beats[1]);
  EXPECT_TRUE(driver.accept(true, 11));
  EXPECT_EQ(driver.clocks(), (std::vector<std::uint64_t>{10, 11}));
  EXPECT_EQ(driver.accepted(), 2u);
  EXPECT_EQ(driver.waiting(), 3u);
}

TEST(StreamDriver, IdlePinsAreRandom) {
  StreamDriver driver(1);
  std::set<std::uint32_t> words;
  unsigned last = 0;
  for (unsigned cycle = 0; cycle < 100; ++cycle) {
    driver.drive(true);  // willing, but with nothing to offer
    EXPECT_FALSE(driver.valid());
    words.insert(driver.beat().words.begin(), driver.beat().words.end());
    last += driver.beat().last ? 1 : 0;
  }
  EXPECT_EQ(words.size(), 400u);
  EXPECT_GT(last, 25u);
  EXPECT_LT(last, 75u);
}

TEST(StreamDriver, ClearDropsTheOfferedBeat) {
  StreamDriver driver(1);
  driver.push(random_beats(2, 1));
  driver.drive(true);
  EXPECT_TRUE(driver.valid());
  driver.clear();
  EXPECT_FALSE(driver.valid());
  EXPECT_EQ(driver.waiting(), 0u);
  driver.drive(true);
  EXPECT_FALSE(driver.valid());
}

}  // namespace
}  // namespace hwffd::tb
