// Eight vertices at once have the bits of one: every operation over all numbers of 8 bits, and
// every row of the table over vertices of a lattice.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdio>
#include <random>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd {
namespace {

using One = Fixed<8>;
using Eight = Fixed<8, Lanes>;

constexpr std::int64_t kLeast = -128;
constexpr std::int64_t kMost = 127;

/// Compares eight results of a lane with those of one number each.
class Compared {
 public:
  template <class Laned, class Scalar>
  void same(const Laned& lanes, const std::array<Scalar, kLanes>& scalars, const char* what) {
    for (int lane = 0; lane < kLanes; ++lane) {
      ASSERT_EQ(lanes.value[lane], scalars[lane].value) << what;
      ASSERT_EQ(lanes.saturated[lane], scalars[lane].saturated ? -1 : 0) << what;
      ++count_;
    }
  }
  std::uint64_t count() const { return count_; }

 private:
  std::uint64_t count_ = 0;
};

/// Eight numbers from `first` on, the last ones of them flagged where `flagged` has its bits.
template <class Laned, class Scalar>
void fill(Laned& lanes, std::array<Scalar, kLanes>& scalars, std::int64_t first, unsigned flagged) {
  for (int lane = 0; lane < kLanes; ++lane) {
    const bool flag = (flagged >> lane & 1) != 0;
    scalars[lane].value = first + lane;
    scalars[lane].saturated = flag;
    lanes.value[lane] = first + lane;
    lanes.saturated[lane] = flag ? -1 : 0;
  }
}

template <class Operation>
std::array<decltype(std::declval<Operation>()(0)), kLanes> each(Operation operation) {
  std::array<decltype(operation(0)), kLanes> results;
  for (int lane = 0; lane < kLanes; ++lane) results[lane] = operation(lane);
  return results;
}

TEST(Lanes, ProductsOfAllNumbersOfEightBits) {
  Compared compared;
  for (std::int64_t first = kLeast; first <= kMost; first += kLanes) {
    Eight::Number a;
    std::array<One::Number, kLanes> a1;
    fill(a, a1, first, 0x11);
    for (std::int64_t b = kLeast; b <= kMost; ++b) {
      const One::Number b1{b, b == 7};
      const Eight::Number b8{everywhere<Lanes>(b), everywhere<Lanes>(b == 7 ? -1 : 0)};
      compared.same(Eight::mul(a, b8), each([&](int i) { return One::mul(a1[i], b1); }), "mul");
      compared.same(Eight::term(a, b8), each([&](int i) { return One::term(a1[i], b1); }), "term");
      for (std::int64_t c = kLeast; c <= kMost; c += 5) {
        const One::Number c1{c, c == 2};
        const Eight::Number c8{everywhere<Lanes>(c), everywhere<Lanes>(c == 2 ? -1 : 0)};
        compared.same(Eight::step(c8, a, b8), each([&](int i) { return One::step(c1, a1[i], b1); }),
                      "step");
      }
    }
    for (int shift = 0; shift <= 3; ++shift) {
      compared.same(Eight::scale(a, shift), each([&](int i) { return One::scale(a1[i], shift); }),
                    "scale");
    }
  }
  std::printf("%llu results\n", static_cast<unsigned long long>(compared.count()));
  EXPECT_EQ(compared.count(), 256U * (256 * (2 + 52) + 4));
}

TEST(Lanes, RoundingsOfAllSumsOfEightBits) {
  Compared compared;
  constexpr std::int64_t kEnd = std::int64_t{1} << (2 * 8 + 5);
  for (std::int64_t first = -kEnd; first < kEnd; first += kLanes) {
    Eight::Sum sum;
    std::array<One::Sum, kLanes> scalars;
    fill(sum, scalars, first, 0x80);
    compared.same(Eight::narrow(sum), each([&](int i) { return One::narrow(scalars[i]); }),
                  "narrow");
    compared.same(Eight::out_units(sum), each([&](int i) { return One::out_units(scalars[i]); }),
                  "out");
  }
  std::printf("%llu results\n", static_cast<unsigned long long>(compared.count()));
  EXPECT_EQ(compared.count(), 2U * 2 * kEnd);
}

TEST(Lanes, WordsOfPoints) {
  Compared compared;
  for (std::int64_t word = INT32_MIN; word <= INT32_MAX; word += 65521) {
    Lanes units = everywhere<Lanes>(word);
    units = units < INT32_MAX - kLanes ? units + Lanes{0, 1, 2, 3, 4, 5, 6, 7} : units;
    compared.same(Eight::point_of_units(units),
                  each([&](int i) { return One::point(static_cast<std::uint32_t>(units[i])); }),
                  "point");
  }
  EXPECT_GT(compared.count(), 500000U);
}

/// A lattice of random words of a format, and vertices of it.
struct Scene {
  explicit Scene(const WordCodec& codec, std::mt19937_64& engine) {
    points.dims = {6, 5, 7};
    points.exponent = 3;
    std::uniform_real_distribution<double> place(-0.95, 0.95);
    for (int p = 0; p < 6 * 5 * 7; ++p) {
      const bool wild = engine() % 50 == 0;
      ResidentPoints::Point words{};
      for (std::uint32_t& word : words) {
        word = wild ? static_cast<std::uint32_t>(engine()) : codec.point(place(engine));
      }
      points.points.push_back(words);
    }
    std::uniform_real_distribution<double> unit(0, 1);
    vertices.resize(257);
    for (model::ResidentVertex& vertex : vertices) {
      for (int axis = 0; axis < 3; ++axis) {
        vertex.cell[axis] = static_cast<int>(engine() % (points.dims[axis] - 3U));
        vertex.local[axis] =
            codec.coordinate(engine() % 9 == 0 ? double(engine() % 2) : unit(engine));
      }
      if (engine() % 40 == 0) vertex.local[1] = static_cast<std::uint32_t>(engine());
    }
  }
  using ResidentPoints = model::ResidentPoints;
  ResidentPoints points;
  std::vector<model::ResidentVertex> vertices;
};

TEST(Lanes, EveryRowGivesTheBitsOfOneVertex) {
  std::mt19937_64 engine(11);
  std::uint64_t compared = 0;
  std::uint64_t saturated = 0;
  for (const Configuration& row : configurations()) {
    const WordCodec codec(row.format);
    const auto evaluator = model::make_evaluator_model(row);
    const AxisWords axis = encode(watertight_bspline(codec), codec);
    for (int a = 0; a < 3; ++a) {
      for (int f = 0; f < 4; ++f) {
        evaluator->load(1, a, f, axis.degree, axis.shift, axis.word[f]);
        evaluator->load_derivative(1, a, f, axis.degree, axis.derivative.shift,
                                   axis.derivative.word[f]);
      }
    }
    const Scene scene(codec, engine);
    for (int derivative = -1; derivative < 3; ++derivative) {
      std::vector<model::ResultWords> results;
      evaluator->evaluate(1, scene.points, scene.vertices, derivative, results);
      ASSERT_EQ(results.size(), scene.vertices.size());
      for (std::size_t v = 0; v < results.size(); ++v) {
        model::VertexWords vertex = model::with_support(scene.points, scene.vertices[v]);
        vertex.derivative = derivative;
        const model::ResultWords wanted = evaluator->evaluate(1, vertex);
        ASSERT_EQ(results[v].words, wanted.words) << row.name << ", vertex " << v;
        ASSERT_EQ(results[v].saturated, wanted.saturated) << row.name << ", vertex " << v;
        ASSERT_EQ(results[v].nan, wanted.nan) << row.name << ", vertex " << v;
        ++compared;
        saturated += wanted.saturated ? 1 : 0;
      }
    }
  }
  std::printf("%llu results, %llu saturated\n", static_cast<unsigned long long>(compared),
              static_cast<unsigned long long>(saturated));
  EXPECT_EQ(compared, configurations().size() * 4 * 257);
  EXPECT_GT(saturated, 1000U);
}

}  // namespace
}  // namespace hwffd
