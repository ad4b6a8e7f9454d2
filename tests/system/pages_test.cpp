// Cores with pages: several lattices resident, parts of them, longer axes, a fourth component.
#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "bad_pages.hpp"
#include "hwffd/model/schedule.hpp"
#include "named.hpp"
#include "page_run.hpp"

namespace hwffd::test {
namespace {

class Pages : public ::testing::TestWithParam<PageBuild> {
 protected:
  bool has(std::uint32_t feature) const { return (GetParam().core.features & feature) != 0; }
  int pages() const { return GetParam().core.pages; }
};

class AnyAxis : public Pages {};
class TwoPages : public Pages {};
class ThreePages : public Pages {};
class Fourth : public TwoPages {};

TEST_P(Pages, AnyPacketsInAnyOrder) {
  constexpr std::uint64_t kRounds = 12;
  std::array<std::uint64_t, kStreamEvents> events{};
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 5; seed <= last; ++seed) {
    PageRun run(GetParam(), seed, "bursts", "bernoulli");
    tb::Random random(seed);
    PagePackets packets(run.codec(), random, GetParam().core);
    run.send(coefficients_packet(
        random_coefficients(run.codec(), random),
        has(model::kDerivativesFeature) ? Functions::kDerivativesToo : Functions::kBlending));
    for (std::uint64_t round = 0; round < kRounds; ++round) run.send(packets.any(12));
    ASSERT_TRUE(run.run());
    EXPECT_GT(run.bench().results().size(), 4 * kRounds);
    for (int e = 0; e < kStreamEvents; ++e) events[e] += run.bench().events()[e];
  }
  for (const Code code : {kUnknownOpcode, kPacketShort, kPacketLong, kNoLattice, kPagePoints}) {
    EXPECT_GT(events[stream_event(code)], 0U) << "event " << code;
  }
  if (has(model::kFourthFeature)) {
    EXPECT_GT(events[stream_event(kNoFourth)], 0U);
  }
}

// What is expected here does not come from the model: the event, how often, and that the lattice
// and the results behind are as before.
TEST_P(TwoPages, BadPackets) {
  tb::Random random(3);
  const WordCodec codec(find_configuration(GetParam().row).format);
  const LatticeWords lattice = random_lattice(codec, random, {5, 4, 6});
  const auto vertices = random_vertices(codec, random, lattice.dims, 3);
  for (const BadPage& packet : bad_pages(codec, lattice, vertices, GetParam().core)) {
    SCOPED_TRACE(packet.name);
    PageRun run(GetParam(), 1, "bernoulli", "bursts");
    run.send_bspline();
    run.send(page_packet(1, lattice));
    run.send(page_vertices_packet(1, vertices));
    run.send(packet.packet);
    run.send(page_vertices_packet(1, vertices));
    ASSERT_TRUE(run.run());
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      EXPECT_EQ(run.bench().events()[e], e == stream_event(packet.code) ? packet.count : 0) << e;
    }
    const std::size_t all = run.bench().results().size();
    EXPECT_EQ(run.words(0, 3), run.words(all - 3, 3));
    EXPECT_EQ(all, packet.count == 3 ? 9U : 6U);
  }
}

// A packet that is too short has changed the points that came, and no other; of a whole lattice it
// leaves nothing.
TEST_P(TwoPages, PacketsThatAreCutShort) {
  tb::Random random(4);
  PageRun run(GetParam(), 1, "bernoulli", "bernoulli");
  const LatticeWords lattice = random_lattice(run.codec(), random, {4, 4, 4});
  LatticeWords moved = lattice;
  for (auto& point : moved.points) std::swap(point[0], point[1]);
  LatticeWords some = lattice;
  for (std::size_t p = 10; p < 15; ++p) some.points[p] = moved.points[p];
  const auto vertices = random_vertices(run.codec(), random, lattice.dims, 4);
  const auto cut = [](std::vector<Beat> packet, std::size_t beats) {
    packet.resize(beats);
    packet.back().last = true;
    return packet;
  };
  run.send_bspline();
  run.send(page_packet(0, lattice));
  run.send(cut(points_packet(0, moved, 10, 20), 1 + 5));
  run.send(page_vertices_packet(0, vertices));
  run.send(page_packet(1, some));
  run.send(page_vertices_packet(1, vertices));
  run.send(cut(page_packet(1, lattice), 64));
  run.send(page_vertices_packet(1, vertices));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 4), run.words(4, 4));
  EXPECT_EQ(run.pulses(kPacketShort), 2U);
  EXPECT_EQ(run.pulses(kNoLattice), 4U);
}

