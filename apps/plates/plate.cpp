#include "plates/plate.hpp"

#include <utility>

#include "hwffd/lattice/attachment.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "picture/lattice_drawing.hpp"
#include "picture/mesh_drawing.hpp"

namespace hwffd::plates {
namespace {

struct Pose {
  std::string name;
  const Lattice& lattice;
};

std::size_t mismatches(const Points& results, const Points& expected) {
  std::size_t count = 0;
  for (Eigen::Index v = 0; v < expected.rows(); ++v) {
    if (results.row(v) != expected.row(v)) ++count;
  }
  return count;
}

std::vector<picture::Camera> cameras(const Subject& subject, const Lattice& deformed,
                                     double aspect) {
  Points seen(subject.mesh.positions().rows() + 2 * deformed.points().rows(), 3);
  seen << subject.mesh.positions(), subject.rest.points(), deformed.points();
  std::vector<picture::Camera> result;
  for (const Point& view : subject.views) {
    result.push_back(picture::Camera::around(seen, view, aspect));
  }
  return result;
}

}  // namespace

std::vector<Plate> plates_of(Subject subject, Device& device, Device& model,
                             const picture::Renderer& renderer) {
  const Attachment attachment(subject.rest, subject.mesh.positions(), Outside::parse("keep"));
  const Lattice deformed = Deformation::parse(subject.deformation).apply(subject.rest);
  const std::vector<picture::Camera> views = cameras(subject, deformed, renderer.aspect());
  std::vector<Plate> plates;
  for (const Pose& pose : {Pose{"at rest", subject.rest}, Pose{subject.deformation, deformed}}) {
    const Points results = device.evaluate(pose.lattice, attachment.places());
    const Points expected = model.evaluate(pose.lattice, attachment.places());
    subject.mesh.set_positions(attachment.follow(results), attachment.gradients(pose.lattice));
    for (const picture::Camera& view : views) {
      picture::Image image = renderer.render(view, [&] {
        picture::draw_mesh(subject.mesh);
        picture::draw_lattice(pose.lattice);
      });
      plates.push_back({subject.mesh.name() + ", " + pose.name, std::move(image),
                        attachment.places().size(), mismatches(results, expected)});
    }
  }
  return plates;
}

}  // namespace hwffd::plates
