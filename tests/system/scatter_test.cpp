// The core that adds gradients up, beside its model: words, events, clocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <numeric>
#include <string>
#include <vector>

#include "hwffd/stream/blending.hpp"
#include "named.hpp"
#include "scatter_run.hpp"
#include "scatter_stimulus.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kVertexBeats = 2;
constexpr std::uint64_t kSlot = 3;  // clocks of a vertex or a layer, or of a point of a collect

class Scatter : public ::testing::TestWithParam<ScatterBuild> {
 protected:
  int axis() const { return GetParam().axis; }
  int pages() const { return GetParam().pages; }
  bool rows() const { return GetParam().rows; }
  /// Of a vertex of a list: with rows each of its four layers takes a slot.
  std::uint64_t vertex_clocks() const { return rows() ? 4 * kSlot : kSlot; }
};

std::size_t points_of(const std::array<int, 3>& dims) {
  const int points = dims[0] * dims[1] * dims[2];
  return static_cast<std::size_t>(points);
}

TEST_P(Scatter, AnyPacketsInAnyOrder) {
  std::array<std::uint64_t, kStreamEvents> events{};
  const std::uint64_t first = tb::seed_from_environment(1);
  for (std::uint64_t seed = first; seed < first + share_of(24); ++seed) {
    const auto throttle = [&](std::uint64_t of) {
      const auto& names = tb::throttle_names();
      return names[(seed / of) % names.size()];
    };
    ScatterRun run(GetParam(), seed, throttle(1), throttle(5));
    tb::Random random(seed);
    ScatterPackets packets(run.codec(), random, axis(), pages());
    run.send(packets.functions());
    run.send(packets.any(60));
    const std::array<int, 3> dims = {4, 5, 6};
    run.send(gradients_packet(0, random_gradients(run.codec(), random, dims, 2),
                              gradients_to(dims, true)));
    run.send(collect_packet(0));
    ASSERT_TRUE(run.run());
    for (const model::ScatterEvent& event : run.events()) ++events.at(event.event);
  }
  for (const event::Code code :
       {event::kUnknownOpcode, event::kPacketShort, event::kPacketLong, event::kNoLattice,
        event::kLatticeSize, event::kCellOutside, event::kCoordinateOutside, event::kSaturated,
        event::kPagePoints, event::kGridCount}) {
    EXPECT_GT(events[stream_event(code)], 0U) << "event " << stream_event(code);
  }
}

// Nothing that comes hangs it, and what comes behind is exact.
TEST_P(Scatter, Garbage) {
  const std::uint64_t first = tb::seed_from_environment(1);
  for (std::uint64_t seed = first; seed < first + share_of(12); ++seed) {
    ScatterRun run(GetParam(), seed, seed % 2 == 0 ? "always" : "bursts",
                   seed % 3 == 0 ? "always" : "bernoulli");
    tb::Random random(seed);
    ScatterPackets packets(run.codec(), random, axis(), pages());
    if (seed % 4 != 0) run.send_functions();
    for (int round = 0; round < 8; ++round) {
      run.send(packets.garbage(60));
      const auto vertices = random_gradients(run.codec(), random, {4, 4, 5}, 4);
      run.send(gradients_packet(0, vertices, gradients_to({4, 4, 5}, true)));
      run.send(collect_packet(0));
    }
    ASSERT_TRUE(run.run());
    EXPECT_GE(run.bench().results().size(), 8 * 80U);
  }
}