// One moved point is two beats, and gives the results of the whole lattice loaded anew: each point
// of a lattice in turn, so every place is found.
TEST_P(TwoPages, OneMovedPointIsTwoBeats) {
  tb::Random random(5);
  PageRun run(GetParam(), 1);
  LatticeWords lattice = random_lattice(run.codec(), random, {5, 7, 6});
  LatticeWords other = random_lattice(run.codec(), random, {5, 7, 6});
  const auto vertices = random_vertices(run.codec(), random, lattice.dims, 2);
  std::size_t moves = 0;
  run.send_bspline();
  run.send(page_packet(0, lattice));
  for (std::size_t p = 0; p < lattice.points.size(); p += 1 + random.below(12), ++moves) {
    lattice.points[p] = other.points[p];
    const std::size_t before = run.sent();
    run.send(points_packet(0, lattice, p, 1));
    EXPECT_EQ(run.sent() - before, 2U);
    run.send(page_vertices_packet(0, vertices));
    run.send(page_packet(1, lattice));
    run.send(page_vertices_packet(1, vertices));
  }
  ASSERT_TRUE(run.run());
  for (std::size_t m = 0; m < moves; ++m) EXPECT_EQ(run.words(4 * m, 2), run.words(4 * m + 2, 2));
}

// Lattices of four points an axis, whatever the core takes: each page has its own points, also
// where vertex after vertex is of the same cell of another page.
TEST_P(AnyAxis, EachPageHasItsOwnPoints) {
  tb::Random random(15);
  PageRun run(GetParam(), 1, "bursts", "bernoulli");
  const std::array<int, 3> dims = {4, 4, 4};
  std::vector<LatticeWords> lattices;
  run.send_bspline();
  for (int page = 0; page < pages(); ++page) {
    lattices.push_back(random_lattice(run.codec(), random, dims));
    run.send(page_packet(page, lattices.back()));
  }
  const auto vertices = random_vertices(run.codec(), random, dims, 4);
  for (std::size_t first = 0; first < 4; ++first) {
    for (int page = 0; page < pages(); ++page) {
      run.send(page_vertices_packet(page, {vertices[first], vertices[(first + 1) % 4]}));
    }
  }
  ASSERT_TRUE(run.run());
  // Pages differ, and so do the results of one vertex.
  std::set<std::array<std::uint32_t, 3>> different;
  for (int page = 0; page < pages(); ++page) different.insert(run.words(2 * page, 1)[0]);
  EXPECT_EQ(different.size(), static_cast<std::size_t>(pages()));
}

// A hierarchy: three lattices are loaded once, and vertices of all of them come in turn. The same
// results come of lattices that are loaded anew for each turn, in many more beats.
TEST_P(ThreePages, AHierarchyOfThreePagesWithoutReloading) {
  constexpr std::size_t kTurns = 9, kVertices = 3;
  tb::Random random(6);
  PageRun resident(GetParam(), 1), reloaded(GetParam(), 1);
  std::vector<LatticeWords> levels;
  for (const int points : {4, 5, 7}) {
    levels.push_back(random_lattice(resident.codec(), random, {points, points, points}));
  }
  resident.send_bspline();
  reloaded.send_bspline();
  std::size_t loads = 0;
  for (int level = 0; level < 3; ++level) {
    resident.send(page_packet(level, levels[level]));
    loads += 1 + levels[level].points.size();
  }
  for (std::size_t turn = 0; turn < kTurns; ++turn) {
    const int level = static_cast<int>(turn % 3);
    const auto some = random_vertices(resident.codec(), random, levels[level].dims, kVertices);
    resident.send(page_vertices_packet(level, some));
    reloaded.send(lattice_packet(levels[level]));
    reloaded.send(vertices_packet(some));
  }
  ASSERT_TRUE(resident.run());
  ASSERT_TRUE(reloaded.run());
  EXPECT_EQ(resident.words(0, kTurns * kVertices), reloaded.words(0, kTurns * kVertices));
  EXPECT_EQ(resident.sent() + 2 * loads + kTurns, reloaded.sent() + kTurns);
}

