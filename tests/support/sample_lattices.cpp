#include "sample_lattices.hpp"

#include <array>
#include <random>

#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/lattice/shape.hpp"

namespace hwffd::test {
namespace {

constexpr double kCustomScale = 1.6;
constexpr std::array<double, 5> kSpecial{0.0, 1.0, 0.5, 1e-12, 1.0 - 1e-12};

Lattice custom_around(const Points& points) {
  const Box tight = Box::around(points);
  const Point grow = tight.edges().diagonal() * (kCustomScale - 1);
  const Point edges = tight.edges().diagonal() + grow;
  const Box box(tight.origin() - grow / 2, edges.asDiagonal());
  const Lattice twisted = Deformation::parse("twist:60").apply(box.lattice({7, 6, 5}));
  return parse_lattice(lattice_text(Deformation::parse("random:1").apply(twisted)));
}

}  // namespace

const std::vector<std::string>& lattice_kinds() {
  static const std::vector<std::string> kinds = [] {
    std::vector<std::string> names = shape_names();
    names.emplace_back("custom");
    return names;
  }();
  return kinds;
}

Lattice sample_lattice(const std::string& kind, const Points& points) {
  if (kind == "custom") return custom_around(points);
  if (const Shape* shape = find_shape(kind)) return lattice_around(kind, points, shape->several);
  throw Error("unknown kind of lattice '" + kind + "'; one of " + shape_list() + ", custom");
}

Points corners() {
  Points points(8, 3);
  for (int c = 0; c < 8; ++c) {
    points.row(c) << 3 + 2 * (c >> 2 & 1), -5 + 3 * (c >> 1 & 1), 7 + (c & 1);
  }
  return points;
}

std::vector<Embedded> known_places(const Lattice& lattice, std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const auto below = [&](std::uint64_t n) { return static_cast<int>(random() % n); };
  const Index3 cells = lattice.cells();
  std::vector<Embedded> places(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t a = 0; a < 3; ++a) {
      places[i].inside = true;
      places[i].cell[a] = below(static_cast<std::uint64_t>(cells[a]));
      double& x = places[i].local[static_cast<Eigen::Index>(a)];
      x = static_cast<double>(random() >> 11) * 0x1p-53;
      if (i % 2 == 0) continue;
      if (below(2) == 0) x = kSpecial[static_cast<std::size_t>(below(kSpecial.size()))];
      if (below(2) == 0) places[i].cell[a] = below(2) * (cells[a] - 1);
    }
  }
  return places;
}

Points points_at(const Embedder& embedder, const std::vector<Embedded>& places) {
  Points points(static_cast<Eigen::Index>(places.size()), 3);
  for (std::size_t i = 0; i < places.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) = embedder.point(places[i]);
  }
  return points;
}

}  // namespace hwffd::test
