// Every organization at its read port: every bit against the model, clocks against the formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <ostream>
#include <stdexcept>
#include <string>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_bench.hpp"
#include "hwffd/tb/random.hpp"
#include "named.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

/// The rows that this build has and that give position and derivatives in one pass.
std::vector<Configuration> jacobian_rows() {
  return rows_where([](const Configuration& row) {
    return gives_jacobian(row) && cores::has_evaluator_core(row);
  });
}

/// The rows that this build has and that share what comes before s.
std::vector<Configuration> walk_rows() {
  return rows_where(
      [](const Configuration& row) { return walks(row) && cores::has_evaluator_core(row); });
}

/// The rows that this build has and that take no more than 64 clocks for a vertex.
std::vector<Configuration> quick_rows() {
  return rows_where([](const Configuration& row) {
    return expected_interval(row) <= 64 && cores::has_evaluator_core(row);
  });
}

/// The rows that this build has and that take a second vertex with each one.
std::vector<Configuration> pair_rows() {
  return rows_where(
      [](const Configuration& row) { return pairs(row) && cores::has_evaluator_core(row); });
}

/// The rows that this build has, or those of one schedule.
std::vector<Configuration> built_rows(const std::string& schedule = "") {
  return rows_where([&](const Configuration& row) {
    return (schedule.empty() || row.schedule == schedule) && cores::has_evaluator_core(row);
  });
}

/// Another family on each axis, and on each axis another one in either bank: whatever takes the
/// functions of a wrong axis or bank shows.
tb::EvaluatorBench::Bank families(const WordCodec& codec, int bank) {
  constexpr const char* kNames[2][3] = {{"bspline", "bernstein", "catmull-rom"},
                                        {"hermite", "bspline", "bernstein"}};
  tb::EvaluatorBench::Bank axes;
  for (int axis = 0; axis < 3; ++axis) {
    axes[axis] = encode(family(kNames[bank][axis], codec), codec);
  }
  return axes;
}

/// Functions of no family, so that each bit of a coefficient goes with each other one; large ones
/// saturate fixed point in one weight or component or another.
tb::EvaluatorBench::Bank any_functions(const WordCodec& codec, tb::Random& random) {
  tb::EvaluatorBench::Bank axes;
  for (AxisWords& axis : axes) {
    const double most = random.pick({0.25, 0.5, 1.0, 4.0});
    Blending::Matrix matrix;
    for (auto& function : matrix) {
      for (double& coefficient : function) coefficient = most * (2 * random.unit() - 1);
    }
    axis = encode(user_blending(matrix), codec);
  }
  return axes;
}

class Evaluator : public ::testing::TestWithParam<Configuration> {
 protected:
  Evaluator()
      : codec_(GetParam().format),
        core_(cores::make_evaluator_core(GetParam(), tb::seed_from_environment(1))),
        model_(model::make_evaluator_model(GetParam())),
        bench_(*core_, *model_, families(codec_, 0)) {
    bench_.load(1, families(codec_, 1));
  }

  /// Vertices of either bank; those together in a cell are of one.
  tb::EvaluatorStimulus draw(std::size_t vertices, std::uint64_t seed, std::size_t together = 1) {
    auto stimulus = tb::random_stimulus(codec_, vertices, seed, together);
    tb::Random random(tb::derive_seed(seed, together));
    int bank = 0;
    for (std::size_t v = 0; v < vertices; ++v) {
      if (v % together == 0) bank = random.chance(0.5) ? 1 : 0;
      stimulus.vertices[v].bank = bank;
    }
    return stimulus;
  }

  void expect_no_mismatch(std::size_t vertices) {
    EXPECT_EQ(bench_.checked(), vertices);
    EXPECT_EQ(bench_.mismatches(), 0U) << bench_.first_mismatch();
  }

  WordCodec codec_;
  std::unique_ptr<cores::EvaluatorCore> core_;
  std::unique_ptr<model::EvaluatorModel> model_;
  tb::EvaluatorBench bench_;
};

class PaperSchedule : public Evaluator {};
class Full : public Evaluator {
 protected:
  static constexpr std::uint64_t kInside = 256;  ///< of ffd_bench_evaluator

