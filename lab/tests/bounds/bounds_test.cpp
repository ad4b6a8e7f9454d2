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

template <class Weights>
std::vector<Candidate> some_points(const Weights& weights, int count) {
  std::mt19937_64 engine(5);
  std::vector<Candidate> points;
  for (int i = 0; i < count; ++i) {
    Candidate candidate{axis_point<F>(weights, static_cast<std::uint32_t>(engine() >> 33)), 0, {}};
    for (int l = 0; l < 4; ++l)
      candidate.units[l] = std::llround(std::ldexp(candidate.point.weight[l], 14));
    points.push_back(candidate);
  }
  return points;
}

std::vector<Candidate> some_points(int count) {
  return some_points(Horner<F>("bspline", "fx16"), count);
}

double largest_of_all(const std::vector<Candidate>& first, const std::vector<Candidate>& others) {
  double largest = 0;
  for (const Candidate& s : first) {
    for (const Candidate& t : others) {
      for (const Candidate& u : others) largest = std::max(largest, exact_distance(s, t, u));
    }
  }
  return largest;
}

/// So many points a box.
std::vector<ErrorBox> boxes_of(const std::vector<Candidate>& points, std::size_t count) {
  std::vector<ErrorBox> boxes;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % count == 0) boxes.emplace_back();
    boxes.back().add(points[i].point.x, points[i].point.error());
  }
  return boxes;
}

void expect_found(const TripleBound& triples, double largest) {
  EXPECT_GE(triples.bound, largest);
  EXPECT_LE(triples.bound, 1.03 * largest);
  EXPECT_NEAR(triples.reached, largest, 0.03 * largest);
}

TEST(Triples, BranchAndBoundFindsTheLargest) {
  const auto points = some_points(40);
  expect_found(bound_triples(boxes_of(points, 1), 0.02), largest_of_all(points, points));
}

// Whichever axis has the weights of a derivative, Horner's or those of powers.
TEST(Triples, BranchAndBoundFindsTheLargestWithSlopes) {
  const auto points = some_points(40);
  for (const auto& slopes :
       {some_points(Slopes<F>("fx16"), 30), some_points(PowersSlopes<F>(), 30)}) {
    expect_found(bound_triples_with_slopes(boxes_of(slopes, 1), boxes_of(points, 1), 0.02),
                 largest_of_all(slopes, points));
  }
}

TEST(Triples, BoundsWhatLiesInBoxes) {
  const auto points = some_points(60);
  const auto slopes = some_points(Slopes<F>("fx16"), 40);
  EXPECT_GE(bound_triples(boxes_of(points, 2), 0.1).bound, largest_of_all(points, points));
  EXPECT_GE(bound_triples_with_slopes(boxes_of(slopes, 2), boxes_of(points, 2), 0.1).bound,
            largest_of_all(slopes, points));
}

TEST(Triples, NothingIsAnError) {
  EXPECT_THROW(bound_triples({}, 0.1), std::invalid_argument);
  EXPECT_THROW(bound_triples_with_slopes({}, boxes_of(some_points(2), 1), 0.1),
               std::invalid_argument);
}

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

using F17 = Fixed<17>;
constexpr double kHalfPart = 0x1p-17;

/// What is known of an axis: coordinates to try, the largest sum of the errors of its weights, and
/// the largest sum of the magnitudes of its functions.
struct KnownAxis {
  std::vector<Candidate> candidates;
  double error = 0;
  double size = 0;
};

template <class Weights>
KnownAxis known_axis(const Weights& weights, double size, std::mt19937_64& engine) {
  KnownAxis axis;
  axis.size = size;
  for (int i = 0; i < 400; ++i) {
    const int left = i % 4;
    const auto word = static_cast<std::uint32_t>(engine() >> 33);
    axis.candidates.push_back(
        {variant(axis_point<F17>(weights, word), left, Weights::kSum), 3 - left, {}});
    axis.error = std::max(axis.error, norm(axis.candidates.back().point.error()));
  }
  return axis;
}

/// What is climbed from some vertices, and what is proved of vertices whose weights are off by as
/// much as those of these axes.
struct Climbed {
  std::vector<Witness> witnesses;
  double largest = 0;
  double bound = 0;
};

/// @param derivative  the axis along which it is the gradient of the derivative, or -1
template <class Parts>
Climbed climbed(int derivative) {
  std::mt19937_64 engine(9);
  const KnownAxis plain = known_axis(Horner<F17>("bspline", "fx17"), 1, engine);
  const KnownAxis slopes = known_axis(Slopes<F17>("fx17"), 0.75, engine);
  std::array<const KnownAxis*, 3> known{&plain, &plain, &plain};
  if (derivative >= 0) known[static_cast<std::size_t>(derivative)] = &slopes;
  Climbed result;
  ScatterClimb<F17, Parts> climb(false, derivative);
  for (int start = 0; start < 20; ++start) {
    Triple triple;
    std::array<std::vector<Candidate>, 3> choice;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (int i = 0; i < 3; ++i) choice[axis].push_back(known[axis]->candidates[engine() % 400]);
      triple[axis] = choice[axis][0];
    }
    result.witnesses.push_back(
        climb.run(triple, {&choice[0], &choice[1], &choice[2]}, 2000, engine));
    result.largest = std::max(result.largest, result.witnesses.back().error);
  }
  std::array<double, 3> k{};
  for (std::size_t axis = 0; axis < 3; ++axis) k[axis] = known[axis]->size + known[axis]->error;
  const double all = k[0] * k[1] * k[2];
  result.bound = all - known[0]->size * known[1]->size * known[2]->size +
                 kHalfPart * (all + 6 * k[1] * k[2] + 24 * k[2] + 96);
  return result;
}

