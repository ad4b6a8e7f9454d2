// How a run of cycles ends, and what it tells on its way.
#include "hwffd/cores/stream_loop.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace hwffd::cores {
namespace {

class NoCore final : public StreamCore {
 public:
  void drive_reset(bool) override {}
  void drive_input(bool, const Beat&) override {}
  void drive_output_ready(bool) override {}
  void settle() override {}
  void clock() override {}
  bool input_ready() const override { return true; }
  bool output_valid() const override { return false; }
  Beat output() const override { return {}; }
  bool idle() const override { return true; }
};

/// Of each cycle what is left then; a beat moves where that changes.
class Planned final : public StreamParty {
 public:
  Planned(StreamLoop& loop, std::vector<std::uint64_t> left)
      : loop_(loop), left_(std::move(left)) {}
  bool one_cycle() override {
    loop_.clock();
    if (at_ + 1 < left_.size()) ++at_;
    return at_ > 0 && left_[at_] != left_[at_ - 1];
  }
  std::uint64_t left() const override { return left_[at_]; }
  bool stopped() const override { return at_ == stops_at; }

  std::size_t stops_at = ~std::size_t{0};

 private:
  StreamLoop& loop_;
  std::vector<std::uint64_t> left_;
  std::size_t at_ = 0;
};

struct Ran {
  StreamEnd end;
  std::vector<double> progress;
};

Ran run(const std::vector<std::uint64_t>& left, const StreamLimits& limits,
        std::size_t stops_at = ~std::size_t{0}) {
  NoCore core;
  StreamLoop loop(core);
  Planned party(loop, left);
  party.stops_at = stops_at;
  std::vector<double> progress;
  const StreamEnd end = loop.run(party, limits, [&](double part) { progress.push_back(part); });
  return {end, progress};
}

TEST(StreamLoop, TellsWhatMoved) {
  const Ran ran = run({4, 3, 1, 0}, {2});
  EXPECT_EQ(ran.end, StreamEnd::kDone);
  EXPECT_EQ(ran.progress, (std::vector<double>{0.25, 0.75, 1}));
}

/// Beats that make others: what is left may become more than there was.
TEST(StreamLoop, TellsNothingTwiceWhereMoreIsToCome) {
  const Ran ran = run({4, 6, 3, 5, 2, 0}, {2});
  EXPECT_EQ(ran.end, StreamEnd::kDone);
  EXPECT_EQ(ran.progress, (std::vector<double>{0.25, 0.5, 1}));
}

TEST(StreamLoop, GivesUp) {
  EXPECT_EQ(run({4, 3, 3, 3, 3}, {2}).end, StreamEnd::kStalled);
  EXPECT_EQ(run({4, 3, 2, 1, 0}, {2, 3}).end, StreamEnd::kLate);
  EXPECT_EQ(run({4, 3, 2, 1, 0}, {2}, 2).end, StreamEnd::kStopped);
  EXPECT_EQ(run({0}, {2}).end, StreamEnd::kDone);
}

}  // namespace
}  // namespace hwffd::cores
