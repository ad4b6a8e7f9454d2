// Vertices with their derivatives, and with det J: four results, two or one a vertex, in the core
// with streams; every bit against the model, values against the oracle.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/determinant.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

class Derivatives : public PerConfiguration {};

/// A lattice on the device and vertices in it, uniform.
struct Scene {
  Lattice lattice;
  std::vector<Embedded> vertices;

  Scene(const std::string& deformation, std::size_t count, std::uint64_t seed)
      : lattice(Deformation::parse(deformation)
                    .apply(Box({-1, -1, -1}, 2 * Eigen::Matrix3d::Identity()).lattice({6, 5, 7}))) {
    tb::Random random(seed);
    const Index3 cells = lattice.cells();
    for (std::size_t v = 0; v < count; ++v) {
      Embedded& vertex = vertices.emplace_back();
      for (int a = 0; a < 3; ++a) {
        vertex.cell[a] = static_cast<int>(random.below(cells[a]));
        vertex.local[a] = random.unit();
      }
    }
  }

  /// Coefficients, the lattice and the vertices, to their results.
  std::vector<Beat> results(SystemRun& run, const Normalization& normalization,
                            Results wanted) const {
    run.send_bspline();
    run.send(lattice_packet(lattice_words(lattice, run.codec(), normalization)));
    run.send(vertices_packet(vertex_beats(vertices, run.codec()), OutsideMode::kClamp, wanted));
    EXPECT_TRUE(run.run());
    EXPECT_EQ(run.bench().results().size(), results_of(wanted) * vertices.size());
    return run.bench().results();
  }

  /// Of the stream's coordinates.
  Oracle::Jet jet(std::size_t v, const Normalization& normalization) const {
    Support support = lattice.support(vertices[v].cell);
    for (int p = 0; p < 64; ++p) {
      support.row(p) = normalization.to_stream(support.row(p).transpose()).transpose();
    }
    return Oracle().jet(support, vertices[v].local);
  }
};

/// Largest error of a derivative of the B-spline times 2^-exponent; docs/numerics.md section 9.
double bound(const std::string& format) {
  return WordCodec(format).is_float() ? 1e-6
         : format == "fx16"           ? 6e-4
         : format == "fx17"           ? 3e-4
         : format == "fx18"           ? 1.5e-4
                                      : 1e-8;
}

/// The same of det J times 2^-(2 + 3 exponent).
double determinant_bound(const std::string& format) {
  return WordCodec(format).is_float() ? 2e-6
         : format == "fx16"           ? 8e-5
         : format == "fx17"           ? 4e-5
         : format == "fx18"           ? 2e-5
                                      : 2e-9;
}

TEST_P(Derivatives, FourResultsAVertexNearTheOracle) {
  const Scene scene("twist:90", share_of(100), 1);
  SystemRun run(GetParam(), 1, "gaps", "bernoulli");
  const WordCodec& codec = run.codec();
  const Normalization normalization = Normalization::of(scene.lattice, codec);
  const int exponent = encode(watertight_bspline(codec), codec).derivative.exponent;
  const std::vector<Beat> results = scene.results(run, normalization, Results::kDerivatives);
  ASSERT_FALSE(HasFailure());
  double largest = 0;
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    const Oracle::Jet jet = scene.jet(v, normalization);
    for (std::size_t part = 0; part < 4; ++part) {
      const Beat& result = results[4 * v + part];
      EXPECT_EQ(result.words[3], v) << "tag and no status, vertex " << v << " part " << part;
      EXPECT_EQ(result.last, 4 * v + part + 1 == results.size());
      if (part == 0) continue;
      const Eigen::Vector3d exact =
          std::ldexp(1.0, -exponent) * jet.jacobian.col(static_cast<Eigen::Index>(part) - 1);
      largest = std::max(largest, (point_of(result, codec) - exact).cwiseAbs().maxCoeff());
    }
  }
  std::printf("%zu vertices, largest error %.3g\n", scene.vertices.size(), largest);
  EXPECT_LE(largest, bound(GetParam().format));
  EXPECT_GT(largest, 0);
}