// What is expected here does not come from the model: the events and where they are told, and that
// the words of the packet behind are those of the same packet at the start.
TEST_P(Scatter, BadPackets) {
  tb::Random random(3);
  const std::array<int, 3> dims = {5, 4, 4};
  const std::size_t points = points_of(dims);
  ScatterRun run(GetParam(), 1, "bernoulli", "bursts");
  const auto good =
      gradients_packet(0, random_gradients(run.codec(), random, dims, 3), gradients_to(dims, true));
  run.send_functions();
  run.send(good);
  run.send(collect_packet(0));
  std::uint32_t packets = 3;
  std::vector<model::ScatterEvent> expected;
  const auto bad = bad_gradients(run.codec(), random, dims, axis(), pages());
  for (const BadGradients& packet : bad) {
    run.send(good);
    run.send(packet.packet);
    for (const auto& [code, beat] : packet.events) expected.push_back({code, packets + 1, beat});
    run.send(good);
    run.send(collect_packet(0));
    packets += 4;
  }
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(same_events(run.placed_events(), expected));
  ASSERT_EQ(run.bench().results().size(), (1 + bad.size()) * points);
  for (std::size_t packet = 0; packet < bad.size(); ++packet) {
    EXPECT_EQ(run.words((1 + packet) * points, points), run.words(0, points)) << bad[packet].name;
  }
  std::printf("%zu bad packets\n", bad.size());
}

// A header of a collect with beats behind it has its words all the same.
TEST_P(Scatter, ACollectThatIsTooLong) {
  tb::Random random(4);
  ScatterRun run(GetParam(), 1, "bernoulli", "bernoulli");
  const std::array<int, 3> dims = {4, 5, 4};
  const auto packet =
      gradients_packet(1, random_gradients(run.codec(), random, dims, 3), gradients_to(dims));
  Collect how;
  how.count = how.interrupt = true;
  run.send_functions();
  run.send(packet);
  run.send(sized(collect_packet(1, how), 5));
  run.send(packet);
  run.send(collect_packet(1));
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(same_events(run.placed_events(), {{event::kPacketLong, 2, 1}}));
  EXPECT_EQ(run.bench().results().size(), 161U);
  EXPECT_EQ(run.words(0, 80), run.words(81, 80));
}

TEST_P(Scatter, VerticesBeforeTheirFunctions) {
  tb::Random random(5);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {4, 4, 4};
  const auto vertices = random_gradients(run.codec(), random, dims, 2);
  Gradients along = gradients_to(dims);
  along.along = 2;
  run.send(gradients_packet(0, vertices, gradients_to(dims)));
  run.send(coefficients_packet(family("bspline", run.codec()), run.codec()));
  run.send(gradients_packet(0, vertices, along));
  run.send(collect_packet(0));
  run.send(gradients_packet(0, vertices, gradients_to(dims)));
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(same_events(run.placed_events(), {{event::kNoCoefficients, 0, 2},
                                                {event::kNoCoefficients, 0, 4},
                                                {event::kNoCoefficients, 2, 2},
                                                {event::kNoCoefficients, 2, 4}}));
  for (const auto& words : run.words(0, 64)) {
    EXPECT_EQ(words, (std::array<std::uint32_t, 3>{0, 0, 0}));
  }
}

// Functions that do not sum to 1 are told with the fourth of their axis, unless the B-spline is
// wired in; what the other three are changes the words, then.
TEST_P(Scatter, FunctionsThatDoNotSumUp) {
  tb::Random random(6);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {4, 4, 4};
  const auto packet =
      gradients_packet(0, random_gradients(run.codec(), random, dims, 2), gradients_to(dims));
  std::vector<Beat> functions =
      coefficients_packet(family("bspline", run.codec()), run.codec(), Functions::kDerivativesToo);
  run.send(functions);
  run.send(packet);
  run.send(collect_packet(0));
  functions[6].words[0] ^= 0x1000000;
  functions[21].words[2] ^= 0x1000000;
  run.send(functions);
  run.send(packet);
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  const bool looks = !wired_in(GetParam().row);
  std::vector<model::ScatterEvent> expected;
  if (looks)
    expected = {{stream_event(event::kFunctionsSum), 3, 8},
                {stream_event(event::kFunctionsSum), 3, 24}};
  EXPECT_TRUE(same_events(run.placed_events(), expected));
  EXPECT_EQ(run.words(0, 64) != run.words(64, 64), looks);
}

