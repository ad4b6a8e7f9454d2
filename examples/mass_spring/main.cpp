// hwffd-example-mass-spring: free-form deformation as a layer below physical simulation. A mesh is
// embedded once in a lattice whose control points are masses joined by springs. For each frame
// the simulation moves some 150 masses, and eq. (1) takes the thousands of vertices along.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "hwffd/device/device.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/fold.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mass_spring/scenario.hpp"
#include "picture/lattice_drawing.hpp"
#include "picture/mesh_drawing.hpp"
#include "picture/png.hpp"
#include "picture/renderer.hpp"
#include "program.hpp"

namespace {

using namespace hwffd;
using namespace hwffd::mass_spring;

constexpr int kPictures = 8;

struct Options {
  std::string model;
  int frames = 24;
  DeviceChoice device{"model"};
  std::filesystem::path output = "build/mass_spring";
};

Options parse_options(int argc, char** argv) {
  Options options;
  CLI::App app{"Pulls a mesh by its lattice of masses and springs and lets it go."};
  app.add_option("--model", options.model, "mesh file, or a name in glmark2's models (cat.3ds)");
  app.add_option("--frames", options.frames, "meshes to write, 24 a second (24)");
  app.add_option("--device", options.device.device, "model (default), rtl, reference");
  app.add_option("--org", options.device.org, "organization (basic)");
  app.add_option("--format", options.device.format, "number format (fp32)");
  app.add_option("--output", options.output, "folder for meshes and picture (build/mass_spring)");
  parse_command_line(app, argc, argv);
  if (options.frames < 4 || options.frames > 9999) {
    throw UsageError("--frames: expected 4 to 9999");
  }
  return options;
}

/// Points an axis for cells that are about cubes, three along the longest axis: flat cells of
/// springs buckle.
Index3 dims_for(const Box& box) {
  const Eigen::RowVector3d edges = box.edges().colwise().norm();
  Index3 dims{};
  for (const int axis : {0, 1, 2}) {
    const int cells = static_cast<int>(std::lround(3 * edges[axis] / edges.maxCoeff()));
    dims[static_cast<std::size_t>(axis)] = 3 + std::max(axis == 1 ? 2 : 1, cells);
  }
  return dims;
}

/// One camera for the whole film: it has all lattices in its picture.
picture::Camera camera_for(const std::vector<Frame>& film, double aspect) {
  const Eigen::Index rows = film.front().lattice.points().rows();
  Points all(rows * static_cast<Eigen::Index>(film.size()), 3);
  for (std::size_t f = 0; f < film.size(); ++f) {
    all.middleRows(static_cast<Eigen::Index>(f) * rows, rows) = film[f].lattice.points();
  }
  return picture::Camera::around(all, Point(0.15, 0.25, 1), aspect);
}

void print(std::size_t number, const Frame& frame, double whole, const std::string& folds) {
  fmt::print("{:>5}  {:<8} {:>8.2f} {:>8.2f} {:>8.2f}   {}\n", number,
             frame.released ? "free" : "pulled", 100 * frame.kinetic / whole,
             100 * frame.elastic / whole, 100 * frame.energy() / whole, folds);
}

int run(const Options& options) {
  const std::unique_ptr<Device> device = make_device(options.device);
  Mesh mesh = load_model(options.model);
  const Box box = Box::around(mesh.positions());
  const Index3 dims = dims_for(box);
  const std::vector<Embedded> vertices = box.embed(dims, mesh.positions());

  const std::vector<Frame> film = pull_and_release(box.lattice(dims), options.frames);
  double whole = 0;
  for (const Frame& frame : film) whole = std::max(whole, frame.energy());

  std::filesystem::create_directories(options.output);
  const picture::Renderer renderer(400, 260);
  const picture::Camera camera = camera_for(film, renderer.aspect());
  std::vector<picture::Image> pictures;

  fmt::print("frame           kinetic  elastic   energy   folds (energies in % of the largest)\n");
  for (std::size_t f = 0; f < film.size(); ++f) {
    const Lattice& lattice = film[f].lattice;
    mesh.set_positions(device->evaluate(lattice, vertices));
    mesh.save(options.output / fmt::format("frame-{:04}.obj", f + 1));
    print(f + 1, film[f], whole, check_folds(lattice).text());
    // The frames nearest to kPictures equal parts of the film.
    if (pictures.size() * (film.size() - 1) <= f * (kPictures - 1)) {
      pictures.push_back(renderer.render(camera, [&] {
        picture::draw_mesh(mesh);
        picture::draw_lattice(lattice);
      }));
    }
  }
  const std::filesystem::path strip = options.output / "strip.png";
  picture::write_png(strip, picture::contact_sheet(pictures, kPictures / 2));
  fmt::print("\nwrote {}/frame-0001.obj to frame-{:04}.obj and {}\n", options.output.string(),
             film.size(), strip.string());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return hwffd::run_program("hwffd-example-mass-spring",
                            [&] { return run(parse_options(argc, argv)); });
}
