#include "picture/before_after.hpp"

#include "hwffd/error.hpp"
#include "picture/lattice_drawing.hpp"
#include "picture/mesh_drawing.hpp"

namespace hwffd::picture {
namespace {

constexpr int kWidth = 700;  // of a half
constexpr int kHeight = 600;

}  // namespace

BeforeAfter::BeforeAfter(const Lattice& before, const Lattice& after) {
  try {
    renderer_.emplace(kWidth, kHeight);
  } catch (const Error& error) {
    missing_ = error.what();
    return;
  }
  Points seen(before.points().rows() + after.points().rows(), 3);
  seen << before.points(), after.points();
  camera_ = Camera::around(seen, Point(0.5, 0.35, 1), renderer_->aspect());
}

void BeforeAfter::draw(const Mesh& mesh, const Lattice& lattice) {
  if (!renderer_) return;
  halves_.push_back(renderer_->render(camera_, [&] {
    draw_mesh(mesh);
    draw_lattice(lattice);
  }));
}

}  // namespace hwffd::picture