  /// As many as that were inside at once, or one fewer where they do not enter in each clock.
  void expect_full() {
    const auto& starts = bench_.start_clocks();
    const auto& results = bench_.result_clocks();
    std::uint64_t most = 0;
    for (std::size_t started = 0, left = 0; started < starts.size(); ++started) {
      while (left < results.size() && results[left] < starts[started]) ++left;
      most = std::max<std::uint64_t>(most, started + 1 - left);
    }
    EXPECT_GE(most, kInside - 1);
    EXPECT_LE(most, kInside);
  }

  const std::uint64_t interval_ = static_cast<std::uint64_t>(expected_interval(GetParam()) + 1);
};
class GivesJacobian : public Evaluator {};
class Walks : public Evaluator {
 protected:
  /// Runs of vertices that differ in s only, positions and derivatives along s mixed.
  tb::EvaluatorStimulus draw_runs(std::size_t runs, std::uint64_t seed, std::size_t together) {
    auto stimulus = draw(runs * together, seed, together);
    tb::Random random(seed);
    for (std::size_t v = 0; v < stimulus.vertices.size(); ++v) {
      auto& vertex = stimulus.vertices[v];
      vertex.derivative = random.chance(0.5) ? 0 : -1;
      for (int axis = 1; axis < 3; ++axis) {
        vertex.local[axis] = stimulus.vertices[v - v % together].local[axis];
      }
    }
    return stimulus;
  }
};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(GivesJacobian);  // no row of tier sim gives that
class Pairs : public Walks {};
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Walks);  // nor shares that
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Pairs);  // nor takes two

TEST_P(Evaluator, BitsUnderRandomStalls) {
  const auto stimulus = draw(share_of(800), tb::seed_from_environment(1));
  bench_.run(stimulus, tb::make_throttle("bernoulli", 1), tb::make_throttle("bursts", 2));
  bench_.run(stimulus, tb::make_throttle("long_stall", 3), tb::make_throttle("sparse", 4));
  expect_no_mismatch(2 * stimulus.vertices.size());
}

// Each vertex with the derivative functions of one axis, or of none: the position.
TEST_P(Evaluator, DerivativesUnderRandomStalls) {
  auto stimulus = draw(share_of(800), tb::seed_from_environment(2));
  tb::Random random(5);
  for (auto& vertex : stimulus.vertices) vertex.derivative = static_cast<int>(random.below(4)) - 1;
  bench_.run(stimulus, tb::make_throttle("bernoulli", 1), tb::make_throttle("bursts", 2));
  expect_no_mismatch(stimulus.vertices.size());
}

TEST_P(Evaluator, BitsOfAnyFunctions) {
  tb::Random random(tb::seed_from_environment(6));
  std::size_t vertices = 0;
  for (int part = 0; part < 4; ++part) {
    for (const int bank : {0, 1}) bench_.load(bank, any_functions(codec_, random));
    auto stimulus = draw(share_of(200), random.bits());
    for (auto& vertex : stimulus.vertices)
      vertex.derivative = static_cast<int>(random.below(4)) - 1;
    bench_.run(stimulus);
    vertices += stimulus.vertices.size();
  }
  expect_no_mismatch(vertices);
}

// One operand that is flagged, where nothing else saturates: a coordinate, a point, a coefficient.
TEST_P(Evaluator, AFlagOfOneOperand) {
  tb::EvaluatorBench::Bank quarters;
  for (AxisWords& axis : quarters) {
    for (int function = 0; function < 4; ++function) {
      axis.word[function][0] = axis.derivative.word[function][0] = codec_.coefficient(0.25, 0);
    }
  }
  auto stimulus = draw(1, 8);
  stimulus.supports.resize(1);
  stimulus.supports[0].points.fill(codec_.point(0.3));
  auto& vertex = stimulus.vertices[0];
  vertex.support = 0;
  vertex.bank = 0;
  vertex.local.fill(codec_.coordinate(0.99));
  const auto inside = vertex.local;
  std::size_t vertices = 0;
  bench_.load(0, quarters);
  for (int axis = 0; axis < 3; ++axis) {
    vertex.local[axis] = codec_.is_float() ? 0x3FC00000U : 0xA0000000U;  // 1.5 and 5/4
    bench_.run(stimulus);
    ++vertices;
    vertex.local = inside;
  }
  // The largest word rounds past the largest point, and past the largest coefficient.
  const bool rounds = codec_.has_fixed_weights() && codec_.weight_fraction() < 30;
  const auto points = stimulus.supports[0].points;
  for (std::size_t word = 0; rounds && !codec_.is_block() && word < points.size(); ++word) {
    stimulus.supports[0].points[word] = 0x7FFFFFFF;
    bench_.run(stimulus);
    ++vertices;
    stimulus.supports[0].points = points;
  }
  for (int operand = 0; rounds && operand < 3 * 2 * 4 * 4; ++operand) {
    const int axis = operand / 32;
    vertex.derivative = operand % 2 == 0 ? -1 : axis;
    auto bank = quarters;
    AxisWords& words = bank[axis];
    auto& function = (operand % 2 == 0 ? words.word : words.derivative.word)[operand / 8 % 4];
    function = {};
    function[operand / 2 % 4] = 0x7FFFFFFF;
    bench_.load(0, bank);
    bench_.run(stimulus);
    ++vertices;
  }
  expect_no_mismatch(vertices);
  const auto& results = bench_.results();
  const auto flagged = std::count_if(results.begin(), results.end(),
                                     [](const auto& result) { return result.saturated; });
  EXPECT_GE(flagged, !codec_.has_fixed_weights()       ? 0
                     : !rounds || wired_in(GetParam()) ? 3
                                                       : 3 + 72);
}