// A set of vertices in any order, over packets, pages and grids of one: the same words when the
// pages are added.
TEST_P(Scatter, AnyOrderAndPartitionGivesTheSameWords) {
  const std::uint64_t permutations = share_of(1'000);
  const std::array<int, 3> dims = {5, 4, 4};
  tb::Random random(7);
  ScatterRun run(GetParam(), 1, "always", "always");
  auto vertices = random_gradients(run.codec(), random, dims, 12);
  run.send_functions();
  run.send(gradients_packet(0, vertices, gradients_to(dims)));
  run.send(collect_packet(0));
  for (std::uint64_t permutation = 0; permutation < permutations; ++permutation) {
    for (std::size_t v = vertices.size() - 1; v > 0; --v) {
      std::swap(vertices[v], vertices[random.below(v + 1)]);
    }
    // So that both pages have points an axis.
    for (int page = 0; page < 2; ++page) {
      run.send(sized(gradients_packet(page, vertices, gradients_to(dims)), 1));
    }
    for (auto next = vertices.cbegin(); next != vertices.cend();) {
      const auto left = static_cast<std::uint64_t>(vertices.cend() - next);
      const auto end = next + static_cast<std::ptrdiff_t>(random.between(1, left));
      run.send(
          gradients_packet(static_cast<int>(random.below(2)), {next, end}, gradients_to(dims)));
      next = end;
    }
    for (int page = 0; page < 2; ++page) run.send(collect_packet(page));
  }
  ASSERT_TRUE(run.run());
  const auto expected = run.words(0, 80);
  for (std::uint64_t permutation = 0; permutation < permutations; ++permutation) {
    auto sums = run.words(80 + 160 * permutation, 80);
    const auto others = run.words(160 + 160 * permutation, 80);
    for (std::size_t p = 0; p < sums.size(); ++p) {
      for (int c = 0; c < 3; ++c) sums[p][c] += others[p][c];
    }
    ASSERT_EQ(sums, expected) << "permutation " << permutation;
  }
  std::printf("%llu permutations\n", static_cast<unsigned long long>(permutations));
}

// Every cell of the longest lattice, positions and derivatives, each page.
TEST_P(Scatter, EveryCellOfTheLongestLattice) {
  tb::Random random(8);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {axis(), axis(), axis()};
  run.send_functions();
  for (int page = 0; page < pages(); ++page) {
    Gradients how = gradients_to(dims);
    how.along = page;
    std::vector<GradientBeats> vertices;
    for (int cell = 0; cell < axis() - 3; ++cell) {
      for (int a = 0; a < 3; ++a) {
        auto some = random_gradients(run.codec(), random, dims, 2);
        some[0].cell[a] = some[1].cell[a] = cell;
        vertices.insert(vertices.end(), some.begin(), some.end());
      }
    }
    run.send(gradients_packet(page, vertices, how));
  }
  for (int page = pages() - 1; page >= 0; --page) run.send(collect_packet(page));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().results().size(), static_cast<std::size_t>(pages()) * points_of(dims));
}

// Vertex after vertex of one cell: each reads what the one before wrote.
TEST_P(Scatter, VerticesOfOneCellFollowEachOther) {
  tb::Random random(9);
  for (const char* source : {"always", "gaps", "bernoulli", "bursts"}) {
    ScatterRun run(GetParam(), 1, source);
    const std::array<int, 3> dims = {4, 4, 4};
    run.send_functions();
    for (int packet = 0; packet < 30; ++packet) {
      run.send(gradients_packet(0,
                                random_gradients(run.codec(), random, dims, random.between(1, 9)),
                                gradients_to(dims)));
    }
    run.send(collect_packet(0));
    ASSERT_TRUE(run.run());
  }
}

