#include "study.hpp"

#include <cmath>
#include <ctime>

#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "sample_lattices.hpp"

namespace hwffd::embed {
namespace {

Row measure(const std::string& mesh, const std::string& kind, const Embedder& embedder,
            const Points& points, bool holds_all) {
  return {mesh,
          kind,
          embedder.lattice().dims(),
          summarize(embedder.embed(points)),
          embedder.size(),
          check_folds(embedder.lattice()),
          holds_all};
}

}  // namespace

double fold_check_us_per_cell(int points) {
  const Lattice box = lattice_around("box", test::corners(), Index3{points, points, points});
  const Lattice bent = Deformation::parse("bend:60").apply(box);
  const std::clock_t begin = std::clock();
  check_folds(bent);
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return 1e6 * seconds / std::pow(points - 3, 3);
}

std::vector<Row> by_construction(std::size_t points, std::uint64_t seed) {
  std::vector<Row> rows;
  for (const std::string& kind : test::lattice_kinds()) {
    const Embedder embedder(test::sample_lattice(kind, test::corners()));
    const std::vector<Embedded> places = test::known_places(embedder.lattice(), points, seed);
    rows.push_back(
        measure("by construction", kind, embedder, test::points_at(embedder, places), true));
  }
  return rows;
}

std::vector<Row> of_mesh(const std::string& model) {
  const Mesh mesh = Mesh::load(find_model(model));
  std::vector<Row> rows;
  for (const std::string& kind : test::lattice_kinds()) {
    const Embedder embedder(test::sample_lattice(kind, mesh.positions()));
    // A custom lattice is moved once it is made: what was near its faces may be outside.
    rows.push_back(measure(mesh.name(), kind, embedder, mesh.positions(), kind != "custom"));
  }
  return rows;
}

}  // namespace hwffd::embed
