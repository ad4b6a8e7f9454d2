#include <gtest/gtest.h>

#include <random>

#include "boxes.hpp"
#include "coordinates.hpp"
#include "enumeration.hpp"
#include "facts.hpp"
#include "hwffd/model/org_factored.hpp"
#include "hwffd/model/scatter.hpp"
#include "hwffd/stream/blending.hpp"
#include "pairs.hpp"
#include "scatter_climb.hpp"
#include "triples.hpp"

namespace hwffd::certified {
namespace {

using F = Fixed<16>;

std::vector<Candidate> some_points(int count) {
  const Horner<F> horner("bspline", "fx16");
  std::mt19937_64 engine(5);
  std::vector<Candidate> points;
  for (int i = 0; i < count; ++i) {
    Candidate candidate{axis_point<F>(horner, static_cast<std::uint32_t>(engine() >> 33)), 0, {}};
    for (int l = 0; l < 4; ++l)
      candidate.units[l] = std::llround(std::ldexp(candidate.point.weight[l], 14));
    points.push_back(candidate);
  }
  return points;
}

double largest_of_all(const std::vector<Candidate>& points) {
  double largest = 0;
  for (const Candidate& s : points) {
    for (const Candidate& t : points) {
      for (const Candidate& u : points) largest = std::max(largest, exact_distance(s, t, u));
    }
  }
  return largest;
}

TEST(Triples, BranchAndBoundFindsTheLargest) {
  const auto points = some_points(40);
  std::vector<ErrorBox> boxes;
  for (const Candidate& candidate : points)
    boxes.emplace_back().add(candidate.point.x, candidate.point.error());
  const double largest = largest_of_all(points);
  const TripleBound triples = bound_triples(boxes, 0.02);
  EXPECT_GE(triples.bound, largest);
  EXPECT_LE(triples.bound, 1.03 * largest);
  EXPECT_NEAR(triples.reached, largest, 0.03 * largest);
}

TEST(Triples, BoundsWhatLiesInBoxes) {
  const auto points = some_points(60);
  std::vector<ErrorBox> boxes;
  for (std::size_t i = 0; i < points.size(); i += 2) {
    ErrorBox& box = boxes.emplace_back();
    for (const std::size_t j : {i, i + 1}) box.add(points[j].point.x, points[j].point.error());
  }
  EXPECT_GE(bound_triples(boxes, 0.1).bound, largest_of_all(points));
}

TEST(Triples, NothingIsAnError) { EXPECT_THROW(bound_triples({}, 0.1), std::invalid_argument); }

TEST(Pairs, RoundAsTheModelDoes) {
  const auto points = some_points(50);
  double largest = 0;
  for (const Candidate& s : points) {
    for (const Candidate& t : points) {
      double sum = 0;
      for (int i = 0; i < 16; ++i) {
        const int l = i / 4;
        const int m = i % 4;
        const auto product = F::mul({s.units[l], false}, {t.units[m], false});
        sum += std::abs(std::ldexp(static_cast<double>(product.value), -14) -
                        s.point.exact[l] * t.point.exact[m]);
      }
      largest = std::max(largest, sum);
    }
  }
  EXPECT_NEAR(largest_pair(points, 14), largest, 1e-12);
}

TEST(Coordinates, BothEndsAreRoundedToTheirNumber) {
  using C = Coordinates<F>;
  for (const std::int64_t k : {std::int64_t{1}, std::int64_t{77}, C::kLast - 1}) {
    for (const int end : {0, 1}) EXPECT_EQ(F::coordinate(C::word(k, end)).value, k);
    EXPECT_EQ(F::coordinate(C::word(k, 0) - 1).value, k - 1);
    EXPECT_EQ(F::coordinate(C::word(k, 1) + 1).value, k + 1);
  }
}

// What the search reports is what the model gives for the words it reports.
TEST(Search, ItsWitnessIsReproduced) {
  Effort effort;
  effort.form = "factored";
  effort.format = "fx16";
  effort.starts = 2;
  effort.steps = 20'000;
  const Facts facts = find_facts(effort);
  ASSERT_EQ(facts.forms.size(), 1U);
  const Witness& witness = facts.forms[0].witness;
  model::EvaluatorModelOf<F, model::OrgFactored> core{Configuration{}};
  const WordCodec codec("fx16");
  const AxisWords axis = encode(watertight_bspline(codec), codec);
  for (int a = 0; a < 3; ++a) {
    for (int l = 0; l < 4; ++l) core.load(0, a, l, axis.degree, axis.shift, axis.word[l]);
  }
  EXPECT_EQ(core.evaluate(0, witness.vertex).words[witness.component], witness.result);
  // More than half of what is proved of it, and no more.
  EXPECT_GT(witness.error, 5e-4);
  EXPECT_LT(witness.error, 7e-4);
}

// The error that is climbed is that of the words, by the model that takes them as the core does,
// and what was climbed is within what is proved of a vertex whose weights are off by as much as
// these.
TEST(Scatter, ItsErrorIsThatOfTheModelAndWithinItsBound) {
  using F17 = Fixed<17>;
  constexpr double kHalf = 0x1p-17;  // of a part
  const Configuration& row = find_configuration("affine-fx17-overlapped");
  const auto scatter = model::make_scatter_model(row);
  const WordCodec codec("fx17");
  const AxisWords words = encode(watertight_bspline(codec), codec);
  model::CoefficientBank<F17> bank;
  for (int axis = 0; axis < 3; ++axis) {
    scatter->load(axis, words);
    for (int l = 0; l < 4; ++l) bank.load(axis, l, words.degree, words.shift, words.word[l]);
  }
  const Horner<F17> horner("bspline", "fx17");
  std::mt19937_64 engine(9);
  std::vector<Candidate> candidates;
  double e = 0;  // the largest sum of the errors of an axis
  for (int i = 0; i < 400; ++i) {
    const int left = i % 4;
    const auto word = static_cast<std::uint32_t>(engine() >> 33);
    candidates.push_back({variant(axis_point<F17>(horner, word), left), 3 - left, {}});
    e = std::max(e, norm(candidates.back().point.error()));
  }
  ScatterClimb<F17> climb(bank, false);
  double largest = 0;
  for (int start = 0; start < 20; ++start) {
    const Triple triple{candidates[engine() % 400], candidates[engine() % 400],
                        candidates[engine() % 400]};
    const Witness witness = climb.run(triple, {triple.begin(), triple.end()}, 2000, engine);
    model::GradientWords vertex;
    vertex.local = witness.vertex.local;
    vertex.cell = witness.vertex.cell;
    vertex.gradient = {witness.result, 0, 0};
    const model::VertexParts added = scatter->parts(vertex);
    EXPECT_FALSE(added.saturated);
    double sum = 0;
    std::array<Four, 3> exact;
    for (int axis = 0; axis < 3; ++axis)
      exact[axis] = bounds::bspline(std::ldexp(vertex.local[axis], -31));
    for (int p = 0; p < 64; ++p) {
      const double weight = exact[0][p / 16] * exact[1][p / 4 % 4] * exact[2][p % 4];
      const double gradient = std::ldexp(static_cast<std::int32_t>(witness.result), -31);
      sum += std::abs(std::ldexp(static_cast<double>(added.parts[p][0]), -16) - gradient * weight);
    }
    EXPECT_NEAR(witness.error, sum, 1e-12);
    largest = std::max(largest, sum);
  }
  const double k = 1 + e;
  EXPECT_GT(largest, 40 * kHalf);
  EXPECT_LT(largest, k * k * k - 1 + kHalf * (k * k * k + 6 * k * k + 24 * k + 96));
}

// In words of 12 bits, of all coordinates; both evaluators.
TEST(Scatter, IsSearchedInNarrowWords) {
  Effort effort;
  effort.form = "scatter";
  effort.format = "fx12";
  effort.starts = 2;
  effort.steps = 20'000;
  const Facts facts = find_facts(effort);
  ASSERT_EQ(facts.weights.size(), 2U);
  ASSERT_EQ(facts.forms.size(), 2U);
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(facts.weights[i].weights, i == 0 ? "affine" : "powers");
    EXPECT_EQ(facts.forms[i].form, i == 0 ? "scatter" : "scatter powers");
    EXPECT_TRUE(facts.weights[i].all);
    EXPECT_GT(facts.forms[i].witness.error, facts.weights[i].reached);
    EXPECT_LT(facts.forms[i].witness.error, facts.weights[i].distance + 130 * 0x1p-12);
  }
}

TEST(Search, NothingIsFoundOfAFormThatIsNone) {
  Effort effort;
  effort.form = "none";
  effort.format = "fx16";
  const Facts facts = find_facts(effort);
  EXPECT_TRUE(facts.forms.empty() && facts.weights.empty());
}

}  // namespace
}  // namespace hwffd::certified