// A grid gives the words of its vertices; with rows, those of rows of one vertex.
TEST_P(Scatter, AGridIsItsVertices) {
  tb::Random random(10);
  ScatterRun run(GetParam(), 1, "bursts", "bernoulli");
  std::vector<std::size_t> sizes;
  run.send_functions();
  for (int round = 0; round < 12; ++round) {
    std::array<int, 3> dims;
    for (int& points : dims) points = static_cast<int>(random.between(4, 8));
    Gradients how = gradients_to(dims);
    how.along = round % 4;
    Grid grid = small_grid(random, dims);
    if (rows()) grid.count[0] = 1;
    const auto packet = random_grid_packet(random, 0, grid, how);
    std::vector<GradientBeats> vertices;
    for (const VertexBeat& vertex : grid_vertices(grid, dims, run.codec())) {
      const auto& words = packet[4 + vertices.size()].words;
      vertices.push_back({vertex, {words[0], words[1], words[2]}});
    }
    run.send(packet);
    run.send(gradients_packet(1, vertices, how));
    for (int page = 0; page < 2; ++page) run.send(collect_packet(page));
    sizes.push_back(points_of(dims));
  }
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(run.placed_events().empty());
  std::size_t first = 0;
  for (const std::size_t size : sizes) {
    EXPECT_EQ(run.words(first, size), run.words(first + size, size));
    first += 2 * size;
  }
}

// The rows of a grid in packets of their own, in any order and to any page: the same words when the
// pages are added.
TEST_P(Scatter, RowsOfAGridInAnyOrder) {
  tb::Random random(20);
  ScatterRun run(GetParam(), 1, "bursts", "always");
  const std::array<int, 3> dims = {axis(), 4, 5};
  const std::size_t points = points_of(dims);
  const std::uint64_t rounds = share_of(60);
  run.send_functions();
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Gradients how = gradients_to(dims);
    how.along = static_cast<int>(round % 4);
    const Grid grid = long_rows(random, dims, 60);
    std::vector<std::array<std::uint32_t, 3>> gradients(vertex_count(grid));
    for (auto& gradient : gradients) gradient = random_gradient(random);
    run.send(gradients_packet(0, grid, gradients, how));
    run.send(collect_packet(0));
    const std::vector<Grid> rows = rows_of(grid);
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (std::size_t r = rows.size() - 1; r > 0; --r) {
      std::swap(order[r], order[random.below(r + 1)]);
    }
    // So that both pages have points an axis.
    for (int page = 0; page < 2; ++page) {
      run.send(sized(gradients_packet(page, grid, gradients, how), 1));
    }
    for (const std::size_t row : order) {
      const auto first = gradients.cbegin() + static_cast<std::ptrdiff_t>(row * grid.count[0]);
      run.send(gradients_packet(static_cast<int>(random.below(2)), rows[row],
                                {first, first + grid.count[0]}, how));
    }
    for (int page = 0; page < 2; ++page) run.send(collect_packet(page));
  }
  ASSERT_TRUE(run.run());
  for (std::uint64_t round = 0; round < rounds; ++round) {
    const auto expected = run.words(3 * points * round, points);
    auto sums = run.words(3 * points * round + points, points);
    const auto others = run.words(3 * points * round + 2 * points, points);
    for (std::size_t p = 0; p < points; ++p) {
      for (int c = 0; c < 3; ++c) sums[p][c] += others[p][c];
    }
    ASSERT_EQ(sums, expected) << "round " << round;
  }
}

