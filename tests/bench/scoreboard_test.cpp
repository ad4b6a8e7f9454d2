// The words of the scoreboard's reports, and that every bit counts. Its verdicts are those of the
// bench: flaw_test.cpp, reset_test.cpp.
#include "hwffd/tb/scoreboard.hpp"

#include <gtest/gtest.h>

#include <string>

namespace hwffd::tb {
namespace {

Beat beat(std::uint32_t value, bool last = false) {
  return Beat{{value, 0x22222222, 0x33333333, 0xabcd0000u | value}, last};
}

TEST(Scoreboard, NothingCheckedIsAFailure) {
  Scoreboard board({"t", 1, {}});
  EXPECT_TRUE(board.ok());
  EXPECT_FALSE(board.finish());
  EXPECT_FALSE(board.ok());
  ASSERT_EQ(board.reports().size(), 1u);
  EXPECT_NE(board.reports()[0].find("nothing was checked"), std::string::npos);
}

TEST(Scoreboard, NumbersBeatsFromTheRestart) {
  Scoreboard board({"t", 1, {}});
  board.expect({beat(1), beat(2)});
  board.receive(beat(1), 1);
  board.receive(beat(2), 2);
  board.receive(beat(3), 3);
  board.restart();
  board.expect({beat(1)});
  board.receive(beat(2), 4);
  ASSERT_EQ(board.reports().size(), 2u);
  EXPECT_NE(board.reports()[0].find("beat 2, cycle 3"), std::string::npos);
  EXPECT_NE(board.reports()[1].find("beat 0, cycle 4"), std::string::npos);
}

TEST(Scoreboard, EveryBitCounts) {
  for (unsigned bit = 0; bit <= 128; ++bit) {
    Scoreboard board({"t", 1, {}});
    Beat got = beat(1);
    board.expect({got});
    if (bit == 128) {
      got.last = true;
    } else {
      got.words[bit / 32] ^= 1u << (bit % 32);
    }
    EXPECT_FALSE(board.receive(got, 1)) << bit;
    EXPECT_EQ(board.mismatches(), 1u);
  }
}

TEST(Scoreboard, ReportSaysWhereAndHowToRepeat) {
  Scoreboard board({"stream.bursts", 77, {}});
  board.expect({beat(1), beat(2)});
  board.receive(beat(1), 4);
  board.receive(Beat{{9, 0x22222222, 0x33333333, 0xabcd0002}, true}, 123);
  ASSERT_EQ(board.reports().size(), 1u);
  EXPECT_EQ(board.reports()[0],
            "stream.bursts seed 77: beat 1, cycle 123, tag 0002: wrong\n"
            "  expected 00000002 22222222 33333333 abcd0002\n"
            "  got      00000009 22222222 33333333 abcd0002 last\n"
            "  differs in word 0 by 0000000b, last\n"
            "  replay   SEED=77 ctest -R 'stream.bursts'");
}

TEST(Scoreboard, ReplayCommandCanBeGiven) {
  Scoreboard board({"t", 1, "make -C lab soak SEED=1"});
  board.receive(beat(1), 5);
  ASSERT_EQ(board.reports().size(), 1u);
  EXPECT_EQ(board.reports()[0],
            "t seed 1: beat 0, cycle 5, tag 0001: unexpected\n"
            "  got      00000001 22222222 33333333 abcd0001\n"
            "  replay   make -C lab soak SEED=1");
}

}  // namespace
}  // namespace hwffd::tb
