// hwffd-web-plates: the subjects of the plates as scenes for the live page, in JSON: each model and
// its lattice, at rest and deformed. Positions are those of eq. (1) in double; `make plates`
// compares the plates with the simulated hardware.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "hwffd/atomic_file.hpp"
#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"
#include "plates/subjects.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;
using Json = nlohmann::ordered_json;

constexpr double kSteps = 8192.0;  // of the largest coordinate: finer is not seen

/// Three numbers a row, as short as a picture wants them.
Json numbers(const Points& points, double largest) {
  const double step = largest / kSteps;
  Json list = Json::array();
  for (Eigen::Index row = 0; row < points.rows(); ++row) {
    for (int axis = 0; axis < 3; ++axis) {
      list.push_back(static_cast<int>(std::lround(points(row, axis) / step)));
    }
  }
  return list;
}

/// The model and its lattice in one of the two states.
Json state(const Attachment& attachment, const Lattice& lattice, double largest) {
  const Oracle::Coefficients spline = Oracle::uniform_bspline();
  const Points carried =
      attachment.follow(evaluate_in(lattice, attachment.places(), {spline, spline, spline}));
  return {{"positions", numbers(carried, largest)}, {"points", numbers(lattice.points(), largest)}};
}

Json scene(const plates::Subject& subject) {
  const Attachment attachment(subject.rest, subject.mesh.positions(), Outside::parse("keep"));
  const Lattice deformed = Deformation::parse(subject.deformation).apply(subject.rest);
  const double largest = std::max(deformed.points().cwiseAbs().maxCoeff(),
                                  subject.mesh.positions().cwiseAbs().maxCoeff());
  Json triangles = Json::array();
  for (const Mesh::Triangle& triangle : subject.mesh.triangles()) {
    for (const std::uint32_t vertex : triangle) triangles.push_back(vertex);
  }
  Json views = Json::array();
  for (const Point& view : subject.views) views.push_back({view.x(), view.y(), view.z()});
  return {{"model", subject.mesh.name()},
          {"step", largest / kSteps},
          {"dims", subject.rest.dims()},
          {"deformation", subject.deformation},
          {"views", views},
          {"triangles", triangles},
          {"rest", state(attachment, subject.rest, largest)},
          {"deformed", state(attachment, deformed, largest)}};
}

int run(int argc, char** argv) {
  std::filesystem::path output = "build/web/plates.json";
  CLI::App app{"Writes the models of the paper's plates in their lattices as JSON."};
  app.add_option("output", output, "the file (build/web/plates.json)");
  parse_command_line(app, argc, argv);
  Json scenes = Json::array();
  for (const plates::Subject& subject : plates::subjects()) scenes.push_back(scene(subject));
  std::filesystem::create_directories(std::filesystem::absolute(output).parent_path());
  write_files({{output, scenes.dump() + "\n"}});
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-web-plates", [&] { return run(argc, argv); });
}
