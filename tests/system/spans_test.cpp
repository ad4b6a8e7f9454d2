// Cores with functions for each span: packets of spans, good and bad, in any order with all others;
// clamped lattices against de Boor's algorithm, at their corners and at their seams.
#include "hwffd/stream/spans.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../golden/de_boor.hpp"
#include "hwffd/model/organizations.hpp"
#include "named.hpp"
#include "page_run.hpp"
#include "span_stimulus.hpp"

namespace hwffd::test {
namespace {

class Spans : public ::testing::TestWithParam<PageBuild> {
 protected:
  void start(std::uint64_t seed) {
    run_ = std::make_unique<PageRun>(GetParam(), seed, seed % 2 == 0 ? "always" : "bursts",
                                     seed % 3 == 0 ? "always" : "bernoulli");
  }
  void send(const std::vector<Beat>& beats) { run_->send(beats); }
  /// To the end: every bit of every result, and every event.
  void finish() { ASSERT_TRUE(run_->run()); }
  const std::vector<Beat>& results() const { return run_->bench().results(); }
  std::uint64_t counted(event::Code code) const { return run_->pulses(code); }
  bool derivatives() const { return (GetParam().core.features & model::kDerivativesFeature) != 0; }

  /// Clamped knots at uneven distances, as many cells as a lattice of that size has.
  static std::vector<double> uneven_knots(int points) {
    std::vector<double> knots = clamped_knots(points - 3);
    for (double& knot : knots) knot = knot * (1 + 0.125 * knot);
    return knots;
  }

  /// Loads a lattice with such knots on all axes.
  LatticeWords send_uneven(tb::Random& random, const std::array<int, 3>& dims) {
    std::array<std::vector<AxisWords>, 3> axes;
    for (int axis = 0; axis < 3; ++axis) {
      knots_[axis] = uneven_knots(dims[axis]);
      axes[axis] = encode(watertight_spans(knots_[axis], codec_), codec_);
    }
    send(all_spans_packets(axes));
    LatticeWords lattice = random_lattice(codec_, random, dims);
    for (auto& point : lattice.points) {
      for (std::uint32_t& word : point) {
        // No more bits than any format keeps, and away from the ends of fixed point.
        word = codec_.point(std::ldexp(std::nearbyint(random.unit() * 4096 - 2048), -12));
      }
    }
    send(lattice_packet(lattice));
    return lattice;
  }

  int most_points() const { return std::min(spans_ + 3, kAxisPoints); }