// Vertices before a change see the old points, those after it the new ones, while results have to
// wait and the core is full.
TEST_P(TwoPages, ChangesKeepTheirOrderUnderBackPressure) {
  tb::Random random(7);
  const WordCodec codec(find_configuration(GetParam().row).format);
  const LatticeWords old = random_lattice(codec, random, {4, 4, 4});
  LatticeWords moved = random_lattice(codec, random, {4, 4, 4});
  moved.exponent = old.exponent;
  const LatticeWords aside = random_lattice(codec, random, {4, 5, 4});
  const auto vertices = random_vertices(codec, random, old.dims, 30);
  // What is expected: of lattices that nobody changes.
  PageRun still(GetParam(), 1);
  still.send_bspline();
  still.send(page_packet(0, old));
  still.send(page_packet(1, moved));
  for (int page = 0; page < 2; ++page) still.send(page_vertices_packet(page, vertices));
  ASSERT_TRUE(still.run());
  for (const char* sink : {"always", "bernoulli", "long_stall", "sparse"}) {
    PageRun run(GetParam(), 1, "always", sink);
    run.send_bspline();
    run.send(page_packet(0, old));
    run.send(page_vertices_packet(0, vertices));
    run.send(points_packet(0, moved, 0, 64));
    run.send(page_vertices_packet(0, vertices));
    run.send(page_packet(1, aside));
    run.send(page_vertices_packet(0, vertices));
    run.send(page_packet(0, old));
    run.send(page_vertices_packet(0, vertices));
    ASSERT_TRUE(run.run());
    EXPECT_EQ(run.words(0, 30), still.words(0, 30)) << sink;
    EXPECT_EQ(run.words(30, 30), still.words(30, 30)) << sink;
    EXPECT_EQ(run.words(60, 30), still.words(30, 30)) << sink;
    EXPECT_EQ(run.words(90, 30), still.words(0, 30)) << sink;
  }
}

// A page that no vertex inside reads is loaded at once, and one that is read waits for its last
// reader only, not for those of another page behind it.
TEST_P(TwoPages, OnlyReadersOfThePageHoldAHeaderBack) {
  tb::Random random(8);
  PageRun run(GetParam(), 1);
  const LatticeWords lattice = random_lattice(run.codec(), random, {4, 4, 4});
  const auto some = random_vertices(run.codec(), random, lattice.dims, 5);
  run.send_bspline();
  run.send(page_packet(0, lattice));
  run.send(page_packet(1, lattice));
  run.send(page_vertices_packet(0, some));
  const std::size_t aside = run.sent();
  run.send(page_packet(1, lattice));
  const std::size_t read = run.sent();
  run.send(page_vertices_packet(1, some));
  run.send(points_packet(0, lattice, 3, 1));
  const std::size_t after = run.sent();
  run.send(page_vertices_packet(0, some));
  ASSERT_TRUE(run.run());
  const auto& taken = run.bench().accept_clocks();
  const auto& left = run.bench().result_clocks();
  // A header and the first point behind it.
  EXPECT_LE(taken[aside + 1] - taken[aside], 6U);
  EXPECT_GT(taken[read], taken[aside] + 64);
  EXPECT_GE(taken[after - 1], left[4]) << "before the last reader of the old points had left";
}

