// ffd_eval_sequencer: every vertex does its steps in order, as far apart as its barrel is long;
// vertices leave in the order in which they came, at the full rate, and where that leaves them four
// clocks or more, never closer than the three that a shared converter needs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "Vsequencer_barrels.h"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/sim.hpp"

namespace hwffd::test {
namespace {

constexpr int kSizes = 7, kBarrels = 8;  // as in sequencer_barrels.v
constexpr int kCount = kSizes * kBarrels;
constexpr int kConverter = 3;  // clocks of three words one after the other (ffd_eval_words)

template <class Port>
std::uint8_t byte(const Port& port, int i) {
  return static_cast<std::uint8_t>(port[i / 4] >> (8 * (i % 4)));
}

/// What is known of one sequencer.
struct Barrel {
  int steps = 0, vertices = 0;
  std::uint8_t next = 0;  ///< number of the vertex that is offered
  struct Inside {
    std::uint8_t number;
    int step;
    std::int64_t clock;  ///< of that step
  };
  std::deque<Inside> inside;  ///< in the order in which they came
  std::vector<int> left;      ///< steps that each context has before it
  std::int64_t last_start = -1000;

  /// Clocks between starts, so that they are spread over the time of a vertex.
  int gap() const {
    if (steps >= vertices + 2) return steps - vertices + 1;
    return steps >= 4 ? 3 : steps > vertices ? 2 : 1;
  }

  /// Whether a vertex may come, and what becomes of the context whose turn it is.
  bool turn(std::int64_t clock, bool offered) {
    int& mine = left[clock % vertices];
    const bool ready = mine == 0 && clock - last_start >= gap();
    if (ready && offered) {
      last_start = clock;
      mine = steps - 1;
    } else if (mine > 0) {
      --mine;
    }
    return ready;
  }

  std::int64_t started = 0, ended = 0, last_end = -100;
  int wrong = 0;
  std::int64_t closest = 1000;  ///< clocks between ends
};

class Barrels : public ::testing::Test {
 protected:
  Barrels() {
    for (int i = 0; i < kCount; ++i) {
      Barrel barrel;
      barrel.steps = 1 << (i / kBarrels);
      barrel.vertices = i % kBarrels + 1;
      barrel.left.resize(barrel.vertices, 0);
      barrels_.push_back(barrel);
    }
    sim_->rst = 1;
    sim_->valid_i = 0;
    sim_.tick();
    sim_->rst = 0;
  }

  /// A clock in which each sequencer that `mask` has is offered a vertex.
  void tick(std::uint64_t mask) {
    sim_->valid_i = mask;
    for (int word = 0; word < kCount / 4; ++word) {
      sim_->vertex_i[word] = 0;
      for (int i = 0; i < 4; ++i) {
        sim_->vertex_i[word] |= std::uint32_t{barrels_[4 * word + i].next} << (8 * i);
      }
    }
    const std::uint64_t ready = sim_->ready_o;
    const std::uint64_t taken = mask & ready;
    for (int i = 0; i < kCount; ++i) {
      Barrel& barrel = barrels_[i];
      if (barrel.turn(clock_, (mask >> i & 1) != 0) != ((ready >> i & 1) != 0)) ++barrel.wrong;
    }
    sim_.tick();
    ++clock_;
    for (int i = 0; i < kCount; ++i) watch(i, (taken >> i & 1) != 0);
  }

  std::vector<Barrel> barrels_;
  std::int64_t clock_ = 0;

 private:
  void watch(int i, bool started) {
    Barrel& barrel = barrels_[i];
    if (started) {
      barrel.inside.push_back({barrel.next++, -1, clock_ - barrel.vertices});
      ++barrel.started;
    }
    if ((sim_->valid_o >> i & 1) == 0) return;
    const std::uint8_t number = byte(sim_->vertex_o, i);
    for (Barrel::Inside& vertex : barrel.inside) {
      if (vertex.number != number) continue;
      ++vertex.step;
      const bool first = vertex.step == 0, last = vertex.step == barrel.steps - 1;
      const bool good = byte(sim_->step_o, i) == vertex.step &&
                        clock_ - vertex.clock == barrel.vertices &&
                        (sim_->first_o >> i & 1) == first && (sim_->last_o >> i & 1) == last;
      vertex.clock = clock_;
      if (!good) ++barrel.wrong;
      if (last) end(barrel, number);
      return;
    }
    ++barrel.wrong;
  }

  void end(Barrel& barrel, std::uint8_t number) {
    if (barrel.inside.front().number != number) ++barrel.wrong;
    barrel.inside.pop_front();
    ++barrel.ended;
    barrel.closest = std::min(barrel.closest, clock_ - barrel.last_end);
    barrel.last_end = clock_;
  }

  tb::Sim<Vsequencer_barrels> sim_{tb::seed_from_environment(1)};
};

std::string name(const Barrel& barrel) {
  return std::to_string(barrel.steps) + " steps, " + std::to_string(barrel.vertices) + " vertices";
}

void expect_good(const Barrel& barrel) {
  EXPECT_EQ(barrel.wrong, 0) << name(barrel);
  EXPECT_GT(barrel.ended, 20) << name(barrel);
  if (barrel.steps > kConverter) {
    EXPECT_GE(barrel.closest, kConverter) << name(barrel);
  }
}

TEST_F(Barrels, VerticesWithoutAPauseEnterAtTheFullRate) {
  constexpr std::int64_t kWarm = 64 * 8, kClocks = 64 * 8 * 4;
  std::vector<std::int64_t> before;
  for (std::int64_t i = 0; i < kWarm; ++i) tick(~std::uint64_t{0} >> (64 - kCount));
  for (const Barrel& barrel : barrels_) before.push_back(barrel.started);
  for (std::int64_t i = 0; i < kClocks; ++i) tick(~std::uint64_t{0} >> (64 - kCount));
  for (int i = 0; i < kCount; ++i) {
    const Barrel& barrel = barrels_[i];
    // A turn of the whole barrel more or less at both ends.
    EXPECT_NEAR(static_cast<double>(barrel.started - before[i]),
                static_cast<double>(kClocks) / barrel.steps, barrel.vertices)
        << name(barrel);
    expect_good(barrel);
  }
}

TEST_F(Barrels, VerticesAtRandomTimes) {
  tb::Random random(tb::seed_from_environment(1));
  for (int i = 0; i < 20000; ++i) {
    const auto mask = std::uint64_t{random.word()} << 32 | random.word();
    tick((i / 512 % 2 == 0 ? mask : mask & mask >> 3 & mask >> 5) >> (64 - kCount));
  }
  for (const Barrel& barrel : barrels_) expect_good(barrel);
}

}  // namespace
}  // namespace hwffd::test