  const Configuration& row_ = find_configuration(GetParam().row);
  const WordCodec codec_{row_.format};
  const int spans_ = GetParam().core.spans;
  std::array<std::vector<double>, 3> knots_;
  std::unique_ptr<PageRun> run_;
};

TEST_P(Spans, AnyPacketsInAnyOrder) {
  constexpr std::uint64_t kRounds = 40;
  for (std::uint64_t seed = tb::seed_from_environment(1), last = seed + 3; seed <= last; ++seed) {
    start(seed);
    tb::Random random(seed);
    for (std::uint64_t round = 0; round < kRounds; ++round) {
      if (random.chance(0.2)) {
        send(
            coefficients_packet(random_coefficients(codec_, random),
                                derivatives() ? Functions::kDerivativesToo : Functions::kBlending));
        // At once: the change walks through the table meanwhile.
        send(vertices_packet(random_vertices(codec_, random, {8, 8, 8}, 3)));
      }
      const LatticeWords lattice = random_lattice(codec_, random, 8);
      if (random.chance(0.5)) send(lattice_packet(lattice));
      for (int set = 0; set < 3; ++set) {
        send(random_span_packets(codec_, random, GetParam().core));
        const auto results =
            derivatives() && random.chance(0.3) ? Results::kDerivatives : Results::kPosition;
        send(vertices_packet(
            random_vertices(codec_, random, {8, 8, 8}, 1 + random.below(4), random.chance(0.3)),
            OutsideMode::kClamp, results));
        if (random.chance(0.3)) send(interleaved_packet(make_stimulus("random", codec_, 1, round)));
      }
      if (random.chance(0.3)) send(random_packets(codec_, random, 2));
    }
    ASSERT_NO_FATAL_FAILURE(finish());
    EXPECT_GT(results().size(), kRounds);
    const event::Code wanted[] = {event::kSpanBeyond, event::kUnknownOpcode, event::kPacketShort,
                                  event::kPacketLong};
    for (const event::Code code : wanted) EXPECT_GT(counted(code), 0U) << "event " << code;
  }
}

// A reset forgets what a table says, wherever its change was.
TEST_P(Spans, ResetForgetsThem) {
  start(6);
  tb::Random random(6);
  for (std::uint64_t round = 0; round < 20; ++round) {
    send(spans_packets(0, 0, random_spans(codec_, random, 2)));
    send(coefficients_packet(random_coefficients(codec_, random)));
    send(lattice_packet(random_lattice(codec_, random, {4, 5, 6})));
    send(spans_packets(1, 1, random_spans(codec_, random, 2)));
    send(vertices_packet(random_vertices(codec_, random, {4, 5, 6}, 4)));
    ASSERT_NO_FATAL_FAILURE(finish());
    EXPECT_EQ(results().size(), 4U);
    send(spans_packets(0, 0, random_spans(codec_, random, 2)));  // its change is under way
    run_->bench().run();
    run_->reset();
  }
}

// What each bad packet raises does not come from the model; what is behind it does, to the bit.
TEST_P(Spans, BadPackets) {
  const int last = spans_ - 1;
  struct Bad {
    const char* what;
    int word;
    std::uint32_t bits;  ///< changed in the header of a good packet of two spans from 0 on
    event::Code code;
  };
  std::vector<Bad> bad{
      {"an unknown flag", 0, 1U << 17, event::kUnknownOpcode},
      {"the highest flag", 0, 1U << 31, event::kUnknownOpcode},
      {"a page", 0, 1U << 8, event::kUnknownOpcode},
      {"an axis 3", 2, 3U << 22, event::kUnknownOpcode},
      {"a degree of axis t", 2, 1U << 2, event::kUnknownOpcode},
      {"a shift of axis t", 2, 1U << 6, event::kUnknownOpcode},
      {"a bit before k'", 2, 1U << 17, event::kUnknownOpcode},
      {"a bit behind k'", 2, 1U << 20, event::kUnknownOpcode},
      {"a bit before D", 2, 1U << 30, event::kUnknownOpcode},
      {"an origin", 3, 1U << 16, event::kUnknownOpcode},
      {"an exponent", 3, 1, event::kUnknownOpcode},
      {"first at the last span", 2, static_cast<std::uint32_t>(last) << 8, event::kSpanBeyond},
      {"first beyond the table", 2, 0xFFU << 8, event::kSpanBeyond},
      {"a large count", 1, 1U << 31, event::kSpanBeyond},
      {"a count of 258", 1, 1U << 8, event::kSpanBeyond},
      {"a count of 0", 1, 2, event::kPacketShort},
      {"a count of 3", 1, 1, event::kPacketShort},
      {"a count of 1", 1, 3, event::kPacketLong},
  };
  tb::Random random(1);
  for (const Bad& fault : bad) {
    SCOPED_TRACE(fault.what);
    start(1);
    send(coefficients_packet(random_coefficients(codec_, random)));
    const LatticeWords lattice = random_lattice(codec_, random, most_points());
    send(lattice_packet(lattice));
    auto packet =
        spans_packets(0, 0, std::vector<AxisWords>(2, random_spans(codec_, random, 1)[0]));
    packet[0].words[fault.word] ^= fault.bits;
    send(packet);
    send(vertices_packet(random_vertices(codec_, random, lattice.dims, 5)));
    const auto again = random_spans(codec_, random, 1);
    send(spans_packets(1, 1, again));
    send(vertices_packet(random_vertices(codec_, random, lattice.dims, 5)));
    ASSERT_NO_FATAL_FAILURE(finish());
    ASSERT_EQ(results().size(), 10U);
    // Functions are any, so results may saturate, and functions may not sum to one.
    const auto saturated = static_cast<unsigned>(event::kSaturated);
    for (unsigned e = 0; e < kStreamEvents; ++e) {
      if (e == saturated || e == stream_event(event::kFunctionsSum)) continue;
      EXPECT_EQ(run_->bench().events()[e], e == stream_event(fault.code) ? 1U : 0U)
          << "event " << e;
    }
  }
}

// A set of three packets comes into use as one; vertices between them see what was there.
TEST_P(Spans, ASetComesIntoUseAsOne) {
  start(2);
  tb::Random random(2);
  const std::array<int, 3> dims{most_points(), 4, 4};
  const LatticeWords lattice = random_lattice(codec_, random, dims);
  send(coefficients_packet(random_coefficients(codec_, random)));
  send(lattice_packet(lattice));
  std::vector<VertexBeat> vertices = random_vertices(codec_, random, dims, dims[0] - 3);
  for (std::size_t v = 0; v < vertices.size(); ++v) vertices[v].cell[0] = static_cast<int>(v);
  const auto changed = random_spans(codec_, random, 2);
  send(vertices_packet(vertices));
  send(spans_packets(0, 0, {changed[0]}, Functions::kBlending, SpanSet::kGoesOn));
  send(vertices_packet(vertices));
  send(spans_packets(0, 1, {changed[1]}));
  send(vertices_packet(vertices));
  auto cut = spans_packets(0, 0, {changed[1]});
  cut.pop_back();
  cut.back().last = true;
  send(cut);
  send(vertices_packet(vertices));
  ASSERT_NO_FATAL_FAILURE(finish());
  const std::size_t count = vertices.size();
  const std::vector<Beat>& results = this->results();
  ASSERT_EQ(results.size(), 4 * count);
  for (std::size_t v = 0; v < count; ++v) {
    EXPECT_EQ(results[v].words, results[count + v].words) << "before E, cell " << v;
    EXPECT_EQ(results[v].words != results[2 * count + v].words, v < 2) << "after E, cell " << v;
    EXPECT_EQ(results[2 * count + v].words, results[3 * count + v].words) << "cut, cell " << v;
  }
}

// Vertices of one cell, whose functions change each time: once, and twice, which is where they
// were.
TEST_P(Spans, ACellSeesEachChange) {
  start(7);
  tb::Random random(7);
  const LatticeWords lattice = random_lattice(codec_, random, {5, 5, 5});
  const auto vertex = random_vertices(codec_, random, {4, 4, 4}, 1);
  send(coefficients_packet(random_coefficients(codec_, random)));
  send(lattice_packet(lattice));
  send(vertices_packet(vertex));
  constexpr std::size_t kChanges = 24;
  for (std::size_t change = 0; change < kChanges; ++change) {
    for (std::size_t set = 0; set <= change % 3; ++set) {
      send(spans_packets(static_cast<int>(change % 3), 0, random_spans(codec_, random, 1)));
    }
    send(vertices_packet(vertex));
    send(vertices_packet(vertex));
  }
  ASSERT_NO_FATAL_FAILURE(finish());
  ASSERT_EQ(results().size(), 1 + 2 * kChanges);
  std::size_t others = 0;
  for (std::size_t change = 0; change < kChanges; ++change) {
    EXPECT_EQ(results()[2 * change + 1].words, results()[2 * change + 2].words);
    if (results()[2 * change].words != results()[2 * change + 1].words) ++others;
  }
  EXPECT_GE(others, kChanges / 2);
}

TEST_P(Spans, ClampedCornersAreTheirControlPoints) {
  start(3);
  tb::Random random(3);
  const std::array<int, 3> dims{most_points(), 5, 4};
  const LatticeWords lattice = send_uneven(random, dims);
  std::vector<VertexBeat> corners(8);
  for (unsigned corner = 0; corner < 8; ++corner) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool end = (corner >> axis & 1) != 0;
      corners[corner].cell[axis] = end ? dims[axis] - 4 : 0;
      corners[corner].local[axis] = codec_.coordinate(end ? 1.0 : 0.0);
    }
  }
  send(vertices_packet(corners));
  ASSERT_NO_FATAL_FAILURE(finish());
  ASSERT_EQ(results().size(), 8U);
  for (unsigned corner = 0; corner < 8; ++corner) {
    int at = 0;
    for (int axis = 0; axis < 3; ++axis) {
      at = at * dims[axis] + ((corner >> axis & 1) != 0 ? dims[axis] - 1 : 0);
    }
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(results()[corner].words[c], lattice.points[at][c]) << corner << " " << c;
    }
  }
}