// What holds a header back is told of its cause: a vertex inside that reads the page, or no room;
// what is only looked up waits for neither.
TEST_P(TwoPages, WaitsAreToldOfTheirCause) {
  constexpr unsigned kForReaders = 0, kForRoom = 1;
  tb::Random random(14);
  PageRun readers(GetParam(), 1);
  const LatticeWords lattice = random_lattice(readers.codec(), random, {4, 4, 4});
  const auto vertices = random_vertices(readers.codec(), random, lattice.dims, 1);
  readers.send_bspline();
  readers.send(page_packet(0, lattice));
  readers.send(page_packet(1, lattice));
  readers.send(page_vertices_packet(0, vertices));
  readers.send(points_packet(0, lattice, 3, 1));
  ASSERT_TRUE(readers.run());
  EXPECT_GT(readers.bench().waits(kForReaders), 0U);
  EXPECT_EQ(readers.bench().waits(kForRoom), 0U);

  PageRun room(GetParam(), 1, "always", "sparse");
  room.send_bspline();
  room.send(page_packet(0, lattice));
  room.send(page_packet(1, lattice));
  for (int packet = 0; packet < 60; ++packet) {
    room.send(
        page_vertices_packet(packet % 2, random_vertices(room.codec(), random, lattice.dims, 9)));
  }
  ASSERT_TRUE(room.run());
  EXPECT_EQ(room.bench().waits(kForReaders), 0U);
  EXPECT_GT(room.bench().waits(kForRoom), 0U);
}

// A switch of pages takes five clocks on the input, one of them its header's own, and none between
// results while the evaluator has vertices enough.
TEST_P(TwoPages, ClocksOfASwitchOfPages) {
  constexpr std::size_t kSwitches = 40;
  tb::Random random(12);
  PageRun run(GetParam(), 1);
  const LatticeWords lattice = random_lattice(run.codec(), random, {4, 4, 4});
  run.send_bspline();
  for (int page = 0; page < 2; ++page) run.send(page_packet(page, lattice));
  const std::size_t part = run.sent();
  run.send(points_packet(1, lattice, 5, 1));
  std::vector<std::size_t> headers;
  for (std::size_t s = 0; s < kSwitches; ++s) {
    headers.push_back(run.sent());
    run.send(page_vertices_packet(static_cast<int>(s % 2),
                                  random_vertices(run.codec(), random, lattice.dims, 1)));
  }
  ASSERT_TRUE(run.run());
  const auto& taken = run.bench().accept_clocks();
  EXPECT_EQ(taken[headers[0] + 1] - taken[headers[0]], 5U);
  // The indices of a place take a division of each of its bits by two of the axes.
  const int axis = GetParam().core.axis;
  const unsigned place_bits = 3 * (axis > 32 ? 6 : axis > 16 ? 5 : 4);
  EXPECT_EQ(taken[part + 1] - taken[part], 2 * place_bits + 5);
  const double interval = expected_interval(run.row());
  EXPECT_EQ(run.bench().clocks_per_result(9, 39), std::max(interval, 6.0));
}

// Vertices until tlast are those of a count.
TEST_P(Pages, VerticesUntilTheLastBeat) {
  tb::Random random(9);
  PageRun run(GetParam(), 1, "bursts", "bursts");
  const LatticeWords lattice = random_lattice(run.codec(), random, {4, 6, 4});
  const auto vertices = random_vertices(run.codec(), random, lattice.dims, 7);
  PageVertices every;
  every.every = true;
  run.send_bspline();
  const int page = pages() - 1;
  run.send(page_packet(page, lattice));
  run.send(page_vertices_packet(page, vertices));
  run.send(page_vertices_packet(page, vertices, every));
  run.send(page_vertices_packet(page, {vertices[0]}, every));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 7), run.words(7, 7));
  EXPECT_EQ(run.words(0, 1), run.words(14, 1));
  for (std::size_t r = 0; r < 15; ++r) {
    EXPECT_EQ(run.bench().results()[r].last, r == 6 || r >= 13) << r;
  }
  EXPECT_EQ(run.pulses(kPacketShort) + run.pulses(kPacketLong), 0U);
}

