#include "compare/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <string>

#include "hwffd/atomic_file.hpp"
#include "hwffd/device/device.hpp"
#include "hwffd/error.hpp"
#include "hwffd/numerics/largest_error.hpp"
#include "hwffd/oracle/oracle.hpp"
#include "hwffd/tb/random.hpp"

namespace hwffd::compare {
namespace {

constexpr int kAxis = 16;        // points
constexpr int kSteps = 1 << 16;  // of a number between 0 and 1

Lattice random_lattice(tb::Random& random) {
  Points points(kAxis * kAxis * kAxis, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i) {
    const auto steps = static_cast<double>(random.between(1, 2 * kSteps - 1));
    points.data()[i] = steps / kSteps - 1;
  }
  // The ends, so that the lattice's centre is 0 and no format scales it.
  points.row(0).setConstant(1.0 / kSteps - 1);
  points.row(points.rows() - 1).setConstant(1 - 1.0 / kSteps);
  return {{kAxis, kAxis, kAxis}, points};
}

template <class Number>
std::string bytes_of(const std::vector<Number>& numbers) {
  std::string bytes(numbers.size() * sizeof(Number), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  return bytes;
}

std::string bytes_of(const Points& points) {
  std::vector<double> numbers;
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    for (Eigen::Index c = 0; c < 3; ++c) numbers.push_back(points(row, c));
  }
  return bytes_of(numbers);
}

}  // namespace

Scene random_scene(std::size_t vertices, std::uint64_t seed) {
  tb::Random random(seed);
  Scene scene{random_lattice(random), std::vector<Embedded>(vertices), {}};
  const Index3 cells = scene.lattice.cells();
  const Oracle oracle;
  scene.exact.resize(static_cast<Eigen::Index>(vertices), 3);
  for (std::size_t v = 0; v < vertices; ++v) {
    Embedded& vertex = scene.vertices[v];
    vertex.inside = true;
    for (std::size_t a = 0; a < 3; ++a) {
      vertex.cell[a] = static_cast<int>(random.below(static_cast<std::uint64_t>(cells[a])));
      vertex.local[static_cast<Eigen::Index>(a)] =
          static_cast<double>(random.below(kSteps)) / kSteps;
    }
    scene.exact.row(static_cast<Eigen::Index>(v)) = oracle.evaluate(
        scene.lattice.support(vertex.cell), vertex.local[0], vertex.local[1], vertex.local[2]);
  }
  return scene;
}

Scene sorted_by_cell(const Scene& scene) {
  std::vector<std::size_t> order(scene.vertices.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return scene.vertices[a].cell < scene.vertices[b].cell;
  });
  Scene sorted{scene.lattice, {}, Points(scene.exact.rows(), 3)};
  sorted.vertices.reserve(order.size());
  for (const std::size_t v : order) {
    sorted.exact.row(static_cast<Eigen::Index>(sorted.vertices.size())) =
        scene.exact.row(static_cast<Eigen::Index>(v));
    sorted.vertices.push_back(scene.vertices[v]);
  }
  return sorted;
}

Scene first_of(const Scene& scene, std::size_t vertices) {
  const std::size_t count = std::min(vertices, scene.vertices.size());
  const auto begin = scene.vertices.begin();
  return {scene.lattice,
          {begin, begin + static_cast<std::ptrdiff_t>(count)},
          scene.exact.topRows(static_cast<Eigen::Index>(count))};
}

GridScene grid_scene(const Lattice& lattice, std::size_t vertices) {
  const double of_axis = std::cbrt(static_cast<double>(vertices));
  const auto count = static_cast<std::uint16_t>(std::clamp(std::lround(of_axis), 2L, 1000L));
  GridScene result{{lattice, {}, {}}, {}};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::int64_t steps = std::int64_t{lattice.cells()[a]} * kSteps / (count - 1);
    result.grid.step[a] = steps * ((std::int64_t{1} << kGridFraction) / kSteps);
    result.grid.count[a] = count;
  }
  Scene& scene = result.scene;
  scene.vertices = places_of(result.grid, lattice.cells());
  scene.exact.resize(static_cast<Eigen::Index>(scene.vertices.size()), 3);
  const Oracle oracle;
  for (std::size_t v = 0; v < scene.vertices.size(); ++v) {
    const Embedded& at = scene.vertices[v];
    scene.exact.row(static_cast<Eigen::Index>(v)) =
        oracle.evaluate(lattice.support(at.cell), at.local[0], at.local[1], at.local[2]);
  }
  return result;
}

double largest_error(const Scene& scene, const Points& positions) {
  if (positions.rows() != scene.exact.rows()) throw Error("not a position for each vertex");
  double largest = 0;
  for (Eigen::Index row = 0; row < positions.rows(); ++row) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      raise_to(largest, std::abs(positions(row, c) - scene.exact(row, c)));
    }
  }
  return largest;
}

void write_scene(const Scene& scene, const std::filesystem::path& folder) {
  std::vector<std::int32_t> cells;
  std::vector<double> local;
  for (const Embedded& vertex : scene.vertices) {
    for (std::size_t a = 0; a < 3; ++a) {
      cells.push_back(vertex.cell[a]);
      local.push_back(vertex.local[static_cast<Eigen::Index>(a)]);
    }
  }
  std::filesystem::create_directories(folder);
  write_files({{folder / "points.f64", bytes_of(scene.lattice.points())},
               {folder / "cells.i32", bytes_of(cells)},
               {folder / "local.f64", bytes_of(local)},
               {folder / "exact.f64", bytes_of(scene.exact)}});
}

}  // namespace hwffd::compare