// Vertices that are offered while reset lasts, also where others are inside, are none: of resets
// that begin in any clock of a vertex, a clock long or two.
TEST_P(Evaluator, NothingEntersInReset) {
  tb::Random random(tb::seed_from_environment(9));
  constexpr std::size_t kResets = 16;
  for (std::size_t resets = 1; resets <= kResets; ++resets) {
    for (const bool reset : {false, true}) {
      core_->drive_reset(reset);
      core_->drive_vertex(true, {});
      core_->drive_result_ready(true);
      const std::uint64_t clocks = 1 + (reset ? random.below(2) : random.below(8 * resets));
      for (std::uint64_t i = 0; i < clocks; ++i) core_->clock();
    }
    core_->drive_reset(false);
    core_->drive_vertex(false, {});
    for (unsigned i = 0; i < 300; ++i) {
      core_->settle();
      ASSERT_FALSE(core_->result_valid()) << i;
      core_->clock();
    }
    auto after = draw(2, resets);
    after.supports.resize(1);
    for (auto& vertex : after.vertices) vertex.support = 0;
    bench_.run(after);
    expect_no_mismatch(2 * resets);
  }
}

// Every bit of a result, once; a result that is lost, one that comes twice.
TEST_P(Evaluator, PlantedFaultsAreFound) {
  constexpr unsigned kBits = 3 * 32 + 16 + 2;  // words, tag, flags
  tb::EvaluatorStimulus stimulus = draw(4, 3);
  stimulus.supports.resize(stimulus.vertices.size());
  std::uint64_t faults = 0;
  for (unsigned bit = 0; bit < kBits; ++bit) {
    bench_.plant({tb::Fault::Kind::kFlip, 1, bit});
    bench_.run(stimulus);
    EXPECT_EQ(bench_.mismatches(), ++faults) << "bit " << bit;
  }
  bench_.plant({tb::Fault::Kind::kDrop, 1, 0});
  EXPECT_THROW(bench_.run(stimulus), std::runtime_error);
  bench_.plant({tb::Fault::Kind::kDuplicate, 1, 0});
  bench_.run(stimulus);
  EXPECT_EQ(bench_.mismatches(), faults + 2) << "the last two results come a place late";
}

// While no result leaves; then all leave.
TEST_P(Full, NoMoreThanItHolds) {
  const auto stimulus = draw(2 * kInside, 11);
  bench_.run(stimulus, tb::Throttle::always(),
             tb::Throttle::shut_after(kInside / 2 * interval_, (kInside + 4) * interval_));
  expect_no_mismatch(stimulus.vertices.size());
  expect_full();
}

// One enters for each that leaves.
TEST_P(Full, StaysFull) {
  const auto stimulus = draw(5 * kInside / 2, 12);
  bench_.run(stimulus, tb::Throttle::always(), tb::Throttle::sparse(2 * interval_));
  expect_no_mismatch(stimulus.vertices.size());
  expect_full();
}

// A barrel of contexts spreads its starts within its round, so the interval is counted over a
// multiple of every number of contexts in the table.
TEST_P(Evaluator, IntervalEqualsTheFormula) {
  const std::size_t intervals = 120;
  const auto stimulus = draw(41 + intervals, 7);
  bench_.run(stimulus);
  expect_no_mismatch(stimulus.vertices.size());
  EXPECT_EQ(tb::mean_interval(bench_.result_clocks(), 40, lanes(GetParam())),
            expected_interval(GetParam()));
}