/// The sum of the errors of a component of what a model adds, in words.
double error_of(const model::VertexParts& added, const model::GradientWords& vertex) {
  std::array<Four, 3> exact;
  for (int axis = 0; axis < 3; ++axis) {
    const double x = std::ldexp(vertex.local[axis], -31);
    exact[axis] = axis == vertex.derivative ? half_slopes(x) : bounds::bspline(x);
  }
  double sum = 0;
  for (int p = 0; p < 64; ++p) {
    const double weight = exact[0][p / 16] * exact[1][p / 4 % 4] * exact[2][p % 4];
    const double gradient = std::ldexp(static_cast<std::int32_t>(vertex.gradient[0]), -31);
    sum += std::abs(std::ldexp(static_cast<double>(added.parts[p][0]), -16) - gradient * weight);
  }
  return sum;
}

/// Of a position (-1), or of the derivative along an axis.
class ScatterErrors : public ::testing::TestWithParam<int> {};

// The error that is climbed is that of the words, by the model that takes them as the core does,
// and what was climbed is within what is proved of it.
TEST_P(ScatterErrors, AreThoseOfTheModelAndWithinTheirBound) {
  const auto scatter = model::make_scatter_model(find_configuration("affine-fx17-overlapped"));
  const WordCodec codec("fx17");
  for (int axis = 0; axis < 3; ++axis) {
    scatter->load(axis, encode(watertight_bspline(codec), codec));
  }
  const Climbed found = climbed<model::RoundedParts<F17>>(GetParam());
  for (const Witness& witness : found.witnesses) {
    model::GradientWords vertex{witness.vertex.local, witness.vertex.cell, {witness.result, 0, 0}};
    vertex.derivative = GetParam();
    const model::VertexParts added = scatter->parts(vertex);
    EXPECT_FALSE(added.saturated);
    EXPECT_NEAR(witness.error, error_of(added, vertex), 1e-12);
  }
  EXPECT_GT(found.largest, 40 * kHalfPart);
  EXPECT_LT(found.largest, found.bound);
}

/// Shares that are rounded three digits too early.
struct CoarseParts : model::RoundedParts<F17> {
  static Part share(F17::Weight weight, Part part) {
    Part share = F17::share(weight, part);
    share.value = (share.value + 4) >> 3 << 3;
    return share;
  }
};

TEST_P(ScatterErrors, OfCoarserSharesAreBeyondTheirBound) {
  const Climbed found = climbed<CoarseParts>(GetParam());
  EXPECT_GT(found.largest, found.bound);
}

// A gradient that is expanded as one of a position where a derivative is meant, or along another
// axis, is off by far more than any bound.
TEST_P(ScatterErrors, OfAnotherDerivativeAreNoticed) {
  const auto scatter = model::make_scatter_model(find_configuration("affine-fx17-overlapped"));
  const WordCodec codec("fx17");
  for (int axis = 0; axis < 3; ++axis) {
    scatter->load(axis, encode(watertight_bspline(codec), codec));
  }
  model::GradientWords meant{{0x12345678, 0x6789ABCD, 0x3456789A}, {0, 1, 2}, {0x40000000, 0, 0}};
  meant.derivative = GetParam();
  for (int derivative = -1; derivative < 3; ++derivative) {
    model::GradientWords taken = meant;
    taken.derivative = derivative;
    const double error = error_of(scatter->parts(taken), meant);
    if (derivative == GetParam()) {
      EXPECT_LT(error, 0x1p-10);
    } else {
      EXPECT_GT(error, 0x1p-3);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, ScatterErrors, ::testing::Range(-1, 3), [](const auto& tested) {
  return tested.param < 0 ? std::string("Position") : std::string("Along") + "STU"[tested.param];
});

// In words of 12 bits, of all coordinates; both evaluators.
TEST(Scatter, IsSearchedInNarrowWords) {
  Effort effort;
  effort.form = "scatter";
  effort.format = "fx12";
  effort.starts = 2;
  effort.steps = 20'000;
  const Facts facts = find_facts(effort);
  std::vector<std::string> weights;
  for (const WeightsFact& fact : facts.weights) {
    weights.push_back(fact.weights);
    EXPECT_TRUE(fact.all);
  }
  EXPECT_EQ(weights, (std::vector<std::string>{"affine", "slopes", "affine slopes", "powers",
                                               "powers slopes"}));
  const auto fact_of = [&](const std::string& name) {
    return *std::find_if(facts.weights.begin(), facts.weights.end(),
                         [&](const WeightsFact& fact) { return fact.weights == name; });
  };
  std::size_t number = 0;
  for (const std::string evaluator : {"", " powers"}) {
    for (const std::string along : {"", " along s", " along t", " along u"}) {
      ASSERT_LT(number, facts.forms.size());
      const FormFact& form = facts.forms[number++];
      EXPECT_EQ(form.form, "scatter" + evaluator + along);
      const WeightsFact fact = fact_of((evaluator.empty() ? "affine" : "powers") +
                                       std::string(along.empty() ? "" : " slopes"));
      EXPECT_GT(form.witness.error, fact.reached);
      EXPECT_LT(form.witness.error, fact.distance + 130 * 0x1p-12);
    }
  }
  EXPECT_EQ(number, facts.forms.size());
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