// The fourth component is what the same component gives as x of another lattice; derivatives of it
// follow those of the point.
TEST_P(Fourth, FollowsEachResult) {
  tb::Random random(10);
  PageRun run(GetParam(), 1, "always", "bernoulli");
  const LatticeWords plain = random_lattice(run.codec(), random, {5, 4, 4});
  const LatticeWords lattice = with_fourth(plain, run.codec(), random);
  LatticeWords swapped = plain;
  for (std::size_t p = 0; p < plain.points.size(); ++p) {
    swapped.points[p] = {lattice.fourth[p], 0, 0};
  }
  const auto vertices = random_vertices(run.codec(), random, plain.dims, 4);
  PageVertices how;
  how.fourth = true;
  if (has(model::kDerivativesFeature)) how.results = Results::kDerivatives;
  PageVertices without = how;
  without.fourth = false;
  const std::size_t result_count = results_of(how.results) * vertices.size();
  run.send_bspline(has(model::kDerivativesFeature) ? Functions::kDerivativesToo
                                                   : Functions::kBlending);
  run.send(page_packet(0, lattice));
  run.send(page_vertices_packet(0, vertices, how));
  run.send(page_vertices_packet(0, vertices, without));
  run.send(page_packet(1, swapped));
  run.send(page_vertices_packet(1, vertices, without));
  // Points without the flag leave the fourth component as it is.
  run.send(points_packet(0, plain, 0, plain.points.size()));
  run.send(page_vertices_packet(0, vertices, how));
  ASSERT_TRUE(run.run());
  for (std::size_t r = 0; r < result_count; ++r) {
    EXPECT_EQ(run.words(2 * r, 1), run.words(2 * result_count + r, 1));
    const auto fourth = run.words(2 * r + 1, 1)[0];
    EXPECT_EQ(fourth[0], run.words(3 * result_count + r, 1)[0][0]);
    EXPECT_EQ(fourth[1] | fourth[2], 0U);
    const auto& results = run.bench().results();
    EXPECT_EQ(results[2 * r].words[3] & kTagMask, results[2 * r + 1].words[3] & kTagMask);
    EXPECT_EQ(results[2 * r + 1].last, r + 1 == result_count);
  }
  EXPECT_EQ(run.words(0, 2 * result_count), run.words(4 * result_count, 2 * result_count));
}

// The ends of the longest axes, cells of all their bits, a part in the last points.
TEST_P(Pages, TheLongestAxes) {
  tb::Random random(11);
  PageRun run(GetParam(), 1);
  const int axis = GetParam().core.axis;
  run.send_bspline();
  for (int a = 0; a < 3; ++a) {
    std::array<int, 3> dims = {4, 4, 4};
    dims[a] = axis;
    const LatticeWords lattice = random_lattice(run.codec(), random, dims);
    const int page = a % pages();
    PageVertices how;
    how.large = axis > kSmallAxisPoints;
    std::vector<VertexBeat> vertices;
    for (int cell = 0; cell <= axis - 4; ++cell) {
      vertices.push_back(random_vertices(run.codec(), random, {4, 4, 4}, 1).front());
      vertices.back().cell[a] = cell;
    }
    run.send(page_packet(page, lattice));
    run.send(page_vertices_packet(page, vertices, how));
    run.send(points_packet(page, random_lattice(run.codec(), random, dims), 0, 0));
  }
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.pulses(kCellOutside), 0U);
}

/// Most tests want axes of more than four points.
bool is_long(const PageBuild& build) { return build.core.axis > 4; }

INSTANTIATE_TEST_SUITE_P(, AnyAxis, ::testing::ValuesIn(page_builds()), by_name);
INSTANTIATE_TEST_SUITE_P(, Pages, ::testing::ValuesIn(page_builds(is_long)), by_name);
INSTANTIATE_TEST_SUITE_P(, TwoPages, ::testing::ValuesIn(page_builds([](const PageBuild& build) {
                           return is_long(build) && build.core.pages >= 2;
                         })),
                         by_name);
INSTANTIATE_TEST_SUITE_P(, ThreePages, ::testing::ValuesIn(page_builds([](const PageBuild& build) {
                           return is_long(build) && build.core.pages >= 3;
                         })),
                         by_name);
INSTANTIATE_TEST_SUITE_P(, Fourth, ::testing::ValuesIn(page_builds([](const PageBuild& build) {
                           return (build.core.features & model::kFourthFeature) != 0 &&
                                  build.core.pages >= 2;
                         })),
                         by_name);

}  // namespace
}  // namespace hwffd::test
