#include "plates/subjects.hpp"

#include <utility>

#include "hwffd/lattice/around.hpp"
#include "plates/chairs.hpp"

namespace hwffd::plates {
namespace {

const Point kFront(0.55, 0.42, 1);
const Point kSide(-0.9, 0.45, 0.8);

Lattice one_cell(const Points& inside) { return lattice_around("box", inside, {4, 4, 4}); }

Subject cat() {
  Mesh mesh = load_model("");
  Lattice rest = one_cell(mesh.positions());
  return {std::move(mesh), std::move(rest), "twist:90", {kFront, kSide}};
}

/// The cell holds the stem and what is below it.
Subject office() {
  Mesh mesh = office_chair();
  Points low = mesh.positions();
  Eigen::Index count = 0;
  for (Eigen::Index v = 0; v < mesh.positions().rows(); ++v) {
    if (mesh.positions()(v, 1) < kOfficeStemTop) low.row(count++) = mesh.positions().row(v);
  }
  Lattice rest = one_cell(low.topRows(count));
  return {std::move(mesh), std::move(rest), "shear:0.5", {kSide, kFront}};
}

Subject chair() {
  Mesh mesh = wooden_chair();
  Lattice rest = one_cell(mesh.positions());
  return {std::move(mesh), std::move(rest), "twist:90", {kFront}};
}

}  // namespace

std::vector<Subject> subjects() {
  std::vector<Subject> all;
  all.push_back(cat());
  all.push_back(office());
  all.push_back(chair());
  return all;
}

}  // namespace hwffd::plates
