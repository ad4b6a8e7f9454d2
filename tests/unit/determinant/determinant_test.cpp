// ffd_eval_determinant in fixed point against its model. A bit far down in a product reaches the
// result only where a cofactor lies next to a tie, once in thousands of vertices: hence so many,
// and a width so small that it happens all the time.
#include "hwffd/model/determinant.hpp"

#include <gtest/gtest.h>

#include <deque>

#include "Vdeterminant_18.h"
#include "Vdeterminant_8.h"
#include "hwffd/tb/sim.hpp"
#include "wide_words.hpp"

namespace hwffd::test {
namespace {

constexpr int kVertices = 500'000;

template <int W>
using Columns = std::array<model::VectorSum<Fixed<W>>, 3>;

/// Components that fit a point, most of them; some sums carry a flag or are too large.
template <int W>
Columns<W> random_columns(tb::Random& random) {
  const int width = random.chance(0.05) ? 2 * W + 2 : 2 * W - 2;
  Columns<W> columns;
  for (auto& column : columns) {
    for (auto& sum : column) {
      sum.value = static_cast<decltype(sum.value)>(corner_or_random(random, width));
      sum.saturated = random.chance(0.005);
    }
  }
  return columns;
}

/// `width` bits of a port of several words, from bit `low` on.
template <class Port>
void put_bits(Port& port, int low, int width, Int128 bits) {
  for (int i = 0; i < width; ++i) {
    const int word = (low + i) / 32, place = (low + i) % 32;
    const auto bit = static_cast<EData>(bits >> i & 1);
    port[word] = (port[word] & ~(EData{1} << place)) | bit << place;
  }
}

template <int W, class VDut>
class Bench {
 public:
  /// Sends a vertex, its columns in three clocks; the fourth is free.
  void send(const Columns<W>& columns) {
    expected_.push_back(model::determinant<Fixed<W>>(columns, 0));
    for (int axis = 0; axis < 3; ++axis) {
      for (int c = 0; c < 3; ++c) {
        const auto& sum = columns[axis][c];
        put_bits(sim_->column_i, c * (kSum + 1), kSum, sum.value);
        put_bits(sim_->column_i, c * (kSum + 1) + kSum, 1, sum.saturated ? 1 : 0);
      }
      sim_->column_valid_i = 1;
      sim_->column_last_i = axis == 2;
      step();
    }
    idle(1);
  }
  void idle(int clocks) {
    sim_->column_valid_i = 0;
    for (int i = 0; i < clocks; ++i) step();
  }
  int checked() const { return checked_; }
  int wrong() const { return wrong_; }

  Bench() {
    sim_->rst = 1;
    sim_->column_valid_i = sim_->column_last_i = 0;
    for (int i = 0; i < 40; ++i) sim_.tick();  // what went in before the reset has left
    sim_->rst = 0;
  }

 private:
  static constexpr int kSum = 2 * W + 6;  // bits of a sum, its flag in front of them

  void step() {
    sim_.tick();
    if (sim_->word_valid_o == 0) return;
    ASSERT_FALSE(expected_.empty());
    const OutWord& word = expected_.front();
    wrong_ += sim_->word_o != word.word || (sim_->saturated_o != 0) != word.saturated ? 1 : 0;
    ++checked_;
    expected_.pop_front();
  }

  tb::Sim<VDut> sim_{tb::seed_from_environment(1)};
  std::deque<OutWord> expected_;
  int checked_ = 0;
  int wrong_ = 0;
};

template <int W, class VDut>
void expect_determinants() {
  tb::Random random(tb::seed_from_environment(W));
  Bench<W, VDut> bench;
  for (int v = 0; v < kVertices; ++v) bench.send(random_columns<W>(random));
  bench.idle(60);
  EXPECT_EQ(bench.checked(), kVertices);
  EXPECT_EQ(bench.wrong(), 0);
}

TEST(Determinant, At8Bits) { expect_determinants<8, Vdeterminant_8>(); }
TEST(Determinant, At18Bits) { expect_determinants<18, Vdeterminant_18>(); }

}  // namespace
}  // namespace hwffd::test
