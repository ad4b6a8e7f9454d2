#include "study.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <cstring>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/determinant.hpp"
#include "hwffd/model/stream_model.hpp"
#include "hwffd/numerics/largest_error.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_stimulus.hpp"
#include "hwffd/tb/random.hpp"
#include "hwffd/tb/stream_bench.hpp"

namespace hwffd::tangents {
namespace {

constexpr double kStep = 1e-4;  // of central differences

/// A lattice in its device's coordinates, and vertices in it.
struct Scene {
  Lattice lattice;
  std::vector<Embedded> vertices;
};

Scene scene(const Lattice& lattice, std::size_t count, tb::Random& random) {
  Scene result{lattice, {}};
  const Index3 cells = lattice.cells();
  for (std::size_t v = 0; v < count; ++v) {
    Embedded& vertex = result.vertices.emplace_back();
    for (int a = 0; a < 3; ++a) {
      vertex.cell[a] = static_cast<int>(random.below(cells[a]));
      vertex.local[a] = random.unit();
    }
  }
  return result;
}

/// What a number format is good for; docs/numerics.md section 9.
struct Bounds {
  double derivative;
  double determinant;
};

Bounds bounds_of(const Configuration& row) {
  if (std::strcmp(row.format, "fp32") == 0) return {1e-6, 1e-7};
  if (std::strcmp(row.format, "fx17") == 0) return {6e-4, 2e-4};
  if (std::strcmp(row.format, "fx18") == 0) return {3e-4, 1e-4};
  if (std::strcmp(row.format, "bfp32") == 0) return {6e-8, 3e-9};
  return {3e-8, 3e-8};
}

/// One row: its core's runs add to the result.
class Study {
 public:
  Study(RowResult& result, std::uint64_t seed)
      : result_(result),
        codec_(result.row.format),
        exponent_(encode(watertight_bspline(codec_), codec_).derivative.exponent),
        seed_(seed) {}

  /// The results of packets behind the B-spline's and its derivative's coefficients.
  std::vector<Beat> run(const std::vector<Beat>& packets) {
    const auto core = cores::make_stream_core(result_.row, seed_);
    tb::StreamBenchOptions options;
    options.test = {fmt::format("tangents {}", result_.row.name), seed_,
                    fmt::format("build/lab/tangents/hwffd-tangents --seed {}", seed_)};
    tb::StreamBench bench(*core, options);
    std::vector<Beat> beats =
        coefficients_packet(watertight_bspline(codec_), codec_, Functions::kDerivativesToo);
    append(beats, packets);
    bench.reset(4);
    bench.expect(model::StreamModel(result_.row).run(beats));
    bench.send(beats);
    bench.run();
    if (!bench.finish() && result_.failure.empty()) result_.failure = bench.report();
    result_.mismatches += bench.scoreboard().mismatches() + bench.scoreboard().extra();
    if (bench.results().size() > 1) clocks_per_result_ = bench.clocks_per_result();
    return bench.results();
  }

  void derivatives(const Scene& scene) {
    constexpr std::size_t kEach = hwffd::results_of(Results::kDerivatives);
    const Normalization normalization = Normalization::of(scene.lattice, codec_);
    const std::vector<Beat> results = run(packets(scene, Results::kDerivatives));
    if (results.size() != kEach * scene.vertices.size()) return;
    const double unit = lattice_scale(scene.lattice);
    for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
      const Eigen::Matrix3d exact = jacobian(scene, v);
      for (int axis = 0; axis < 3; ++axis) {
        const Point got = std::ldexp(1.0, exponent_) * normalization.vector_to_world(point_of(
                                                           results[kEach * v + 1 + axis], codec_));
        const Point error = (got - exact.col(axis)) / unit;
        const Point difference = (got - central_difference(scene, v, axis)) / unit;
        raise_to(result_.max_error, error.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
        raise_to(result_.max_difference, difference.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
      }
    }
    result_.vertices += scene.vertices.size();
    result_.clocks_per_vertex = static_cast<double>(kEach) * clocks_per_result_;
  }

  void determinants(const Scene& scene) {
    constexpr std::size_t kEach = hwffd::results_of(Results::kDeterminant);
    const std::vector<Beat> results = run(packets(scene, Results::kDeterminant));
    if (results.size() != kEach * scene.vertices.size()) return;
    const double unit = std::pow(lattice_scale(scene.lattice), 3);
    const int shift = codec_.has_fixed_weights() ? model::kDeterminantShift + 3 * exponent_ : 0;
    const double scale = codec_.is_float() ? 1 / unit : 1.0;  // fixed point is scaled already
    for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
      const Beat& result = results[kEach * v + 1];
      const double got = scale * std::ldexp(codec_.decode_point(result.words[0]), shift);
      const double exact = jacobian(scene, v).determinant() / unit;
      const bool folded = (result.words[3] & kStatusFolded) != 0;
      (folded ? result_.folded : result_.upright)++;
      raise_to(result_.max_determinant_error, std::abs(got - exact));
      const bool certain = std::abs(exact) > result_.determinant_bound;
      if (certain && folded != (exact < 0)) ++result_.wrong_flags;
    }
    result_.vertices += scene.vertices.size();
  }

