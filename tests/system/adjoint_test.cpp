// An evaluator and its transpose on one stream, beside the models of both: words, their order,
// events, clocks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "adjoint_run.hpp"
#include "grid_stop.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/blending.hpp"
#include "named.hpp"
#include "scatter_stimulus.hpp"
#include "share.hpp"

namespace hwffd::test {
namespace {

constexpr std::uint64_t kSlot = 3;  // clocks of a gradient, with rows of a layer

class Adjoint : public ::testing::TestWithParam<AdjointBuild> {
 protected:
  int axis() const { return GetParam().core.axis; }
  int pages() const { return GetParam().core.pages; }
  int scatter_pages() const { return GetParam().scatter_pages; }
};

std::size_t points_of(const std::array<int, 3>& dims) {
  std::size_t points = 1;
  for (const int count : dims) points *= static_cast<std::size_t>(count);
  return points;
}

/// Packets of both halves, some of them bad, one kind in a row or several.
class AdjointPackets {
 public:
  AdjointPackets(const AdjointRun& run, tb::Random& random, const AdjointBuild& build)
      : run_(run),
        random_(random),
        evaluator_(run.codec(), random, build.core),
        scatter_(run.codec(), random, build.core.axis, build.scatter_pages) {}

  std::vector<Beat> any(int rounds) {
    std::vector<Beat> beats;
    for (int round = 0; round < rounds; ++round) {
      append(beats, scatter_.any(static_cast<int>(random_.between(1, 4))));
      append(beats, evaluator_.any(static_cast<int>(random_.between(1, 4))));
      if (random_.chance(0.4)) append(beats, grid());
    }
    return beats;
  }

 private:
  std::vector<Beat> grid() {
    const LatticeWords lattice = random_lattice(run_.codec(), random_, 6);
    std::vector<Beat> beats = run_.packet_of(lattice);
    Grid grid = small_grid(random_, lattice.dims);
    if (random_.chance(0.1)) grid.count[random_.below(3)] = 0;
    std::vector<Beat> packet = grid_packet(grid, 0, {});
    append(beats, random_.chance(0.1) ? spoiled(std::move(packet), random_) : packet);
    return beats;
  }

