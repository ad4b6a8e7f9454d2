#include "study.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "hwffd/bounds/axis_error.hpp"
#include "hwffd/bounds/bound.hpp"
#include "hwffd/lattice/interleave.hpp"
#include "hwffd/model/org_cg.hpp"
#include "hwffd/model/org_factored.hpp"
#include "hwffd/numerics/block.hpp"
#include "hwffd/numerics/largest_error.hpp"
#include "hwffd/on_threads.hpp"
#include "hwffd/oracle/oracle.hpp"

namespace hwffd::bfp {
namespace {

constexpr int kPoints = 8;                // of a lattice, an axis
constexpr std::int64_t kLattice = 16384;  // vertices in one lattice
constexpr int kForms = 2;                 // product, factored

using Engine = std::mt19937_64;

double unit(Engine& engine) { return static_cast<double>(engine() >> 11) * 0x1p-53; }

/// How a coordinate of a control point is drawn, from its layer along s; all are below 1 in
/// magnitude.
struct Distribution {
  const char* name;
  double (*draw)(Engine&, int layer);
};

/// Of either sign, uniform in the binade `below` under 1.
double in_binade(Engine& engine, int below) {
  const double magnitude = std::ldexp(1 + unit(engine), -1 - below);
  return (engine() & 1) != 0 ? magnitude : -magnitude;
}

const std::vector<Distribution>& distributions() {
  static const std::vector<Distribution> all{
      {"uniform in [-1, 1)", [](Engine& engine, int) { return 2 * unit(engine) - 1; }},
      {"uniform in one binade", [](Engine& engine, int) { return in_binade(engine, 0); }},
      {"12 binades along an axis",
       [](Engine& engine, int layer) { return in_binade(engine, 11 * layer / (kPoints - 1)); }},
  };
  return all;
}

int exponent_of(double magnitude) {
  int exponent = 0;
  std::frexp(magnitude, &exponent);
  return exponent;
}

/// A lattice whose points are binary32 numbers.
Lattice draw_lattice(const Distribution& distribution, Engine& engine) {
  Points points(kPoints * kPoints * kPoints, 3);
  for (int row = 0; row < points.rows(); ++row) {
    const int layer = row / (kPoints * kPoints);
    for (int c = 0; c < 3; ++c)
      points(row, c) = static_cast<float>(distribution.draw(engine, layer));
  }
  return {{kPoints, kPoints, kPoints}, points};
}

/// Largest errors of both forms, in ulp.
struct Errors {
  std::array<double, kForms> of_lattice{};
  std::array<double, kForms> of_support{};
};

using hwffd::raise_to;

void raise_to(Errors& largest, const Errors& other) {
  for (int form = 0; form < kForms; ++form) {
    raise_to(largest.of_lattice[form], other.of_lattice[form]);
    raise_to(largest.of_support[form], other.of_support[form]);
  }
}

/// Vertices of one lattice in both forms.
class Measurement {
 public:
  explicit Measurement(const Lattice& lattice)
      : lattice_(lattice), exponent_(block_exponent(lattice.points())) {
    for (Eigen::Index row = 0; row < lattice.points().rows(); ++row) {
      auto& point = points_.emplace_back();
      for (int c = 0; c < 3; ++c) {
        const auto word = bits_of_float(static_cast<float>(lattice.points()(row, c)));
        point[c] = Block32::point(word, exponent_);
      }
    }
  }

  void vertex(Engine& engine, Errors& errors) const {
    model::LocalVertex<Block32> vertex;
    std::array<double, 3> local{};
    for (int axis = 0; axis < 3; ++axis) {
      const auto coordinate = static_cast<float>(unit(engine));
      local[axis] = coordinate;
      vertex.local[axis] = Block32::coordinate(bits_of_float(coordinate));
      vertex.cell[axis] = static_cast<int>(engine() % (kPoints - 3));
    }
    const Support exact_points = lattice_.support(vertex.cell);
    const model::Support<Block32> points = support(vertex.cell);
    const Eigen::Vector3d exact = oracle_.evaluate(exact_points, local[0], local[1], local[2]);
    const int support_exponent = exponent_of(exact_points.cwiseAbs().maxCoeff());
    const std::array<model::VectorSum<Block32>, kForms> sums{
        product_.evaluate(vertex, points, bank_), factored_.evaluate(vertex, points, bank_)};
    for (int form = 0; form < kForms; ++form) {
      for (int c = 0; c < 3; ++c) {
        const double got = float_of_bits(Block32::out(sums[form][c], exponent_).word);
        const double error = std::abs(got - exact[c]);
        raise_to(errors.of_lattice[form], std::ldexp(error, 24 - exponent_));
        raise_to(errors.of_support[form], std::ldexp(error, 24 - support_exponent));
      }
    }
  }

 private:
  model::Support<Block32> support(const std::array<int, 3>& cell) const {
    model::Support<Block32> points;
    for (int p = 0; p < 64; ++p) {
      const int row = (cell[0] + p / 16) * kPoints + cell[1] + p / 4 % 4;
      points[p] = points_[row * kPoints + cell[2] + p % 4];
    }
    return points;
  }

  const Lattice& lattice_;
  int exponent_;
  std::vector<std::array<Block32::Point, 3>> points_;  // of the lattice, aligned once
  Oracle oracle_;
  model::CoefficientBank<Block32> bank_ = bounds::bspline_bank<Block32>("bfp32");
  model::OrgCg<Block32> product_{Configuration{}};
  model::OrgFactored<Block32> factored_{Configuration{}};
};

Errors measure(const Distribution& distribution, std::uint64_t seed, std::int64_t vertices) {
  std::seed_seq sequence{static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32)};
  Engine engine(sequence);
  const Lattice lattice = draw_lattice(distribution, engine);
  const Measurement measurement(lattice);
  Errors errors;
  for (std::int64_t v = 0; v < vertices; ++v) measurement.vertex(engine, errors);
  return errors;
}

}  // namespace

std::vector<Result> study(std::int64_t vertices, std::uint64_t seed, const Progress& progress) {
  const auto each = static_cast<std::size_t>((vertices + kLattice - 1) / kLattice);
  const std::size_t all = each * distributions().size();
  std::vector<Errors> errors(all);
  on_threads(
      all,
      [&](std::size_t part) {
        const std::int64_t first = static_cast<std::int64_t>(part % each) * kLattice;
        errors[part] =
            measure(distributions()[part / each], seed + 0x9E3779B97F4A7C15U * (part + 1),
                    std::min(kLattice, vertices - first));
      },
      [&](std::size_t done) { progress(static_cast<double>(done) / static_cast<double>(all)); });
  const bounds::AxisError axis = bounds::block_axis_error(Block32::kWidth);
  const std::array<double, kForms> bounds{bounds::block_product_bound(Block32::kWidth, axis),
                                          bounds::block_factored_bound(Block32::kWidth, axis)};
  std::vector<Result> results;
  for (std::size_t d = 0; d < distributions().size(); ++d) {
    Errors worst;
    for (std::size_t p = 0; p < each; ++p) raise_to(worst, errors[d * each + p]);
    for (int form = 0; form < kForms; ++form) {
      results.push_back({distributions()[d].name, form == 0 ? "product" : "factored",
                         worst.of_lattice[form], worst.of_support[form], bounds[form], vertices});
    }
  }
  return results;
}

}  // namespace hwffd::bfp