TEST_P(Spans, VerticesAreThoseOfDeBoor) {
  start(4);
  tb::Random random(4);
  const std::array<int, 3> dims{most_points(), 6, 5};
  const LatticeWords lattice = send_uneven(random, dims);
  const auto vertices = random_vertices(codec_, random, dims, 300);
  send(vertices_packet(vertices));
  ASSERT_NO_FATAL_FAILURE(finish());
  ASSERT_EQ(results().size(), vertices.size());
  const auto parameter = [&](const VertexBeat& vertex, std::size_t axis) {
    const double* knot = &knots_[axis][vertex.cell[axis] + 3];
    return knot[0] + codec_.decode_coordinate(vertex.local[axis]) * (knot[1] - knot[0]);
  };
  const auto along = [&](const VertexBeat& vertex, std::size_t axis, std::vector<double> points) {
    return static_cast<double>(DeBoor(knots_[axis], std::move(points))
                                   .at(vertex.cell[axis] + 3, parameter(vertex, axis))
                                   .value);
  };
  double largest = 0;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<double> column(dims[0]);
      for (int i = 0; i < dims[0]; ++i) {
        std::vector<double> row(dims[1]);
        for (int j = 0; j < dims[1]; ++j) {
          std::vector<double> line(dims[2]);
          for (int k = 0; k < dims[2]; ++k) {
            line[k] = codec_.decode_point(lattice.points[(i * dims[1] + j) * dims[2] + k][c]);
          }
          row[j] = along(vertices[v], 2, line);
        }
        column[i] = along(vertices[v], 1, row);
      }
      const double expected = along(vertices[v], 0, column);
      largest = std::max(largest, std::abs(codec_.decode_point(results()[v].words[c]) - expected));
    }
  }
  std::printf("%s: off by %.3g at most\n", row_.name, largest);
  EXPECT_LE(largest, codec_.is_float() ? 0x1p-20 : 0x1p-12);
}