// A row of a lattice whose vertices go some cells on, or back, now and then.
TEST_P(Walks, BitsWhereARowGoesOn) {
  constexpr std::size_t kCells = 13, kLayer = 16;
  tb::Random random(tb::seed_from_environment(14));
  std::vector<std::uint32_t> points((kCells + 3) * kLayer * 3);
  for (auto& word : points) word = codec_.point(2 * random.unit() - 1);
  auto stimulus = draw(share_of(4000), 15);
  stimulus.supports.resize(kCells);
  for (std::size_t cell = 0; cell < kCells; ++cell) {
    std::copy_n(points.begin() + static_cast<std::ptrdiff_t>(cell * kLayer * 3), 4 * kLayer * 3,
                stimulus.supports[cell].points.begin());
  }
  int cell = 6;
  for (std::size_t v = 0; v < stimulus.vertices.size(); ++v) {
    auto& vertex = stimulus.vertices[v];
    vertex.cell = {cell, 0, 0};
    vertex.support = static_cast<std::uint8_t>(cell);
    vertex.bank = 0;
    vertex.derivative = random.chance(0.5) ? 0 : -1;
    for (int axis = 1; v > 0 && axis < 3 && !random.chance(0.01); ++axis) {
      vertex.local[axis] = stimulus.vertices[v - 1].local[axis];
    }
    if (random.chance(0.4)) {
      cell = std::clamp(cell + static_cast<int>(random.below(9)) - 4, 0, int{kCells} - 1);
    }
  }
  bench_.run(stimulus);
  bench_.run(stimulus, tb::make_throttle("bursts", 5), tb::make_throttle("bernoulli", 6));
  expect_no_mismatch(2 * stimulus.vertices.size());
}

// A vertex a clock in runs of as many as there are folds and more; shorter runs take as long as
// that.
TEST_P(Walks, ClocksOfRuns) {
  const std::uint64_t folded = folds(GetParam());
  std::size_t before = 0;
  for (const std::size_t together : {1, 2, 3, 5, 15, 16, 17, 40}) {
    bench_.run(draw_runs(12, together, together));
    const auto& clocks = bench_.result_clocks();
    for (std::size_t v = before; v + together < clocks.size(); v += together) {
      EXPECT_EQ(clocks[v + together] - clocks[v], std::max<std::uint64_t>(folded, together))
          << "run of " << together << ", vertex " << v - before;
    }
    before = clocks.size();
  }
  expect_no_mismatch(before);
}

// Long runs and storms of short ones: what a storm asks for waits for the run before it.
TEST_P(Walks, BitsOfStormsBehindRuns) {
  tb::Random random(tb::seed_from_environment(12));
  auto stimulus = draw(share_of(4000), 13);
  std::uint64_t run = 0, storm = 0;
  for (std::size_t v = 1; v < stimulus.vertices.size(); ++v) {
    if (run == 0 && storm == 0) run = 16 + random.below(80), storm = random.below(60);
    if (run > 0) {
      const auto own = stimulus.vertices[v].local[0];
      stimulus.vertices[v] = stimulus.vertices[v - 1];
      stimulus.vertices[v].local[0] = own;
      --run;
    } else {
      --storm;
    }
  }
  bench_.run(stimulus);
  bench_.run(stimulus, tb::make_throttle("bursts", 5), tb::make_throttle("long_stall", 6));
  expect_no_mismatch(2 * stimulus.vertices.size());
}

// Each of what a run shares ends it when it changes, alone: t, u, the cell, the support, the bank.
TEST_P(Walks, WhatEndsARun) {
  auto stimulus = draw_runs(60, tb::seed_from_environment(4), 4);
  tb::Random random(7);
  const auto other = draw(stimulus.vertices.size(), 9).vertices;
  for (std::size_t v = 2; v < stimulus.vertices.size(); v += 4) {
    auto& vertex = stimulus.vertices[v];
    switch (random.below(6)) {
      case 0:
        vertex.local[1] = other[v].local[1];
        break;
      case 1:
        vertex.local[2] = other[v].local[2];
        break;
      case 2:
        vertex.cell[random.below(3)] ^= 1;
        break;
      case 3:
        vertex.support ^= 1;
        break;
      case 4:
        vertex.bank ^= 1;
        break;
      default:
        vertex.derivative = 1 + static_cast<int>(random.below(2));
    }
  }
  bench_.run(stimulus, tb::make_throttle("bursts", 5), tb::make_throttle("bernoulli", 6));
  expect_no_mismatch(stimulus.vertices.size());
}