// A packet that ends within a row has added what came, and nothing of it is in the row behind.
TEST_P(Scatter, ARowThatIsCut) {
  tb::Random random(21);
  ScatterRun run(GetParam(), 1, "bernoulli", "always");
  const std::array<int, 3> dims = {axis(), 5, 4};
  const std::size_t points = points_of(dims);
  const std::uint64_t rounds = share_of(60);
  run.send_functions();
  for (std::uint64_t round = 0; round < rounds; ++round) {
    Gradients how = gradients_to(dims);
    how.along = static_cast<int>(round % 4);
    const Grid grid = long_rows(random, dims, 30);
    const auto packet = random_grid_packet(random, 0, grid, how);
    const std::size_t count = vertex_count(grid);
    const auto came = static_cast<std::size_t>(random.between(1, count));
    const auto behind = random_grid_packet(random, 0, long_rows(random, dims, 30), how);
    run.send(sized(packet, 4 + came));
    run.send(behind);
    run.send(collect_packet(0));
    std::size_t sent = 0;
    for (Grid row : rows_of(grid)) {
      if (sent == came) break;
      row.count[0] = static_cast<std::uint16_t>(std::min<std::size_t>(row.count[0], came - sent));
      std::vector<std::array<std::uint32_t, 3>> gradients;
      for (std::size_t v = sent; v < sent + row.count[0]; ++v) {
        const auto& words = packet[4 + v].words;
        gradients.push_back({words[0], words[1], words[2]});
      }
      run.send(gradients_packet(0, row, gradients, how));
      sent += row.count[0];
    }
    run.send(behind);
    run.send(collect_packet(0));
  }
  ASSERT_TRUE(run.run());
  for (std::uint64_t round = 0; round < rounds; ++round) {
    ASSERT_EQ(run.words(2 * points * round, points), run.words(2 * points * round + points, points))
        << "round " << round;
  }
}

// Functions that are no family's, and rows as long as there are: sums of layers that no wide part
// holds when they have been expanded, and sums of more than 35 bits.
TEST_P(Scatter, LayersThatSaturate) {
  const int width = std::stoi(GetParam().row.format + 2);
  if (!rows() || wired_in(GetParam().row) || width < 17) {
    GTEST_SKIP() << "no rows, no such functions, or sums that are too small";
  }
  tb::Random random(22);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {4, 5, 6};
  auto functions =
      coefficients_packet(family("bspline", run.codec()), run.codec(), Functions::kDerivativesToo);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (std::size_t function = 0; function < 4; ++function) {
      functions[1 + 4 * axis + function].words = {function == 0 ? 0x80000000U : 0, 0, 0, 0};
    }
  }
  run.send(functions);
  for (const int count : {30'000, 65'535}) {
    const Grid grid = grid_between({0.25, 0.5, 0.5}, {0.75, 1.5, 0.5}, {count, 2, 1});
    std::vector<std::array<std::uint32_t, 3>> gradients(vertex_count(grid));
    for (auto& gradient : gradients) {
      const auto less = static_cast<std::uint32_t>(random.below(0x1000));
      gradient = {0xB3333333 + less, 0x4CCCCCCC - less, static_cast<std::uint32_t>(random.word())};
    }
    run.send(gradients_packet(0, grid, gradients, gradients_to(dims)));
    run.send(collect_packet(0));
  }
  ASSERT_TRUE(run.run());
  EXPECT_GE(run.pulses(event::kSaturated), 16U);
  for (const Beat& beat : run.bench().results()) EXPECT_NE(beat.words[3] & kStatusSaturated, 0U);
}

// Begins that follow each other at once and later, with other points an axis and with vertices that
// come while the sweep of the one before is under way.
TEST_P(Scatter, BeginsWithSweeps) {
  tb::Random random(11);
  for (std::uint64_t round = 0; round < share_of(8); ++round) {
    ScatterRun run(GetParam(), round, round % 2 == 0 ? "always" : "bursts", "bernoulli");
    run.send_functions();
    for (int packet = 0; packet < 80; ++packet) {
      const int page = static_cast<int>(random.below(static_cast<std::uint64_t>(pages())));
      const int points = random.chance(0.2) ? axis() : 4;
      const std::array<int, 3> dims = {4, points, 5};
      run.send(gradients_packet(page,
                                random_gradients(run.codec(), random, dims, random.between(1, 20)),
                                gradients_to(dims, true)));
      if (random.chance(0.3)) run.send(collect_packet(page));
    }
    ASSERT_TRUE(run.run());
  }
}

