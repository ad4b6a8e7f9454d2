// ffd_scatter_core against hwffd::model::ScatterModel and ScatterPage, bit for bit and clock for
// clock: vertices in any cell of any page, while pages begin, are swept and are collected.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "Vscatter_core_fx12.h"
#include "Vscatter_core_fx17_powers.h"
#include "Vscatter_core_rows_fx12.h"
#include "Vscatter_core_rows_fx17_powers.h"
#include "hwffd/stream/blending.hpp"
#include "scatter_core_bench.hpp"
#include "share.hpp"
#ifdef HWFFD_TIER_ALL
#include "Vscatter_core_fx17.h"
#include "Vscatter_core_fx18.h"
#include "Vscatter_core_rows_fx18.h"
#endif

namespace hwffd::test {
namespace {

/// As in CMakeLists.txt.
template <class VDut, int Width, bool Powers, int Mul, int Add, int Axis, int Pages,
          bool Rows = false>
struct Setup {
  using Dut = VDut;
  static constexpr int kWidth = Width, kMul = Mul, kAdd = Add, kAxis = Axis, kPages = Pages;
  static constexpr bool kPowers = Powers, kRows = Rows;
  static constexpr int kVertexClocks = Rows ? 4 * 3 : 3;  ///< of one by itself: four layers
  static constexpr int kAxisBits = Axis > 16 ? 5 : 4;
  static constexpr int kPlaces = Axis > 16 ? 512 : Axis > 8 ? 64 : 8;  ///< of a page, in a bank
};
using Setups = ::testing::Types<
#ifdef HWFFD_TIER_ALL
    Setup<Vscatter_core_fx17, 17, false, 4, 1, 16, 2>,
    Setup<Vscatter_core_fx18, 18, false, 3, 2, 20, 1>,
    Setup<Vscatter_core_rows_fx18, 18, false, 3, 2, 20, 1, true>,
#endif
    Setup<Vscatter_core_fx12, 12, false, 2, 1, 16, 3>,
    Setup<Vscatter_core_fx17_powers, 17, true, 4, 1, 16, 2>,
    Setup<Vscatter_core_rows_fx12, 12, false, 2, 1, 8, 3, true>,
    Setup<Vscatter_core_rows_fx17_powers, 17, true, 4, 1, 16, 2, true>>;

struct Name {
  template <class S>
  static std::string GetName(int) {  // NOLINT(readability-identifier-naming): gtest's
    return (S::kRows ? "rows_fx" : "fx") + std::to_string(S::kWidth) +
           (S::kPowers ? "_powers" : "");
  }
};

template <class S>
class ScatterCore : public ::testing::Test {
 protected:
  using Bench = ScatterCoreBench<S>;
  using Vertex = typename Bench::Vertex;

  ScatterCore() {
    load(0, {"bspline", "bernstein", "catmull-rom"});
    load(1, {"catmull-rom", "bspline", "linear"});
  }

  void load(int bank, const std::array<std::string, 3>& names) {
    typename Bench::Functions functions;
    for (int axis = 0; axis < 3; ++axis) {
      functions[axis] = encode(family(names[axis], codec_), codec_);
    }
    bench_.load(bank, functions);
  }

  /// Functions of no family, as large as coefficients can be or `most`.
  void load_any(int bank, double most) {
    typename Bench::Functions functions;
    for (AxisWords& axis : functions) {
      Blending::Matrix matrix;
      for (auto& function : matrix) {
        for (double& coefficient : function) coefficient = most * (2 * random_.unit() - 1);
      }
      axis = encode(user_blending(matrix), codec_);
    }
    bench_.load(bank, functions);
  }