// A second vertex with some of the first ones, of any coordinate: both have the bits of a vertex by
// itself, and runs take the clocks of as many single ones.
TEST_P(Pairs, BitsAndClocksOfSecondVertices) {
  const std::uint64_t folded = folds(GetParam());
  std::size_t seconds = 0, before = 0;
  for (const std::size_t together : {1, 3, 16, 40}) {
    auto stimulus = draw_runs(share_of(400) / together + 2, together, together);
    tb::Random random(together);
    for (auto& vertex : stimulus.vertices) {
      if (random.chance(0.3)) continue;
      vertex.second = codec_.coordinate(random.chance(0.1) ? 1.0 : random.unit());
      ++seconds;
    }
    bench_.run(stimulus);
    const auto& clocks = bench_.result_clocks();
    for (std::size_t v = before; v + together < clocks.size(); v += together) {
      EXPECT_EQ(clocks[v + together] - clocks[v], std::max<std::uint64_t>(folded, together))
          << "run of " << together << ", vertex " << v - before;
    }
    before = clocks.size();
    bench_.run(stimulus, tb::make_throttle("bursts", 5), tb::make_throttle("bernoulli", 6));
    before = clocks.size();
  }
  EXPECT_GT(seconds, 0U);
  expect_no_mismatch(before + 2 * seconds);
}

// Four results in one pass, among vertices that want one of them, all with the bits of a pass of
// its own.
TEST_P(GivesJacobian, BitsAmongOtherVertices) {
  auto stimulus = draw(share_of(800), tb::seed_from_environment(2));
  tb::Random random(6);
  std::size_t whole = 0;
  for (auto& vertex : stimulus.vertices) {
    const int kind = static_cast<int>(random.below(8));
    vertex.jacobian = kind >= 4;
    if (kind < 4) vertex.derivative = kind - 1;
    whole += vertex.jacobian ? 1 : 0;
  }
  for (const char* source : {"always", "bernoulli", "gaps"}) {
    for (const char* sink : {"always", "bursts", "long_stall"}) {
      bench_.run(stimulus, tb::make_throttle(source, 1), tb::make_throttle(sink, 2));
    }
  }
  expect_no_mismatch(9 * (stimulus.vertices.size() + 3 * whole));
}

TEST_P(GivesJacobian, IntervalEqualsTheFormula) {
  const std::size_t intervals = 120;
  auto stimulus = draw(41 + intervals, 7);
  for (auto& vertex : stimulus.vertices) vertex.jacobian = true;
  bench_.run(stimulus);
  expect_no_mismatch(4 * stimulus.vertices.size());
  EXPECT_EQ(tb::mean_interval(bench_.result_clocks(), 40, lanes(GetParam())),
            expected_interval(GetParam()));
}

// At the paper's schedule no vertex starts before the one before it has ended: the result of one
// comes no later than its successor starts, but for the registers that carry it (at most 8).
TEST_P(PaperSchedule, DoesNotOverlap) {
  const auto stimulus = draw(20, 9);
  bench_.run(stimulus);
  expect_no_mismatch(stimulus.vertices.size());
  const auto& starts = bench_.start_clocks();
  const auto& results = bench_.result_clocks();
  for (std::size_t v = 0; v + 1 < stimulus.vertices.size(); ++v) {
    EXPECT_GE(results[v], starts[v + 1]) << "vertex " << v;
    EXPECT_LE(results[v], starts[v + 1] + 8) << "vertex " << v;
  }
}

INSTANTIATE_TEST_SUITE_P(, Evaluator, ::testing::ValuesIn(built_rows()), by_name);
INSTANTIATE_TEST_SUITE_P(, Full, ::testing::ValuesIn(quick_rows()), by_name);
INSTANTIATE_TEST_SUITE_P(, GivesJacobian, ::testing::ValuesIn(jacobian_rows()), by_name);
INSTANTIATE_TEST_SUITE_P(, Walks, ::testing::ValuesIn(walk_rows()), by_name);
INSTANTIATE_TEST_SUITE_P(, Pairs, ::testing::ValuesIn(pair_rows()), by_name);
INSTANTIATE_TEST_SUITE_P(, PaperSchedule, ::testing::ValuesIn(built_rows("paper")), by_name);

}  // namespace
}  // namespace hwffd::test
