#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "corpus.hpp"
#include "fuzz.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/embedder.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/lattice/outside.hpp"
#include "hwffd/lattice/shape.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "points_file.hpp"
#include "program.hpp"
#include "stages.hpp"

namespace hwffd {
namespace {

void expect_valid(const Lattice& lattice) {
  Eigen::Index points = 1;
  for (const int n : lattice.dims()) {
    expect(n >= Lattice::kMinPoints && n <= Lattice::kMaxPoints, "dims out of range");
    points *= n;
  }
  expect(lattice.points().rows() == points, "another number of points than dims say");
  expect(lattice.points().allFinite(), "a point that is not finite");
}

void read_lattice_text(const std::string& input) {
  const Lattice lattice = parse_lattice(input);
  expect_valid(lattice);
  const Lattice again = parse_lattice(lattice_text(lattice));
  expect(again.dims() == lattice.dims() && again.points() == lattice.points(),
         "the lattice does not come back from its text");
}

void read_deformation(const std::string& input) {
  static const Lattice box = parse_lattice(lattice_corpus().front());
  const Deformation deformation = Deformation::parse(input);
  expect(std::isfinite(deformation.amount()), "an amount that is not finite");
  expect(deformation.arguments().vector.allFinite(), "a vector that is not finite");
  if (deformation.kind() == Deformation::Kind::kTo) return;  // a file's name is quoted as it is
  const Lattice moved = deformation.apply(box);
  expect_valid(moved);
  expect(moved.dims() == box.dims(), "other dims after a deformation");
}

void read_outside(const std::string& input) {
  const Outside outside = Outside::parse(input);
  expect(std::isfinite(outside.width()) && outside.width() >= 0, "a width that is not finite");
  for (const double distance : {0.0, 0.3, 1e300}) {
    const double weight = outside.weight(distance);
    expect(weight >= 0 && weight <= 1, "a weight outside [0, 1]");
  }
}

/// The stages of a command line, and their lattices at rest but for files.
void read_stages(const std::string& input) {
  CLI::App app;
  app.set_help_flag();
  const command::StageOptions options(app);
  std::istringstream in(input);
  std::vector<std::string> words{"hwffd"};
  for (std::string word; in >> word;) words.push_back(word);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  parse_command_line(app, static_cast<int>(argv.size()), argv.data());
  const Points corners = (Points(2, 3) << 0, 0, 0, 1, 1, 1).finished();
  for (const command::StageText& stage : options.texts()) {
    const std::vector<std::string>& shapes = shape_names();
    if (std::find(shapes.begin(), shapes.end(), stage.lattice) == shapes.end()) continue;
    expect_valid(command::given_lattice(stage, corners).lattice);
  }
}

/// Points, and their places in a box and in a ball.
void read_text_of_points(const std::string& input) {
  static const Points corners = (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished();
  static const Embedder embedders[] = {Embedder(lattice_around("box", corners, {4, 5, 6})),
                                       Embedder(lattice_around("sphere", corners, {4, 5, 6}))};
  std::istringstream in(input);
  const command::PointsFile file(in, "points");
  const Points& points = file.points();
  expect(file.edited(points) == input, "a byte that changed");
  expect(points.rows() > 0 && points.allFinite(), "points that are not finite");
  for (const Embedder& embedder : embedders) {
    for (const Embedding& e : embedder.embed(points)) {
      expect(e.at.local.allFinite() && !std::isnan(e.residual), "a place that is no number");
      embedder.lattice().support(e.at.cell);
    }
  }
}

/// A mesh of a format that is edited: nothing of it changes where nothing moves, and a mirror about
/// the origin has as many vertices and triangles.
void edit_mesh(const std::string& extension, const std::string& input) {
  Mesh mesh = Mesh::load(mesh_folder().write("edit" + extension, input));
  const auto save = [&](double scale) {
    const std::vector<Eigen::Matrix3d> gradients(mesh.vertex_count(),
                                                 scale * Eigen::Matrix3d::Identity());
    mesh.set_positions(scale * mesh.positions(), gradients);
    mesh.save(mesh_folder() / ("edited" + extension));
  };
  save(1);
  expect(read_text(mesh_folder() / ("edited" + extension)) == input, "a byte that changed");
  save(-1);
  const Mesh again = Mesh::load(mesh_folder() / ("edited" + extension));
  // A strip that is turned round may have one more triangle, without area, in front.
  const bool has_strips = extension == ".gltf" || extension == ".glb";
  expect(has_strips ? again.triangles().size() >= mesh.triangles().size()
                    : again.triangles().size() == mesh.triangles().size(),
         "another number of triangles");
  const bool is_same = extension == ".stl" || again.vertex_count_read() == mesh.vertex_count_read();
  expect(is_same, "another number of vertices");
}

Target edit_target(const char* name, std::vector<std::string> corpus) {
  const std::string extension = "." + std::string(name).substr(std::string("edit-").size());
  return {name, std::move(corpus),
          [extension](const std::string& input) { edit_mesh(extension, input); }};
}

}  // namespace

std::vector<Target> targets() {
  return {{"lattice", lattice_corpus(), read_lattice_text},
          {"deformation", deformation_corpus(), read_deformation},
          {"outside", outside_corpus(), read_outside},
          {"stages", stages_corpus(), read_stages},
          {"points", points_corpus(), read_text_of_points},
          edit_target("edit-obj", obj_corpus()),
          edit_target("edit-ply", ply_corpus()),
          edit_target("edit-off", off_corpus()),
          edit_target("edit-stl", stl_corpus()),
          edit_target("edit-gltf", gltf_corpus()),
          edit_target("edit-glb", glb_corpus())};
}

}  // namespace hwffd