// So many vertices of the whole of a gradient that the sum is beyond a word.
TEST_P(Scatter, AWordSaturatesByItself) {
  if (wired_in(GetParam().row)) GTEST_SKIP() << "no functions that give all to one point";
  ScatterRun run(GetParam(), 1);
  const int width = std::stoi(GetParam().row.format + 2);
  GradientBeats vertex;
  vertex.gradient = {0x80000000, 0x7F000000, 0x01000000};
  const std::size_t exact = std::size_t{1} << (32 - width);
  const std::vector<GradientBeats> vertices(exact + exact / 8, vertex);
  run.send_functions("linear");
  run.send(gradients_packet(0, vertices, gradients_to({4, 4, 4})));
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  std::size_t saturated = 0;
  for (const Beat& beat : run.bench().results()) {
    if ((beat.words[3] & kStatusSaturated) == 0) continue;
    ++saturated;
    EXPECT_EQ(beat.words[0], 0x80000000U);
    EXPECT_EQ(beat.words[1], 0x7FFFFFFFU);
  }
  EXPECT_EQ(saturated, 1U);
  EXPECT_EQ(run.pulses(event::kSaturated), 1U);
}

// One vertex more than sums can surely hold is told once, and in every point; then the page begins
// anew.
TEST_P(Scatter, OverflowIsToldOnce) {
  const int width = std::stoi(GetParam().row.format + 2);
  if (wired_in(GetParam().row)) GTEST_SKIP() << "counts as the core without";
  tb::Random random(12);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {4, 4, 4};
  const auto most = static_cast<std::size_t>(model::scatter_most_vertices(width));
  const auto some = random_gradients(run.codec(), random, dims, 256);
  std::vector<GradientBeats> vertices;
  while (vertices.size() < most) vertices.insert(vertices.end(), some.begin(), some.end());
  run.send_functions();
  run.send(gradients_packet(0, vertices, gradients_to(dims)));
  ASSERT_TRUE(run.bench().run());
  EXPECT_EQ(run.pulses(event::kPageOverflowed), 0U);
  run.send(gradients_packet(0, some, gradients_to(dims)));
  run.send(collect_packet(0));
  run.send(gradients_packet(0, some, gradients_to(dims)));
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.pulses(event::kPageOverflowed), 1U);
  for (std::size_t r = 0; r < 128; ++r) {
    EXPECT_EQ((run.bench().results()[r].words[3] & kStatusOverflowed) != 0, r < 64);
  }
}

// A vertex takes three clocks, exactly, in its own beats or in those of a grid. With rows one of a
// list takes four times that.
TEST_P(Scatter, AVertexTakesThreeClocks) {
  constexpr std::size_t kVertices = 200;
  tb::Random random(13);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {7, 7, 7};
  const auto vertices = random_gradients(run.codec(), random, dims, kVertices);
  run.send_functions();
  const std::size_t single = run.sent() + 1;
  run.send(gradients_packet(0, vertices, gradients_to(dims)));
  const std::size_t of_grid = run.sent() + 4;
  const Grid grid = grid_between({0, 0, 0}, {4, 4, 4}, {10, 5, 4});
  run.send(random_grid_packet(random, 1, grid, gradients_to(dims)));
  for (int page = 0; page < 2; ++page) run.send(collect_packet(page));
  ASSERT_TRUE(run.run());
  const auto& taken = run.bench().accept_clocks();
  for (std::size_t v = 60; v < kVertices; v += 20) {
    EXPECT_EQ(taken[single + kVertexBeats * v] - taken[single + kVertexBeats * (v - 20)],
              20 * vertex_clocks());
    if (rows()) continue;
    EXPECT_EQ(taken[of_grid + v] - taken[of_grid + v - 20], 20 * kSlot);
  }
}