  const AdjointRun& run_;
  tb::Random& random_;
  PagePackets evaluator_;
  ScatterPackets scatter_;
};

// Both halves in turns, with stalls on either side: every bit, results in the order of packets, and
// what each model tells.
TEST_P(Adjoint, AnyPacketsInAnyOrder) {
  std::array<std::uint64_t, kStreamEvents> events{};
  std::size_t results = 0;
  const std::uint64_t first = tb::seed_from_environment(1);
  for (std::uint64_t seed = first; seed < first + share_of(40); ++seed) {
    const auto throttle = [&](std::uint64_t of) {
      const auto& names = tb::throttle_names();
      return names[(seed / of) % names.size()];
    };
    AdjointRun run(GetParam(), seed, throttle(1), throttle(5));
    tb::Random random(seed);
    AdjointPackets packets(run, random, GetParam());
    if (seed % 4 != 0) run.send_functions();
    run.send(packets.any(16));
    ASSERT_TRUE(run.run()) << "seed " << seed;
    for (const model::ScatterEvent& event : run.events()) ++events.at(event.event);
    results += run.bench().results().size();
  }
  for (const event::Code code :
       {event::kUnknownOpcode, event::kPacketShort, event::kPacketLong, event::kNoLattice,
        event::kLatticeSize, event::kCellOutside, event::kCoordinateOutside, event::kGridCount}) {
    EXPECT_GT(events[stream_event(code)], 0U) << "event " << stream_event(code);
  }
  std::printf("%zu results\n", results);
}

// Each kind of bad gradients and collects between good packets of either half: what is told of
// them, and where, does not come from the model.
TEST_P(Adjoint, BadGradients) {
  tb::Random random(2);
  AdjointRun run(GetParam(), 1, "bernoulli", "bursts");
  const std::array<int, 3> dims = {5, 4, 4};
  const auto good =
      gradients_packet(0, random_gradients(run.codec(), random, dims, 3), gradients_to(dims, true));
  run.send_functions();
  run.send_lattice(random_lattice(run.codec(), random, dims));
  run.send(good);
  std::vector<model::ScatterEvent> expected;
  std::uint32_t packets = 3;
  for (const BadGradients& bad :
       bad_gradients(run.codec(), random, dims, axis(), scatter_pages())) {
    // What the scatter half alone does not know may be the evaluator's.
    if (!is_of_scatter(bad.packet)) continue;
    run.send_grid(small_grid(random, dims));
    run.send(bad.packet);
    run.send(good);
    for (const auto& [code, beat] : bad.events) expected.push_back({code, packets + 1, beat});
    packets += 3;
  }
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(same_events(run.placed_events(), expected));
  std::printf("%u packets, %zu events of gradients and collects\n", packets, expected.size());
}

// Packets that neither half knows are told once, and those that one does not know not at all.
TEST_P(Adjoint, UnknownOpcodesAreToldOnce) {
  tb::Random random(12);
  AdjointRun run(GetParam(), 1, "bursts", "bernoulli");
  const std::array<int, 3> dims = {4, 4, 5};
  const auto good =
      gradients_packet(0, random_gradients(run.codec(), random, dims, 3), gradients_to(dims));
  run.send_functions();
  run.send_lattice(random_lattice(run.codec(), random, dims));
  std::vector<model::ScatterEvent> expected;
  std::uint32_t packets = 2;
  for (const std::uint32_t opcode : {0U, 9U, 12U, 13U, 26U, 27U, 129U, 255U}) {
    for (const std::size_t beats : {1U, 4U, 9U}) {
      std::vector<Beat> unknown = sized(good, beats);
      unknown[0].words[0] = opcode;
      run.send(good);
      run.send(unknown);
      run.send_grid(small_grid(random, dims));
      expected.push_back({event::kUnknownOpcode, packets + 1, 0});
      packets += 3;
    }
  }
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  EXPECT_TRUE(same_events(run.placed_events(), expected));
}

// Coefficients that are bad in any way are told once, and both halves go on with the old ones.
TEST_P(Adjoint, BadCoefficientsAreToldOnce) {
  tb::Random random(3);
  AdjointRun run(GetParam(), 1, "bursts", "always");
  const std::array<int, 3> dims = {4, 5, 4};
  const auto gradients =
      gradients_packet(0, random_gradients(run.codec(), random, dims, 3), gradients_to(dims));
  const auto functions =
      coefficients_packet(family("linear", run.codec()), run.codec(), Functions::kDerivativesToo);
  run.send_functions();
  run.send_lattice(random_lattice(run.codec(), random, dims));
  std::uint64_t bad = 0;
  const auto both = [&] {
    run.send(gradients);
    run.send_grid(small_grid(random, dims));
  };
  for (std::size_t beats = 1; beats < functions.size(); ++beats) {
    run.send(sized(functions, beats));
    ++bad;
    both();
  }
  run.send(sized(functions, functions.size() + 2));
  both();
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.pulses(event::kPacketShort), bad);
  EXPECT_EQ(run.pulses(event::kPacketLong), 1U);
}

TEST_P(Adjoint, FunctionsThatDoNotSumUpAreToldOnce) {
  AdjointRun run(GetParam(), 1);
  std::vector<Beat> functions =
      coefficients_packet(family("bspline", run.codec()), run.codec(), Functions::kDerivativesToo);
  functions[6].words[0] ^= 0x1000000;
  functions[21].words[2] ^= 0x1000000;
  const std::array<int, 3> dims = {4, 4, 4};
  tb::Random random(4);
  run.send(functions);
  run.send(gradients_packet(0, random_gradients(run.codec(), random, dims, 2), gradients_to(dims)));
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  std::vector<model::ScatterEvent> expected;
  if (!wired_in(run.row())) {
    expected = {{stream_event(event::kFunctionsSum), 0, 8},
                {stream_event(event::kFunctionsSum), 0, 24}};
  }
  EXPECT_TRUE(same_events(run.events(), expected));
}

std::vector<std::array<double, 3>> values(const std::vector<Beat>& results, std::size_t first,
                                          std::size_t count) {
  std::vector<std::array<double, 3>> all(count);
  for (std::size_t r = 0; r < count; ++r) {
    for (int c = 0; c < 3; ++c) {
      all[r][c] = std::ldexp(static_cast<std::int32_t>(results.at(first + r).words[c]), -31);
    }
  }
  return all;
}

// As a registration does: positions of a grid, gradients at the same grid, their sums at the
// control points, and once more. <A p, g> is <p, A^T g> within the bound of numerics.md section 11.
TEST_P(Adjoint, IsTheTransposeOfItself) {
  tb::Random random(5);
  AdjointRun run(GetParam(), 1, "always", "bernoulli");
  const int width = std::stoi(run.row().format + 2);
  const std::array<int, 3> dims = {7, 6, 8};
  const Grid grid = grid_between({0, 0, 0}, {4, 3, 5}, {14, 11, 12});
  const std::size_t vertices = vertex_count(grid);
  const std::size_t points = points_of(dims);
  run.send_functions();
  for (int round = 0; round < 3; ++round) {
    // Words of the core's width, so that nothing is rounded on entry.
    LatticeWords lattice = random_lattice(run.codec(), random, dims);
    for (auto& point : lattice.points) {
      for (std::uint32_t& word : point) word &= ~0U << (32 - width);
    }
    run.send_lattice(lattice);
    std::size_t first = run.bench().results().size();
    run.send_grid(grid);
    ASSERT_TRUE(run.bench().run());
    const auto positions = values(run.bench().results(), first, vertices);
    std::vector<std::array<std::uint32_t, 3>> gradients(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      for (int c = 0; c < 3; ++c) {
        gradients[v][c] = run.bench().results()[first + v].words[c] & ~0U << (32 - width);
      }
    }
    run.send(gradients_packet(round % scatter_pages(), grid, gradients, gradients_to(dims)));
    first = run.bench().results().size();
    run.send(collect_packet(round % scatter_pages()));
    ASSERT_TRUE(run.run());
    const auto& results = run.bench().results();
    const double unit = std::ldexp(1.0, 1 - width);
    for (int c = 0; c < 3; ++c) {
      double forward = 0, back = 0;
      for (std::size_t v = 0; v < vertices; ++v) {
        forward += positions[v][c] * std::ldexp(static_cast<std::int32_t>(gradients[v][c]), -31);
      }
      for (std::size_t p = 0; p < points; ++p) {
        back += std::ldexp(static_cast<std::int32_t>(lattice.points[p][c]), -31) * unit *
                static_cast<std::int32_t>(results.at(first + p).words[c]);
      }
      // 64 units a vertex, weights that are rounded, and the rounding of a result.
      const double bound = static_cast<double>(vertices) * (1.05 * 64 * unit + std::ldexp(1, -32));
      EXPECT_LE(std::abs(forward - back), bound);
      EXPECT_GT(forward, 4 * bound) << "nothing to compare";
      std::printf("%.9g and %.9g, apart %.2g of the bound\n", forward, back,
                  std::abs(forward - back) / bound);
    }
  }
  EXPECT_TRUE(run.events().empty());
}

// The clocks of each half are those of its own core.
TEST_P(Adjoint, ClocksOfAGridAndOfItsGradients) {
  tb::Random random(6);
  AdjointRun run(GetParam(), 1);
  const std::array<int, 3> dims = {6, 5, 4};
  const Grid grid = grid_between({0, 0, 0}, {3, 2, 1}, {60, 6, 2});
  const std::size_t row = 60;
  const std::size_t vertices = vertex_count(grid);
  const bool walk = std::string(run.row().org).rfind("walk", 0) == 0;
  run.send_functions();
  run.send_lattice(random_lattice(run.codec(), random, dims));
  run.send_grid(grid);
  const std::size_t first = run.sent() + 4;
  run.send(random_grid_packet(random, 0, grid, gradients_to(dims)));
  run.send(collect_packet(0));
  ASSERT_TRUE(run.run());
  const auto& left = run.bench().result_clocks();
  const auto& taken = run.bench().accept_clocks();
  const std::uint64_t each = walk ? 1 : 64;
  for (std::size_t v = 4 * row; v < vertices; v += row) {
    EXPECT_EQ(left[v] - left[v - row], row * each);
  }
  // A row has six layers, which take less than its vertices.
  const std::uint64_t gradient = GetParam().rows ? 1 : kSlot;
  for (std::size_t v = 2 * row; v < vertices; v += row) {
    EXPECT_EQ(taken[first + v] - taken[first + v - row], row * gradient);
  }
  EXPECT_EQ(run.bench().clocks_per_result(vertices + 2, vertices + points_of(dims) - 1),
            static_cast<double>(kSlot));
  std::printf("from the last position to the first sum %llu clocks, of which gradients %zu\n",
              static_cast<unsigned long long>(left[vertices] - left[vertices - 1]),
              static_cast<std::size_t>(gradient) * vertices);
}

// What follows a collect: another page fills while it is read, results of the evaluator wait.
TEST_P(Adjoint, APageFillsWhileAnotherIsCollected) {
  tb::Random random(7);
  AdjointRun run(GetParam(), 1);
  const std::array<int, 3> dims = {6, 6, 6};
  const auto some = random_gradients(run.codec(), random, dims, 20);
  run.send_functions();
  run.send_lattice(random_lattice(run.codec(), random, dims));
  run.send(gradients_packet(0, some, gradients_to(dims)));
  run.send(collect_packet(0));
  run.send(gradients_packet(1, some, gradients_to(dims)));
  const std::size_t other = run.sent() - 1;
  run.send_grid(small_grid(random, dims));
  run.send(collect_packet(1));
  ASSERT_TRUE(run.run());
  EXPECT_LT(run.bench().accept_clocks()[other], run.bench().result_clocks()[points_of(dims) / 2]);
}

// A grid that is stopped has the results of its first vertices, and all behind it is as if no more
// had been asked for; gradients of a grid are not stopped.
TEST_P(Adjoint, AStopEndsAGridOfTheEvaluator) {
  std::size_t stops = 0, wholes = 0;
  for (std::uint64_t round = 0; round < share_of(40); ++round) {
    SCOPED_TRACE(round);
    tb::Random random(round);
    const AdjointRun run(GetParam(), round);
    const LatticeWords lattice = random_lattice(run.codec(), random, 5);
    const std::vector<Grid> grids = {grid_between({0, 0, 0}, {1, 1, 1}, {5, 4, 3}),
                                     grid_between({0, 0, 0}, {1, 1, 1}, {2, 2, 2})};
    std::vector<Beat> sent =
        coefficients_packet(family("bspline", run.codec()), run.codec(), Functions::kBlending);
    append(sent, run.packet_of(lattice));
    std::vector<Beat> wanted = sent;
    std::vector<Beat> sums =
        random_grid_packet(random, 0, small_grid(random, lattice.dims), gradients_to(lattice.dims));
    append(sums, collect_packet(0));
    // A walk takes a clock for a vertex of a row, or as many as for one of a random cell.
    const auto most = static_cast<std::uint64_t>(expected_interval(run.row()));
    const std::uint64_t clocks = vertex_count(grids[0]) * (random.chance(0.5) ? 1 : most);
    const std::uint64_t at = sent.size() + random.below(100 + 2 * clocks);
    for (const Grid& grid : grids) {
      append(sent, grid_packet(grid, 0, {}));
      append(sent, sums);
    }
    const std::unique_ptr<cores::StreamCore> core = GetParam().make(round);
    const Stopped out = stopped_at(*core, random, sent, at);

    std::size_t stopped = 0;
    auto begin = out.results.begin();
    const auto is_last = [](const Beat& beat) { return beat.last; };
    for (const Grid& grid : grids) {
      const auto end = std::find_if(begin, out.results.end(), is_last);
      ASSERT_NE(end, out.results.end());
      std::vector<VertexBeat> vertices = grid_vertices(grid, lattice.dims, run.codec());
      const auto made = static_cast<std::size_t>(end + 1 - begin);
      ASSERT_LE(made, vertices.size());
      (made < vertices.size() ? stopped : wholes) += 1;
      vertices.resize(made);
      append(wanted, run.packet_of(vertices));
      append(wanted, sums);
      begin = std::find_if(end + 1, out.results.end(), is_last);
      ASSERT_NE(begin, out.results.end());
      ++begin;
    }
    EXPECT_EQ(out.refusals, stopped);
    EXPECT_TRUE(out.results == AdjointModel(GetParam()).run(wanted));
    stops += stopped;
  }
  EXPECT_GT(stops, 0U);
  EXPECT_GT(wholes, 0U);
  std::printf("%zu grids stopped, %zu not\n", stops, wholes);
}

// Results that nobody takes hold everything behind them back, and nothing is lost.
TEST_P(Adjoint, ResultsThatWait) {
  tb::Random random(8);
  for (const bool scatter_first : {false, true}) {
    AdjointRun run(GetParam(), 1);
    const std::array<int, 3> dims = {5, 5, 5};
    const LatticeWords lattice = random_lattice(run.codec(), random, dims);
    const auto some = random_gradients(run.codec(), random, dims, 9);
    run.send_functions();
    run.send_lattice(lattice);
    for (int round = 0; round < 6; ++round) {
      if (!scatter_first) run.send_grid(small_grid(random, dims));
      run.send(gradients_packet(0, some, gradients_to(dims)));
      run.send(collect_packet(0));
      if (scatter_first) run.send_grid(small_grid(random, dims));
    }
    EXPECT_TRUE(run.bench().raises_valid_without_ready(20'000, 2'000));
    ASSERT_TRUE(run.run());
    EXPECT_GT(run.bench().waits(0), 0U);
  }
}

TEST_P(Adjoint, AResetEndsAnything) {
  tb::Random random(9);
  AdjointRun run(GetParam(), 1, "always", "bernoulli");
  for (std::uint64_t round = 0; round < share_of(24); ++round) {
    run.send_functions();
    AdjointPackets packets(run, random, GetParam());
    run.send(packets.any(8));
    run.bench().run_for(1 + random.below(2'000));
    run.reset(1 + random.below(3));
    const std::array<int, 3> dims = {4, 6, 5};
    const auto vertices = random_gradients(run.codec(), random, dims, 5);
    run.send(gradients_packet(0, vertices, gradients_to(dims)));
    run.send_lattice(random_lattice(run.codec(), random, dims));
    run.send_grid(small_grid(random, dims));
    run.send_functions();
    run.send(gradients_packet(0, vertices, gradients_to(dims)));
    run.send_grid(small_grid(random, dims));
    for (int page = 0; page < 2; ++page) run.send(collect_packet(page));
    ASSERT_TRUE(run.run()) << "round " << round;
    run.reset();
  }
}

TEST_P(Adjoint, IsIdleAtTheEnd) {
  tb::Random random(10);
  AdjointRun run(GetParam(), 1);
  run.bench().run_for(10'000);
  EXPECT_TRUE(run.idle()) << "after the sweep of a reset";
  AdjointPackets packets(run, random, GetParam());
  for (int round = 0; round < 4; ++round) {
    run.send_functions();
    run.send(packets.any(4));
    run.bench().run_for(20);
    EXPECT_FALSE(run.idle());
    ASSERT_TRUE(run.run());
    run.bench().run_for(10'000);
    EXPECT_TRUE(run.idle());
  }
}

// A wrong bit of a word of either half is found.
TEST_P(Adjoint, AFaultIsFound) {
  for (const std::size_t result : {3U, 40U}) {
    tb::Random random(11);
    AdjointRun run(GetParam(), 1);
    const std::array<int, 3> dims = {4, 4, 4};
    run.send_functions();
    run.send_lattice(random_lattice(run.codec(), random, dims));
    run.send_grid(grid_between({0, 0, 0}, {1, 1, 1}, {3, 3, 3}, 0));
    run.send(
        gradients_packet(0, random_gradients(run.codec(), random, dims, 5), gradients_to(dims)));
    run.send(collect_packet(0));
    run.bench().plant({tb::Fault::Kind::kFlip, result, 40});
    EXPECT_FALSE(run.run());
  }
}

INSTANTIATE_TEST_SUITE_P(, Adjoint, ::testing::ValuesIn(adjoint_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
