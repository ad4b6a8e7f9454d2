// What stands behind the live page, natively: meshes, faults, the inside of the cores, bad input.
#include "engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>

#include "design.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"
#include "hwffd/model/schedule.hpp"
#include "named.hpp"
#include "row_texts.hpp"

namespace hwffd::web {
namespace {

constexpr Eigen::Index kVertices = 1000;

/// Vertices in no order, from (-1, -2, -3) to (1, 2, 3).
Points cloud(Eigen::Index count = kVertices) {
  std::mt19937 random(1);
  Points points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const double unit = static_cast<double>(random()) / 4294967296.0;
    points.data()[i] = static_cast<double>(i % 3 + 1) * (2 * unit - 1);
  }
  return points;
}

/// An engine with that core and a cloud.
void prepare(Engine& engine, const Configuration& row, const std::string& deformation) {
  engine.open(row.name);
  engine.set_mesh(cloud());
  engine.set_dims({5, 6, 4});
  engine.set_shape(deformation);
}

std::string error_of(const std::function<void()>& f) {
  try {
    f();
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

std::vector<Configuration> built_rows() {
  return test::rows_where([](const Configuration& row) { return cores::has_stream_core(row); });
}

class EachCore : public ::testing::TestWithParam<Configuration> {};

TEST_P(EachCore, AgreesWithItsModel) {
  Engine engine;
  prepare(engine, GetParam(), "twist:40");
  const Deformed deformed = engine.deform();
  EXPECT_EQ(deformed.positions.rows(), kVertices);
  EXPECT_EQ(deformed.words, 4U * kVertices);
  EXPECT_EQ(deformed.mismatches, 0U);
  EXPECT_FALSE(deformed.first.has_value());
  EXPECT_EQ(deformed.saturated, 0U);
  EXPECT_NEAR(deformed.clocks_per_vertex, expected_interval(GetParam()), 0.1);
}

TEST_P(EachCore, AtRestNothingMoves) {
  Engine engine;
  prepare(engine, GetParam(), "");
  EXPECT_LT((engine.deform().positions - cloud()).cwiseAbs().maxCoeff(), 1e-3);
}

TEST_P(EachCore, AFaultIsSeen) {
  Engine engine;
  prepare(engine, GetParam(), "bend:30");
  engine.set_fault(true);
  const Deformed wrong = engine.deform();
  EXPECT_GT(wrong.mismatches, 0U);
  ASSERT_TRUE(wrong.first.has_value());
  EXPECT_EQ(wrong.first->word, 0);
  EXPECT_EQ(wrong.first->rtl, wrong.first->model | 1U << 24);
  engine.inside().run(10'000);
  EXPECT_GT(engine.inside().snapshot().mismatches, 0U);
  engine.set_fault(false);
  EXPECT_EQ(engine.deform().mismatches, 0U);
}

TEST_P(EachCore, TheInsideGoesOnClockByClock) {
  Engine engine;
  prepare(engine, GetParam(), "twist:40");
  engine.deform();
  Inside& inside = engine.inside();
  const std::uint64_t start = inside.snapshot().clock;
  inside.run(1);
  EXPECT_EQ(inside.snapshot().clock, start + 1);
  inside.run_vertex();
  EXPECT_EQ(inside.snapshot().vertices, 1U);
  inside.run(5000);
  const Snapshot shown = inside.snapshot();
  EXPECT_EQ(shown.mismatches, 0U);
  EXPECT_GT(shown.vertices, 10U);
  EXPECT_EQ(shown.busy.size(), design_of(GetParam()).blocks.size());
  EXPECT_NE(std::count(shown.busy.begin(), shown.busy.end(), 1), 0);
  EXPECT_EQ(shown.clock - shown.first_clock, Inside::kTimeline);
  ASSERT_FALSE(shown.lanes.empty());
  for (const cores::Lane& lane : shown.lanes) {
    EXPECT_FALSE(lane.spans.empty()) << lane.name;
    for (const auto& span : lane.spans) {
      EXPECT_LT(span.begin, span.end) << lane.name;
      EXPECT_LE(span.end, Inside::kTimeline) << lane.name;
      EXPECT_LT(span.vertex, static_cast<std::size_t>(kVertices)) << lane.name;
    }
  }
}

// Vertices come as far apart as the formula says, on the lane that ends them; as many are there at
// once as take turns in an accumulator.
TEST_P(EachCore, TheTimelineShowsTheInterval) {
  Engine engine;
  prepare(engine, GetParam(), "");
  engine.deform();
  engine.inside().run(3000);
  const std::vector<cores::Lane> lanes = engine.inside().snapshot().lanes;
  const std::vector<cores::Lane::Span>& spans = lanes.back().spans;
  ASSERT_GT(spans.size(), 1U);
  for (std::size_t i = 1; i < spans.size(); ++i) EXPECT_LE(spans[i - 1].begin, spans[i].begin);
  std::set<std::size_t> vertices;
  for (const auto& span : spans) vertices.insert(span.vertex);
  const bool barrel = GetParam().n == 1;
  const double interval = walks(GetParam()) ? 1 : expected_interval(GetParam());
  const double turns = barrel ? GetParam().add_latency : 1;
  const double off = walks(GetParam()) ? 2.5 : 1.5;  // the header of a packet takes a clock, too
  EXPECT_NEAR(static_cast<double>(vertices.size()) * interval, Inside::kTimeline + turns * interval,
              off * interval);
}

// Whatever of a vertex lies before the clocks that are kept, the probes fit the row's latencies.
TEST_P(EachCore, TheInsideIsSeenFromAnyClock) {
  Engine engine;
  prepare(engine, GetParam(), "");
  engine.deform();
  std::mt19937 random(2);
  for (int i = 0; i < 200; ++i) {
    engine.inside().run(1 + random() % 300);
    ASSERT_NO_THROW(engine.inside().snapshot()) << i;
  }
  EXPECT_EQ(engine.inside().snapshot().mismatches, 0U);
}

// Each block is lit at some time, but for what vertices of a lattice do not need.
TEST_P(EachCore, EachBlockIsLitInItsTime) {
  Engine engine;
  prepare(engine, GetParam(), "");
  engine.deform();
  const std::vector<Block>& blocks = design_of(GetParam()).blocks;
  std::vector<std::uint8_t> lit(blocks.size(), 0);
  for (int i = 0; i < 1500; ++i) {
    engine.inside().run(1);
    const Snapshot shown = engine.inside().snapshot();
    for (std::size_t b = 0; b < lit.size(); ++b) lit[b] |= shown.busy[b];
  }
  for (std::size_t b = 0; b < lit.size(); ++b) {
    const std::string& id = blocks[b].id;
    const bool loads = id == "functions" || id == "writer" || id == "determinant";
    EXPECT_EQ(lit[b], loads ? 0 : 1) << id;
  }
}

TEST_P(EachCore, PortsAreRecorded) {
  Engine engine;
  prepare(engine, GetParam(), "");
  std::vector<std::string> names;
  for (const Port& port : ports()) names.push_back(port.name);
  engine.watch(names);
  engine.deform();
  engine.inside().run(300);
  const Snapshot shown = engine.inside().snapshot();
  EXPECT_EQ(shown.ports.size(), names.size());
  EXPECT_EQ(shown.ports.at("m_axis_tdata").size(), 32U);
  EXPECT_EQ(shown.ports.at("m_axis_tready"), "1");
}

INSTANTIATE_TEST_SUITE_P(, EachCore, ::testing::ValuesIn(built_rows()), test::by_name);

Configuration any_row() { return built_rows().front(); }

// A reader of VCD: definitions, then times that grow and changes of what is defined.
TEST(Vcd, CanBeRead) {
  Engine engine;
  prepare(engine, any_row(), "");
  engine.watch({"m_axis_tvalid", "m_axis_tdata"});
  engine.deform();
  engine.inside().run(5000);
  std::istringstream lines(engine.inside().vcd());
  std::map<std::string, std::size_t> widths;
  std::size_t times = 0;
  long long time = -1;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "$var") {
      std::size_t width = 0;
      std::string identifier;
      words >> word >> width >> identifier;
      widths[identifier] = width;
    } else if (word[0] == '#') {
      const long long next = std::stoll(word.substr(1));
      EXPECT_GT(next, time);
      time = next;
      ++times;
    } else if (word[0] == 'b') {
      std::string identifier;
      words >> identifier;
      EXPECT_EQ(widths.at(identifier), word.size() - 1);
    } else if (word[0] == '0' || word[0] == '1') {
      EXPECT_EQ(widths.at(word.substr(1)), 1U);
    } else {
      EXPECT_EQ(word[0], '$') << line;
    }
  }
  EXPECT_EQ(widths.size(), 3U);
  EXPECT_EQ(times, 2 * PortRecorder::kClocks);
}

TEST(Engine, AnotherCoreKeepsMeshAndLattice) {
  Engine engine;
  prepare(engine, any_row(), "twist:40");
  const Points moved = engine.lattice().points();
  engine.deform();
  for (const Configuration& row : built_rows()) {
    engine.open(row.name);
    EXPECT_EQ(engine.lattice().points(), moved);
    EXPECT_EQ(engine.deform().mismatches, 0U) << row.name;
  }
}

TEST(Engine, AMeshIsDeformedAfterALookInside) {
  Engine engine;
  prepare(engine, any_row(), "twist:40");
  const Points before = engine.deform().positions;
  engine.inside().run(777);
  const Deformed after = engine.deform();
  EXPECT_EQ(after.mismatches, 0U);
  EXPECT_EQ(after.positions, before);
}

TEST(Engine, ALargeMeshGoesInSeveralBatches) {
  Engine engine;
  engine.open("basic-fx18-overlapped");
  engine.set_mesh(cloud(70'000));
  const Deformed deformed = engine.deform();
  EXPECT_EQ(deformed.words, 4U * 70'000);
  EXPECT_EQ(deformed.mismatches, 0U);
  EXPECT_LT((deformed.positions - cloud(70'000)).cwiseAbs().maxCoeff(), 1e-3);
  engine.inside().run(1000);
  EXPECT_EQ(engine.inside().snapshot().mismatches, 0U);
}

TEST(Engine, BadInputIsRefusedInASentence) {
  Engine engine;
  EXPECT_EQ(error_of([&] { engine.deform(); }),
            "lattice: there is no mesh that it is around; give one first");
  EXPECT_EQ(error_of([&] { engine.lattice(); }),
            "lattice: there is no mesh that it is around; give one first");
  EXPECT_EQ(error_of([&] { engine.inside(); }), "core: there is none; open one first");
  EXPECT_THROW(engine.open("basic-fx99"), std::invalid_argument);
  EXPECT_EQ(error_of([&] { engine.set_mesh(Points(0, 3)); }),
            "mesh: it has no vertices; take one that has some");
  EXPECT_EQ(error_of([&] { engine.set_mesh(Points::Zero(5'000'000, 3)); }),
            "mesh: it has 5000000 vertices; take one with 2000000 at most");
  Points points = cloud(4);
  points(2, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of([&] { engine.set_mesh(points); }),
            "vertex 2 is not finite; give finite coordinates");
  engine.set_mesh(cloud());
  EXPECT_EQ(error_of([&] {
              engine.set_dims({3, 4, 4});
            }),
            "lattice: 3 points along an axis; take 4 to 16");
  EXPECT_EQ(error_of([&] { engine.set_points(cloud(63)); }),
            "lattice of 4 x 4 x 4 points: 63 points given; give 64");
  EXPECT_NE(error_of([&] { engine.set_shape("twist:x"); }), "no error");
  EXPECT_NE(error_of([&] { engine.set_shape("to:lattice.json"); }), "no error");
  engine.open(any_row().name);
  EXPECT_EQ(error_of([&] { engine.inside().run(1); }), "core: there is no mesh; give one first");
  EXPECT_EQ(error_of([&] { engine.watch({"nothing"}); }).substr(0, 25),
            "port 'nothing': unknown; ");
  EXPECT_EQ(engine.deform().mismatches, 0U);
}

// Along rows as many vertices pass as there are clocks, and of a row, of two cells here, five
// planes are read; each belongs to the vertex that wants it first.
TEST(Walk, GoesAlongRowsInside) {
  const Configuration& row = find_configuration("walk-fx17-overlapped");
  if (!cores::has_stream_core(row)) GTEST_SKIP() << "not in this build";
  constexpr std::uint64_t kRow = 20, kRows = 10;  // clocks of one; of them looked at
  Engine engine;
  prepare(engine, row, "twist:40");
  engine.deform();
  engine.inside().run(2000);
  const std::uint64_t before = engine.inside().snapshot().vertices;
  engine.inside().run(kRow * kRows);
  const Snapshot shown = engine.inside().snapshot();
  EXPECT_EQ(shown.vertices - before, kRow * kRows);
  EXPECT_EQ(shown.mismatches, 0U);
  const auto lane = std::find_if(shown.lanes.begin(), shown.lanes.end(), [](const auto& of) {
    return of.name.find("product along u") != std::string::npos ||
           of.name.find("products along u") != std::string::npos;
  });
  ASSERT_NE(lane, shown.lanes.end());
  std::map<std::size_t, std::size_t> steps;  // of each vertex that wants planes
  for (const auto& span : lane->spans) ++steps[span.vertex];
  std::size_t whole = 0;
  for (const auto& [vertex, count] : steps) {
    const std::size_t planes = vertex % kRow == 0 ? 4 : vertex % kRow == kRow / 2 ? 1 : 0;
    EXPECT_GT(planes, 0U) << vertex;
    EXPECT_LE(count, 4 * planes) << vertex;
    whole += count == 4 * planes ? 1 : 0;
  }
  EXPECT_GE(whole, 2 * kRows - 3);
}

/// Two rows of a lattice of four cells along s, clock by clock: "read" in the first of the four
/// clocks of a plane, with its bank and its number along s; "taken", with the vertex.
std::string rows_inside() {
  constexpr std::uint64_t kClocks = 130;
  constexpr std::size_t kPlanes = 2 * (4 + 3), kTaken = 2 * 4 * 7;
  Engine engine;
  engine.open("walk-fx17-overlapped");
  engine.set_mesh(cloud());
  engine.set_dims({7, 4, 4});
  engine.deform();
  Inside& inside = engine.inside();
  const auto signal = [&](const char* name) {
    return inside.signals().only(std::string("u_walk:") + name);
  };
  const cores::Signal valid = signal("step_valid"), first = signal("step_first"),
                      bank = signal("bank"), cell = signal("cell_index"), take = signal("take");
  const std::uint64_t start = inside.snapshot().clock;
  std::ostringstream rows;
  rows << "what,clock,bank,number\n";
  std::size_t vertex = 0, planes = 0;
  for (std::uint64_t clock = 0; clock < kClocks && vertex < kTaken; ++clock) {
    inside.run(1);
    const std::uint64_t now = inside.snapshot().clock - start;
    if (valid.value() != 0 && first.value() != 0 && planes++ < kPlanes) {
      const std::uint64_t at = cell.value() & 15;
      rows << "read," << now << ',' << bank.value() << ',' << at + (bank.value() - at) % 4 << '\n';
    }
    if (take.value() != 0) rows << "taken," << now << ",," << vertex++ << '\n';
  }
  EXPECT_EQ(inside.snapshot().mismatches, 0U);
  return rows.str();
}

// What docs/organizations/walk-rows.svg is drawn from is what the core does. Where that changes on
// purpose, the file is what this test has left beside its program.
TEST(Walk, RowsAreThoseOfThePicture) {
  if (!cores::has_stream_core(find_configuration("walk-fx17-overlapped")))
    GTEST_SKIP() << "not in this build";
  std::ifstream file(HWFFD_WALK_ROWS);
  const std::string drawn((std::istreambuf_iterator<char>(file)), {});
  const std::string rows = rows_inside();
  EXPECT_EQ(std::count(rows.begin(), rows.end(), '\n'), 1 + 2 * (7 + 28));
  EXPECT_EQ(rows, drawn) << "now in walk_rows.csv";
  if (rows != drawn) std::ofstream("walk_rows.csv") << rows;
}

TEST(RowTexts, SayWhatARowIs) {
  EXPECT_EQ(title_of(find_configuration("basic-fp32-overlapped")), "basic, single precision");
  EXPECT_EQ(title_of(find_configuration("factored3-fx18-overlapped")),
            "factored/3, 18-bit fixed point");
  EXPECT_EQ(formula_of(find_configuration("basic-fx18-overlapped")), "64 * start, start = 1");
  EXPECT_EQ(formula_of(find_configuration("factored3-fx18-overlapped")), "3");
  EXPECT_EQ(formula_of(find_configuration("walk-fx17-overlapped")),
            "16 in any order, 1 along rows");
}

}  // namespace
}  // namespace hwffd::web