// A row of a grid takes a clock a vertex, or three a layer of control points that it touches,
// whichever is more: one a clock goes into what has room until a row waits in front of its layers.
TEST_P(Scatter, ARowTakesItsVerticesOrItsLayers) {
  if (!rows()) GTEST_SKIP() << "no rows";
  constexpr int kRows = 400;
  tb::Random random(23);
  const std::array<int, 3> dims = {axis(), 4, 4};
  int of_vertices = 0, of_layers = 0;
  for (std::uint64_t round = 0; round < share_of(24); ++round) {
    ScatterRun run(GetParam(), round);
    run.send_functions();
    Grid grid = long_rows(random, dims, round % 3 == 0 ? 6 : 60);
    grid.start[1] = grid.start[2] = 0;
    grid.step[1] = std::int64_t{1} << (kGridFraction - 9);
    grid.count[1] = kRows;
    grid.count[2] = 1;
    std::vector<bool> touched(static_cast<std::size_t>(axis()));
    const auto vertices = grid_vertices(grid, dims, run.codec());
    for (std::size_t v = 0; v < grid.count[0]; ++v) {
      for (int l = 0; l < 4; ++l) touched[static_cast<std::size_t>(vertices[v].cell[0] + l)] = true;
    }
    const auto layers =
        static_cast<std::uint64_t>(std::count(touched.begin(), touched.end(), true));
    const std::uint64_t clocks = std::max<std::uint64_t>(grid.count[0], kSlot * layers);
    ++(grid.count[0] > kSlot * layers ? of_vertices : of_layers);
    const std::size_t first = run.sent() + 4;
    run.send(random_grid_packet(random, 0, grid, gradients_to(dims)));
    run.send(collect_packet(0));
    ASSERT_TRUE(run.run());
    const auto& taken = run.bench().accept_clocks();
    constexpr std::size_t kFrom = 330, kMore = 60;
    EXPECT_EQ(taken[first + (kFrom + kMore) * grid.count[0]] - taken[first + kFrom * grid.count[0]],
              kMore * clocks)
        << grid.count[0] << " vertices, " << layers << " layers";
  }
  EXPECT_GT(of_vertices, 0);
  EXPECT_GT(of_layers, 0);
}

// A point takes a slot where no vertex wants it, and every second one where vertices come.
TEST_P(Scatter, ClocksOfACollect) {
  tb::Random random(14);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {5, 6, 7};
  const std::size_t points = points_of(dims);
  const auto few = random_gradients(run.codec(), random, dims, 4);
  const auto many = random_gradients(run.codec(), random, dims, 2 * points);
  run.send_functions();
  run.send(gradients_packet(0, few, gradients_to(dims)));
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().clocks_per_result(0, points - 1), static_cast<double>(kSlot));
  run.send(gradients_packet(0, few, gradients_to(dims)));
  run.send(collect_packet(0));
  const std::size_t first = run.sent() + 1;
  run.send(gradients_packet(1, many, gradients_to(dims)));
  run.send(collect_packet(1));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().clocks_per_result(points + 40, 2 * points - 1), 2.0 * kSlot);
  // Meanwhile vertices have the other slots.
  const auto& taken = run.bench().accept_clocks();
  const std::size_t from = rows() ? 50 : 100, more = rows() ? 16 : 40;
  EXPECT_EQ(taken[first + kVertexBeats * (from + more)] - taken[first + kVertexBeats * from],
            more * 2 * vertex_clocks());
}

// While a page is collected another one fills; vertices of the page itself wait.
TEST_P(Scatter, AnotherPageFillsMeanwhile) {
  constexpr std::size_t kVertices = 20;
  tb::Random random(15);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {6, 6, 6};
  const std::size_t points = points_of(dims);
  const auto packet = [&](int page) {
    return gradients_packet(page, random_gradients(run.codec(), random, dims, kVertices),
                            gradients_to(dims));
  };
  run.send_functions();
  run.send(packet(0));
  run.send(collect_packet(0));
  run.send(packet(1));
  const std::size_t other = run.sent() - 1;
  run.send(packet(0));
  const std::size_t own = run.sent() - 1;
  for (int page = 0; page < 2; ++page) run.send(collect_packet(page));
  ASSERT_TRUE(run.run());
  const auto& taken = run.bench().accept_clocks();
  const auto& left = run.bench().result_clocks();
  EXPECT_LT(taken[other], left[points / 2]) << "the other page had to wait";
  EXPECT_GT(taken[own], left[points - 1]) << "vertices of a page that was being read";
}