  /// So many clocks of vertices, begins and collects of any page at once; then all is collected. A
  /// sweep has only what vertices leave, so a begin that waits long for one keeps them out, as the
  /// order of packets does.
  /// @param operations  how often one of them is wanted, in a clock
  /// @param of_begins   how many of these are begins
  void run(std::uint64_t clocks, const std::string& source_name, const std::string& sink_name,
           double operations, double of_begins = 0.5) {
    auto source = tb::make_throttle(source_name, random_.bits());
    auto sink = tb::make_throttle(sink_name, random_.bits());
    std::optional<std::pair<int, bool>> pending;  // of a page: whether it begins or is collected
    constexpr std::uint64_t kLong = 2000;
    std::uint64_t since = 0;
    const std::uint64_t end = bench_.clocks() + clocks;
    while (bench_.clocks() < end || pending) {
      if (!pending) since = bench_.clocks();
      if (!pending && random_.chance(operations)) {
        pending = {static_cast<int>(random_.below(S::kPages)), random_.chance(of_begins)};
      }
      if (pending && pending->second && bench_.may_begin(pending->first)) {
        bench_.begin(pending->first);
        ++begins_;
        pending.reset();
      } else if (pending && !pending->second && bench_.may_collect(pending->first)) {
        bench_.collect(pending->first, static_cast<int>(random_.below(4)));
        pending.reset();
      }
      if (source.willing() && !bench_.offering()) {
        const auto page = static_cast<int>(random_.below(S::kPages));
        const bool waits = pending && (pending->first == page || bench_.clocks() - since > kLong);
        if (!bench_.planned() && !waits && !bench_.collected(page)) bench_.plan(page);
        if (bench_.planned()) bench_.offer_planned();
      }
      bench_.clock(sink.willing());
    }
    while (bench_.planned() || bench_.offering()) {
      if (!bench_.offering()) bench_.offer_planned();
      bench_.clock(sink.willing());
    }
    bench_.drain(sink);
    collect_all(sink);
  }

  void collect_all(tb::Throttle sink = tb::Throttle::always()) {
    for (int page = 0; page < S::kPages; ++page) {
      bench_.collect(page, static_cast<int>(random_.below(4)));
      bench_.drain(sink);
    }
  }

  void send(const Vertex& vertex) {
    bench_.offer(vertex);
    while (bench_.offering()) bench_.clock();
  }

  void expect_no_mismatch() {
    EXPECT_EQ(bench_.mismatches(), 0U) << bench_.first_mismatch();
    RecordProperty("vertices", std::to_string(bench_.checked_vertices()));
    RecordProperty("points", std::to_string(bench_.checked_words()));
    EXPECT_GT(bench_.checked_words(), 0U);
  }