// det J near the oracle's, its flag with the oracle's sign wherever that is beyond the error; an
// upright lattice and one pulled through itself.
TEST_P(Derivatives, DeterminantAndItsSign) {
  std::size_t upright = 0;
  std::size_t folded = 0;
  for (const char* deformation : {"twist:60", "random:7"}) {
    Scene scene(deformation, share_of(100), 2);
    Points points = scene.lattice.points();
    if (std::string(deformation) == "random:7") points.col(0) *= -1;  // a mirror
    scene.lattice = Lattice(scene.lattice.dims(), points);
    SystemRun run(GetParam(), 1, "bursts", "gaps");
    const WordCodec& codec = run.codec();
    const Normalization normalization = Normalization::of(scene.lattice, codec);
    const int exponent = encode(watertight_bspline(codec), codec).derivative.exponent;
    const int shift = codec.has_fixed_weights() ? model::kDeterminantShift + 3 * exponent : 0;
    const std::vector<Beat> results = scene.results(run, normalization, Results::kDeterminant);
    ASSERT_FALSE(HasFailure());
    for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
      const Beat& result = results[2 * v + 1];
      const double exact = std::ldexp(scene.jet(v, normalization).jacobian.determinant(), -shift);
      EXPECT_NEAR(codec.decode_point(result.words[0]), exact, determinant_bound(GetParam().format));
      EXPECT_EQ(result.words[1] | result.words[2], 0U);
      if (std::abs(exact) < determinant_bound(GetParam().format)) continue;
      const bool fold = (result.words[3] & kStatusFolded) != 0;
      EXPECT_EQ(fold, exact < 0) << "vertex " << v << ", det J " << exact;
      (fold ? folded : upright)++;
    }
  }
  EXPECT_GT(upright, share_of(20));
  EXPECT_GT(folded, share_of(20));
  std::printf("%zu upright, %zu folded\n", upright, folded);
}

TEST_P(Derivatives, SameBitsAsInterleaved) {
  const Scene scene("twist:90", share_of(20), 3);
  for (const Results wanted :
       {Results::kDerivatives, Results::kDeterminant, Results::kDeterminantAlone}) {
    SystemRun run(GetParam(), 1, "gaps", "bernoulli");
    const Normalization normalization = Normalization::of(scene.lattice, run.codec());
    const std::vector<Beat> resident = scene.results(run, normalization, wanted);
    run.send(
        interleaved_packet(interleave(scene.lattice, scene.vertices, run.codec(), normalization),
                           OutsideMode::kClamp, wanted));
    ASSERT_TRUE(run.run());
    const std::vector<Beat>& results = run.bench().results();
    ASSERT_EQ(results.size(), 2 * resident.size());
    for (std::size_t r = 0; r < resident.size(); ++r) {
      EXPECT_EQ(resident[r].words, results[resident.size() + r].words);
    }
  }
}

// Alone it is the det J that comes with the position, in every bit.
TEST_P(Derivatives, DeterminantAloneIsThatOfTwo) {
  const Scene scene("random:7", share_of(50), 5);
  SystemRun run(GetParam(), 1, "bursts", "gaps");
  const Normalization normalization = Normalization::of(scene.lattice, run.codec());
  const std::vector<Beat> two = scene.results(run, normalization, Results::kDeterminant);
  ASSERT_FALSE(HasFailure());
  run.send(vertices_packet(vertex_beats(scene.vertices, run.codec()), OutsideMode::kClamp,
                           Results::kDeterminantAlone));
  ASSERT_TRUE(run.run());
  const std::vector<Beat>& results = run.bench().results();
  ASSERT_EQ(results.size(), two.size() + scene.vertices.size());
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    EXPECT_EQ(results[two.size() + v].words, two[2 * v + 1].words) << "vertex " << v;
    EXPECT_EQ(results[two.size() + v].last, v + 1 == scene.vertices.size());
  }
}