// Where results have to wait, vertices of other pages do not.
TEST_P(Scatter, WordsThatWaitHoldNoOtherPageBack) {
  tb::Random random(16);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {6, 6, 6};
  const auto vertices = random_gradients(run.codec(), random, dims, 40);
  run.send_functions();
  run.send(gradients_packet(0, vertices, gradients_to(dims)));
  run.send(collect_packet(0));
  run.send(gradients_packet(1, vertices, gradients_to(dims)));
  const std::size_t beats = run.sent();
  const std::uint64_t before = run.bench().driver().accepted();
  EXPECT_TRUE(run.bench().raises_valid_without_ready(5'000, 2'000));
  EXPECT_EQ(run.bench().driver().accepted() - before, beats);
  EXPECT_EQ(run.bench().results().size(), 0U);
  run.send(collect_packet(1));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.words(0, 216), run.words(216, 216));
}

// At any moment: then all pages are zero, and nothing is loaded.
TEST_P(Scatter, AResetEndsAnything) {
  tb::Random random(17);
  ScatterRun run(GetParam(), 1, "always", "bernoulli");
  for (std::uint64_t round = 0; round < share_of(40); ++round) {
    run.send_functions();
    ScatterPackets packets(run.codec(), random, axis(), pages());
    run.send(packets.any(20));
    run.bench().run_for(1 + random.below(1'500));
    run.reset(1 + random.below(3));
    const std::array<int, 3> dims = {4, 6, 5};
    for (int page = 0; page < pages(); ++page) {
      const auto vertices = random_gradients(run.codec(), random, dims, 5);
      if (page == 0) run.send(gradients_packet(page, vertices, gradients_to(dims)));
      if (page == 0) run.send_functions();
      run.send(gradients_packet(page, vertices, gradients_to(dims)));
    }
    for (int page = 0; page < pages(); ++page) run.send(collect_packet(page));
    ASSERT_TRUE(run.run()) << "round " << round;
    EXPECT_EQ(run.pulses(event::kNoCoefficients), 5U);
    run.reset();
  }
}

// When everything has ended, nothing is under way.
TEST_P(Scatter, IsIdleAtTheEnd) {
  tb::Random random(18);
  ScatterRun run(GetParam(), 1);
  run.bench().run_for(10'000);
  EXPECT_TRUE(run.idle()) << "after the sweep of a reset";
  ScatterPackets packets(run.codec(), random, axis(), pages());
  for (int round = 0; round < 6; ++round) {
    const std::array<int, 3> dims = {4, 6, 5};
    const auto vertices = random_gradients(run.codec(), random, dims, 5);
    run.send_functions();
    run.send(packets.any(10));
    run.send(gradients_packet(0, vertices, gradients_to(dims, true)));
    run.send(collect_packet(0));
    run.bench().run_for(20);
    EXPECT_FALSE(run.idle());
    ASSERT_TRUE(run.run());
    run.bench().run_for(10'000);
    EXPECT_TRUE(run.idle());
  }
}

// A wrong bit of a word is found.
TEST_P(Scatter, AFaultIsFound) {
  tb::Random random(19);
  ScatterRun run(GetParam(), 1);
  const std::array<int, 3> dims = {4, 4, 4};
  run.send_functions();
  run.send(gradients_packet(0, random_gradients(run.codec(), random, dims, 5), gradients_to(dims)));
  run.send(collect_packet(0));
  run.bench().plant({tb::Fault::Kind::kFlip, 10, 40});
  EXPECT_FALSE(run.run());
}

INSTANTIATE_TEST_SUITE_P(, Scatter, ::testing::ValuesIn(scatter_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