// Spans of knots sum to one, however their coefficients are rounded; one that does not is told
// where the organization wants it.
TEST_P(Spans, ThoseThatDoNotSumToOneAreTold) {
  start(8);
  const std::vector<double> knots = uneven_knots(most_points());
  const Functions functions = derivatives() ? Functions::kDerivativesToo : Functions::kBlending;
  const std::vector<Beat> vertex = interleaved_packet(make_stimulus("random", codec_, 1, 8));
  std::vector<AxisWords> spans = encode(watertight_spans(knots, codec_), codec_);
  run_->send_bspline(functions);
  send(spans_packets(0, 0, spans, functions));
  send(spans_packets(1, 0, encode(knot_spans(knots), codec_), functions));
  send(vertex);
  ASSERT_NO_FATAL_FAILURE(finish());
  EXPECT_EQ(counted(event::kFunctionsSum), 0U);
  spans[1].word[2][1] ^= 1U << 20;
  spans[2].derivative.word[0][0] ^= 1U << 20;
  send(spans_packets(2, 0, spans, functions));
  send(vertex);
  ASSERT_NO_FATAL_FAILURE(finish());
  const bool wanted = completes(organization_of(row_).form);
  EXPECT_EQ(counted(event::kFunctionsSum), !wanted ? 0U : derivatives() ? 2U : 1U);
}

// Vertices on faces, edges and corners that cells share get the same bits from each of them.
TEST_P(Spans, SeamsAreWatertight) {
  start(5);
  tb::Random random(5);
  const std::array<int, 3> dims{most_points(), most_points(), 6};
  send_uneven(random, dims);
  std::vector<VertexBeat> vertices;
  for (int place = 0; place < 100; ++place) {
    VertexBeat lower = random_vertices(codec_, random, dims, 1)[0];
    VertexBeat upper = lower;
    for (int axis = 0; axis < 3; ++axis) {
      if (lower.cell[axis] == dims[axis] - 4 || !random.chance(0.6)) continue;
      lower.local[axis] = codec_.coordinate(1.0);
      upper.local[axis] = codec_.coordinate(0.0);
      upper.cell[axis] = lower.cell[axis] + 1;
    }
    vertices.push_back(lower);
    vertices.push_back(upper);
  }
  send(vertices_packet(vertices));
  ASSERT_NO_FATAL_FAILURE(finish());
  ASSERT_EQ(results().size(), vertices.size());
  int compared = 0;
  for (std::size_t v = 0; v < vertices.size(); v += 2) {
    for (std::size_t c = 0; c < 3; ++c) {
      EXPECT_EQ(results()[v].words[c], results()[v + 1].words[c]) << v;
    }
    compared += vertices[v].cell != vertices[v + 1].cell ? 3 : 0;
  }
  EXPECT_GE(compared, 150);
}

INSTANTIATE_TEST_SUITE_P(, Spans, ::testing::ValuesIn(page_builds()), by_name);

}  // namespace
}  // namespace hwffd::test