/// Clocks of a vertex: evaluations follow each other as vertices do, so 4 intervals, also where det
/// J is behind them, and 3 for det J alone; where one pass gives all, one of them, or a clock for
/// each result beat.
double clocks_of(const Configuration& row, Results wanted) {
  const double interval = expected_interval(row);
  if (gives_jacobian(row)) return std::max(interval, static_cast<double>(results_of(wanted)));
  // In `walk` the position and the derivative along s are one run.
  return walks(row) || wanted == Results::kDeterminantAlone ? 3 * interval : 4 * interval;
}

TEST_P(Derivatives, ClocksAVertex) {
  // An accumulator takes two, three, four, eight or nine evaluations in turn, an FMAC as many as
  // its clocks.
  const auto rounds = static_cast<std::size_t>(72 * std::max(GetParam().fma_latency, 1));
  for (const Results wanted :
       {Results::kDerivatives, Results::kDeterminant, Results::kDeterminantAlone}) {
    SystemRun run(GetParam(), 1);
    tb::Random random(1);
    const LatticeWords lattice = random_lattice(run.codec(), random, 16);
    const std::size_t each = results_of(wanted);
    run.send_bspline();
    run.send(lattice_packet(lattice));
    run.send(vertices_packet(random_vertices(run.codec(), random, lattice.dims, 20 + rounds + 1),
                             OutsideMode::kClamp, wanted));
    ASSERT_TRUE(run.run());
    EXPECT_EQ(
        run.bench().clocks_per_result(20 * each, (20 + rounds) * each) * static_cast<double>(each),
        clocks_of(GetParam(), wanted));
  }
}

TEST_P(Derivatives, AsOftenAsTheyAreAsked) {
  SystemRun run(GetParam(), 1, "bernoulli", "bursts");
  tb::Random random(4);
  std::size_t expected = 0;
  run.send_bspline();
  for (int packet = 0; packet < 24; ++packet) {
    const auto wanted = static_cast<Results>(random.below(4));
    const auto vertices = make_stimulus("random", run.codec(), random.between(1, 3), packet + 1);
    run.send(interleaved_packet(vertices, OutsideMode::kClamp, wanted));
    if (random.chance(0.4)) run.send_bspline();
    expected += results_of(wanted) * vertices.size();
  }
  ASSERT_TRUE(run.run());
  EXPECT_EQ(run.bench().results().size(), expected);
}

TEST_P(Derivatives, WithoutTheirFunctionsAreBlank) {
  SystemRun run(GetParam(), 1);
  const auto vertices = make_stimulus("random", run.codec(), 3, 1);
  run.send_bspline();
  run.send(coefficients_packet(watertight_bspline(run.codec()), run.codec()));
  for (const Results wanted : {Results::kDerivatives, Results::kDeterminant,
                               Results::kDeterminantAlone, Results::kPosition}) {
    run.send(interleaved_packet(vertices, OutsideMode::kClamp, wanted));
  }
  ASSERT_TRUE(run.run());
  const std::vector<Beat>& results = run.bench().results();
  ASSERT_EQ(results.size(), 12U + 6U + 3U + 3U);
  for (std::size_t r = 0; r < results.size(); ++r) {
    const bool blank = r < 21;
    EXPECT_EQ(results[r].words[3] >> 16, blank ? kStatusUnloaded >> 16 : 0U) << "result " << r;
    if (blank) {
      EXPECT_EQ(results[r].words[0], run.codec().is_float() ? 0x7FC00000U : 0U);
    }
  }
  EXPECT_EQ(run.bench().events()[event::kNoCoefficients], 9U)
      << "vertices before what they want of coefficients";
}

HWFFD_FOR_EACH_CONFIGURATION(Derivatives);

}  // namespace
}  // namespace hwffd::test