  WordCodec codec_{"fx" + std::to_string(S::kWidth)};
  tb::Random random_{tb::seed_from_environment(1)};
  Bench bench_{tb::seed_from_environment(1)};
  std::uint64_t begins_ = 0;
};
TYPED_TEST_SUITE(ScatterCore, Setups, Name);

TYPED_TEST(ScatterCore, BitsUnderRandomStalls) {
  const std::uint64_t clocks = share_of(60'000);
  this->run(clocks, "always", "always", 0.002);
  this->run(clocks, "bernoulli", "bursts", 0.005);
  this->run(clocks, "bursts", "long_stall", 0.02);
  this->run(clocks, "sparse", "bernoulli", 0.002);
  this->expect_no_mismatch();
  EXPECT_GT(this->bench_.checked_vertices(), clocks / 10);
  if (TypeParam::kRows) {
    EXPECT_GT(this->bench_.checked_rows(), clocks / 60);
  }
  EXPECT_GT(this->begins_, 4U);
}

// Epochs turn as soon as they may, while vertices of other pages go on.
TYPED_TEST(ScatterCore, BeginsAsOftenAsTheyMay) {
  const std::uint64_t clocks = share_of(200'000);
  this->run(clocks, "sparse", "always", 0.9, 0.98);
  this->expect_no_mismatch();
  EXPECT_GT(this->begins_, clocks / (15 * TypeParam::kPlaces));
}

TYPED_TEST(ScatterCore, BitsOfAnyFunctions) {
  for (const double most : {0.5, 2.0, 16.0}) {
    for (const int bank : {0, 1}) this->load_any(bank, most);
    this->run(share_of(20'000), "always", "bernoulli", 0.002);
  }
  this->expect_no_mismatch();
  if (!TypeParam::kPowers) {
    EXPECT_GT(this->bench_.saturated_vertices(), this->bench_.checked_vertices() / 4);
    if (TypeParam::kRows) {
      EXPECT_GT(this->bench_.saturated_layers(), share_of(1000));
    }
  }
}

// A point of each component alone, with gradients as large as can be over and over again: more than
// 32 bits. Vertices lie on corners of cells: functions that are constant give all to one point, the
// B-spline 8/27 to the one beside it. Narrow words want a million vertices.
TYPED_TEST(ScatterCore, SumsBeyondAWordSaturate) {
  constexpr bool kNarrow = TypeParam::kWidth < 17, kPowers = TypeParam::kPowers;
  if ((TypeParam::kRows && (kNarrow || kPowers)) || (kNarrow && share_of(2) < 2)) {
    GTEST_SKIP() << "millions of clocks";
  }
  constexpr int kWhole = (1 << (32 - TypeParam::kWidth)) + 600;
  constexpr int kVertices = kPowers ? kWhole / 8 * 27 : kWhole;
  this->load(0, {"constant", "constant", "constant"});
  auto vertex = this->bench_.draw(0);
  vertex.bank = 0;
  for (const int shift : {0, 1}) {  // halved they fit, where there is time to send them again
    if (shift == 1 && (kNarrow || kPowers)) break;
    // A page that was collected has another size.
    this->bench_.resize(0, {TypeParam::kAxis, TypeParam::kAxis, TypeParam::kAxis});
    for (int c = 0; c < 3; ++c) {
      vertex.words = {{0, 0, 0}, {4 * c, 4 * c, 4 * c}, {0, 0, 0}, -1};
      vertex.words.gradient[c] = c == 1 ? 0x7FFF0000 : 0x80000000;
      for (int v = 0; v < kVertices; ++v) this->send(vertex);
    }
    this->bench_.drain();
    this->bench_.collect(0, shift);
    this->bench_.drain();
    EXPECT_EQ(this->bench_.saturated_words(), 3U);
  }
  this->expect_no_mismatch();
}

TYPED_TEST(ScatterCore, EveryCellOfEveryPage) {
  std::uint64_t cells = 0;
  for (int page = 0; page < TypeParam::kPages; ++page) {
    constexpr int kAxis = TypeParam::kAxis;
    this->bench_.resize(page, {kAxis, kAxis, kAxis});
    for (int cell = 0; cell < (kAxis - 3) * (kAxis - 3) * (kAxis - 3); ++cell) {
      auto vertex = this->bench_.draw(page);
      vertex.words.cell = {cell / (kAxis - 3) / (kAxis - 3), cell / (kAxis - 3) % (kAxis - 3),
                           cell % (kAxis - 3)};
      this->send(vertex);
      ++cells;
    }
  }
  this->bench_.drain();
  this->collect_all();
  this->expect_no_mismatch();
  EXPECT_EQ(this->bench_.checked_vertices(), cells);
}

// A vertex in every third clock, or one that is a row in twelve, none sooner; with a collect beside
// it in every sixth. That each has added in its clock is what the bench looks at.
TYPED_TEST(ScatterCore, AVertexEveryThirdClock) {
  this->bench_.drain();
  std::vector<std::uint64_t> entered;
  while (entered.size() < 1000) {
    if (!this->bench_.offering()) this->bench_.offer(this->bench_.draw(0));
    this->bench_.clock();
    if (this->bench_.entered()) entered.push_back(this->bench_.clocks());
  }
  // What a core with rows has room for comes sooner.
  for (std::size_t v = TypeParam::kRows ? 100 : 1; v < entered.size(); ++v) {
    ASSERT_EQ(entered[v] - entered[v - 1], static_cast<std::uint64_t>(TypeParam::kVertexClocks));
  }
  while (this->bench_.offering()) this->bench_.clock();
  this->bench_.drain();
  this->collect_all();
  this->expect_no_mismatch();
}

// A row as often as it may: as many clocks as it has vertices, or three for each of its layers.
TYPED_TEST(ScatterCore, ARowTakesItsVerticesOrItsLayers) {
  if constexpr (TypeParam::kRows) {
    using Row = std::vector<typename TestFixture::Vertex>;
    this->bench_.drain();
    int of_vertices = 0, of_layers = 0;
    for (int shape = 0; shape < 60; ++shape) {
      constexpr int kAxis = TypeParam::kAxis;
      this->bench_.resize(0, {kAxis, 4, 4});
      const Row row = this->bench_.draw_row(0);
      std::vector<bool> touched(kAxis);
      for (const auto& vertex : row) {
        for (int l = 0; l < 4; ++l)
          touched[static_cast<std::size_t>(vertex.words.cell[0]) + l] = true;
      }
      const auto layers =
          static_cast<std::uint64_t>(std::count(touched.begin(), touched.end(), true));
      const std::uint64_t clocks = std::max<std::uint64_t>(row.size(), 3 * layers);
      ++(row.size() > 3 * layers ? of_vertices : of_layers);
      // Until a row more than it ends waits in front of what is slower.
      constexpr int kBefore = 280, kRows = 30;
      std::vector<std::uint64_t> began;
      while (began.size() < kBefore + kRows + 1) {
        this->bench_.plan(row);
        while (this->bench_.planned()) {
          this->bench_.offer_planned();
          const bool first = this->bench_.planned_count() + 1 == row.size();
          while (this->bench_.offering()) this->bench_.clock();
          if (first) began.push_back(this->bench_.clocks());
        }
      }
      this->bench_.drain();
      ASSERT_EQ(began[kBefore + kRows] - began[kBefore], kRows * clocks)
          << row.size() << " vertices, " << layers << " layers";
      this->bench_.collect(0, 0);
      this->bench_.drain();
    }
    this->expect_no_mismatch();
    EXPECT_GT(of_vertices, 0);
    EXPECT_GT(of_layers, 0);
  }
}

TYPED_TEST(ScatterCore, ACollectTakesEverySecondSlot) {
  if constexpr (TypeParam::kPages > 1) {
    this->bench_.drain();
    constexpr int kPoints = 8 * 8 * 8;
    this->bench_.resize(0, {8, 8, 8});
    this->bench_.collect(0, 0);
    const std::uint64_t start = this->bench_.clocks();
    int vertices = 0;
    do {
      if (!this->bench_.offering()) this->bench_.offer(this->bench_.draw(1));
      this->bench_.clock();
      if (this->bench_.entered()) ++vertices;
    } while (this->bench_.collected(0));
    const auto clocks = static_cast<int>(this->bench_.clocks() - start);
    EXPECT_LE(clocks, 6 * kPoints + 100);
    EXPECT_GE(vertices, clocks / (2 * TypeParam::kVertexClocks) - 1);
    while (this->bench_.offering()) this->bench_.clock();
    this->bench_.drain();
    // Nobody reads the words of another: vertices have all slots.
    this->bench_.collect(0, 0);
    for (int clock = 0; clock < 300; ++clock) {
      if (!this->bench_.offering()) this->bench_.offer(this->bench_.draw(1));
      this->bench_.clock(false);
    }
    vertices = 0;
    for (int clock = 0; clock < 300; ++clock) {
      if (!this->bench_.offering()) this->bench_.offer(this->bench_.draw(1));
      this->bench_.clock(false);
      if (this->bench_.entered()) ++vertices;
    }
    EXPECT_EQ(vertices, 300 / TypeParam::kVertexClocks);
    while (this->bench_.offering()) this->bench_.clock();
    this->bench_.drain();
    this->collect_all();
    this->expect_no_mismatch();
  }
}

TYPED_TEST(ScatterCore, ASweepHasThreeClocksAPlace) {
  this->bench_.drain();
  this->bench_.begin(0);
  this->bench_.clock();
  int clocks = 0;
  for (; this->bench_.sweeping(); ++clocks) this->bench_.clock();
  EXPECT_GE(clocks, 3 * TypeParam::kPlaces - 2);
  EXPECT_LE(clocks, 3 * TypeParam::kPlaces);
  // A core that was never told anything else has cleared all pages, while no vertex may enter.
  this->bench_.reset(1);
  clocks = 0;
  for (; this->bench_.sweeping(); ++clocks) {
    ASSERT_TRUE(TypeParam::kRows || !this->bench_.ready());
    this->bench_.clock();
  }
  EXPECT_GE(clocks, 3 * TypeParam::kPages * TypeParam::kPlaces - 2);
  EXPECT_LE(clocks, 3 * TypeParam::kPages * TypeParam::kPlaces + 2);
  this->collect_all();
  this->expect_no_mismatch();
}

TYPED_TEST(ScatterCore, AResetAtAnyMomentLeavesNothing) {
  for (int round = 0; round < 12; ++round) {
    const auto clocks = 200 + this->random_.below(400);
    for (std::uint64_t clock = 0; clock < clocks; ++clock) {
      if (!this->bench_.offering()) {
        const auto page = static_cast<int>(this->random_.below(TypeParam::kPages));
        if (!this->bench_.collected(page)) this->bench_.offer(this->bench_.draw(page));
      }
      if (clock + 80 == clocks && this->bench_.may_begin(0)) this->bench_.begin(0);
      this->bench_.clock(this->random_.chance(0.5));
    }
    if (round % 2 == 0) {
      while (this->bench_.offering()) this->bench_.clock();
      this->bench_.drain();
      this->bench_.collect(0, 0);
      for (std::uint64_t clock = this->random_.below(100); clock > 0; --clock) {
        this->bench_.clock(this->random_.chance(0.5));
      }
    }
    this->bench_.reset(1 + round % 3);
    if (round % 3 != 0) this->collect_all();
    this->run(500, "always", "bernoulli", 0.01);
  }
  this->expect_no_mismatch();
}

// What a set of vertices adds, in a thousand orders and at any pace: each collect is the model's,
// and all are the same.
TYPED_TEST(ScatterCore, AnyOrderGivesTheSameSums) {
  constexpr std::array<int, 3> kDims = {5, 4, 4};
  this->bench_.resize(0, kDims);
  std::vector<typename TestFixture::Vertex> vertices;
  for (int v = 0; v < 8; ++v) vertices.push_back(this->bench_.draw(0));
  constexpr std::uint64_t kOrders = 1000;
  for (std::uint64_t order = 0; order < kOrders; ++order) {
    for (std::size_t v = vertices.size() - 1; v > 0; --v) {
      std::swap(vertices[v], vertices[this->random_.below(v + 1)]);
    }
    this->bench_.resize(0, kDims);
    const bool stalls = this->random_.chance(0.5);
    for (const auto& vertex : vertices) {
      for (auto wait = stalls ? this->random_.below(5) : 0; wait > 0; --wait) this->bench_.clock();
      this->send(vertex);
    }
    this->bench_.drain();
    this->bench_.collect(0, 0);
    this->bench_.drain();
  }
  this->expect_no_mismatch();
  EXPECT_EQ(this->bench_.checked_words(), kOrders * 80);
}

TYPED_TEST(ScatterCore, APlantedFaultIsFound) {
  this->send(this->bench_.draw(0));
  this->bench_.drain();
  this->bench_.plant();
  this->bench_.collect(0, 0);
  this->bench_.drain();
  EXPECT_EQ(this->bench_.mismatches(), 1U);
}

}  // namespace
}  // namespace hwffd::test