  /// Derivatives where cells meet, each as all of its cells give it.
  void seams() {
    const tb::SeamStimulus stimulus = tb::seam_stimulus(codec_, kSeamValues / 3, seed_);
    const std::vector<Beat> results = run(
        interleaved_packet(tb::interleaved(stimulus), OutsideMode::kClamp, Results::kDerivatives));
    if (results.size() != 4 * stimulus.vertices.size()) return;
    const auto differences = stimulus.differences(
        3, [&](std::size_t v, std::size_t r) { return results[4 * v + 1 + r].words; });
    result_.seam_values += differences.values;
    result_.seam_differences += differences.count;
  }

 private:
  std::vector<Beat> packets(const Scene& scene, Results wanted) const {
    const Normalization normalization = Normalization::of(scene.lattice, codec_);
    std::vector<Beat> beats = lattice_packet(lattice_words(scene.lattice, codec_, normalization));
    const std::vector<Beat> vertices =
        vertices_packet(vertex_beats(scene.vertices, codec_), OutsideMode::kClamp, wanted);
    append(beats, vertices);
    return beats;
  }

  static Eigen::Matrix3d jacobian(const Scene& scene, std::size_t v) {
    const Embedded& at = scene.vertices[v];
    return Oracle().jet(scene.lattice.support(at.cell), at.local).jacobian;
  }

  static Point central_difference(const Scene& scene, std::size_t v, int axis) {
    const Embedded& at = scene.vertices[v];
    const Support support = scene.lattice.support(at.cell);
    const Eigen::Vector3d step = kStep * Eigen::Vector3d::Unit(axis);
    const Eigen::Vector3d ahead = at.local + step;
    const Eigen::Vector3d behind = at.local - step;
    return (Oracle().evaluate(support, ahead[0], ahead[1], ahead[2]) -
            Oracle().evaluate(support, behind[0], behind[1], behind[2])) /
           (2 * kStep);
  }

  RowResult& result_;
  WordCodec codec_;
  int exponent_;  // of the B-spline's derivative
  std::uint64_t seed_;
  double clocks_per_result_ = 0;
};

/// A box of 6 x 5 x 7 points, its points moved at random, and that mirrored.
std::vector<Lattice> lattices() {
  const Lattice rest = Box({-1, -1, -1}, 2 * Eigen::Matrix3d::Identity()).lattice({6, 5, 7});
  const Lattice twisted = Deformation::parse("twist:90").apply(rest);
  const Lattice moved = Deformation::parse("random:1").apply(rest);
  Points mirrored = moved.points();
  mirrored.col(0) *= -1;
  return {twisted, Lattice(moved.dims(), mirrored)};
}

}  // namespace

RowResult run(const Configuration& row, std::size_t vertices, std::uint64_t seed,
              const std::function<void(double)>& progress) {
  RowResult result{};
  result.row = row;
  result.bound = bounds_of(row).derivative;
  result.determinant_bound = bounds_of(row).determinant;
  Study study(result, seed);
  tb::Random random(seed);
  double done = 0;
  for (const Lattice& lattice : lattices()) {
    const Scene sample = scene(lattice, vertices, random);
    study.derivatives(sample);
    progress(done += 0.2);
    study.determinants(sample);
    progress(done += 0.2);
  }
  study.seams();
  progress(1);
  return result;
}

}  // namespace hwffd::tangents
