#include "glu/volume.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "glu/error.hpp"

namespace hwffd::glu {
namespace {

using Values = gl::ControlGrid::Values;

/// What a type makes: where its values go, and that only one of a volume may.
gl::VertexBatch::Attribute gl::VertexBatch::*slot_of(GLenum type) {
  switch (type) {
    case GL_MAP3_COLOR_4:
      return &gl::VertexBatch::color;
    case GL_MAP3_NORMAL:
      return &gl::VertexBatch::normal;
    case GL_MAP3_VERTEX_3:
    case GL_MAP3_VERTEX_4:
      return &gl::VertexBatch::vertex;
    default:
      return &gl::VertexBatch::tex_coord;
  }
}

/// Progress over all passes of a device, from that of the present pass. A device counts the
/// vertices of a pass when it begins.
class Meter {
 public:
  /// @param all  vertices of all passes
  Meter(Device& device, double all, const Progress& progress)
      : device_(device), all_(all), progress_(progress), counted_(device.counts().vertices) {
    device_.on_progress([this](double done) { show(done); });
  }
  Meter(const Meter&) = delete;
  Meter& operator=(const Meter&) = delete;
  ~Meter() { device_.on_progress(nullptr); }

 private:
  void show(double done) {
    const std::uint64_t counted = device_.counts().vertices;
    if (counted != counted_) {
      finished_ += pass_;
      pass_ = static_cast<double>(counted - counted_);
      counted_ = counted;
    }
    progress_((finished_ + done * pass_) / all_);
  }

  Device& device_;
  double all_;
  const Progress& progress_;
  std::uint64_t counted_;
  double finished_ = 0;  ///< vertices of the passes before the present one
  double pass_ = 0;      ///< vertices of the present one
};

}  // namespace

VolumeAttribute::VolumeAttribute(GLenum type, std::array<Knots, 3> knots, gl::ControlGrid grid,
                                 const std::vector<std::array<float, 4>>& places)
    : type_(type), knots_(std::move(knots)), grid_(std::move(grid)) {
  places_.reserve(places.size());
  for (const std::array<float, 4>& place : places) {
    Embedded& at = places_.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
      if (!std::isfinite(place[axis])) throw GluError{GLU_FFD_INVALID_VALUE};
      at.local[axis] = place[axis];
    }
    at.cell = cell_of(place[3]);
    at.inside = true;
  }
}

Index3 VolumeAttribute::cell_of(float number) const {
  const Index3& points = grid_.points();
  const auto all = static_cast<float>(points[0] * points[1] * points[2]);
  if (!(number >= 0 && number < all) || number != std::floor(number)) {
    throw GluError{GLU_FFD_INVALID_INDEX};
  }
  const int whole = static_cast<int>(number);
  const Index3 cell{whole / (points[1] * points[2]), whole / points[2] % points[1],
                    whole % points[2]};
  for (int axis = 0; axis < 3; ++axis) {
    if (cell[axis] >= knots_[axis].cells() || knots_[axis].is_empty(cell[axis])) {
      throw GluError{GLU_FFD_INVALID_INDEX};
    }
  }
  return cell;
}

gl::VolumeBlending VolumeAttribute::blending_of(const Index3& cell) const {
  return {knots_[0].blending(cell[0]), knots_[1].blending(cell[1]), knots_[2].blending(cell[2])};
}

Values VolumeAttribute::evaluate(Device& device, bool derivatives) const {
  std::array<std::vector<Oracle::Coefficients>, 3> known;
  const auto number_of = [&known](int axis, const gl::AxisBlending& functions) {
    std::vector<Oracle::Coefficients>& seen = known[axis];
    const auto it = std::find_if(seen.begin(), seen.end(), [&](const auto& other) {
      return functions.coefficients().isApprox(other, 1e-12);
    });
    const auto number = static_cast<int>(it - seen.begin());
    if (it == seen.end()) seen.push_back(functions.coefficients());
    return number;
  };
  std::map<Index3, Index3> group_of_cell;
  std::map<Index3, std::vector<std::size_t>> groups;
  for (std::size_t v = 0; v < places_.size(); ++v) {
    const auto [entry, is_new] = group_of_cell.try_emplace(places_[v].cell);
    if (is_new) {
      const gl::VolumeBlending functions = blending_of(places_[v].cell);
      for (int axis = 0; axis < 3; ++axis) entry->second[axis] = number_of(axis, functions[axis]);
    }
    groups[entry->second].push_back(v);
  }
  Values all(static_cast<Eigen::Index>(places_.size()), grid_.columns(derivatives));
  for (const auto& [group, members] : groups) {
    std::vector<Embedded> some;
    for (const std::size_t v : members) some.push_back(places_[v]);
    const Values values = grid_.evaluate(device, some, blending_of(some.front().cell), derivatives);
    for (std::size_t m = 0; m < members.size(); ++m) {
      all.row(static_cast<Eigen::Index>(members[m])) = values.row(static_cast<Eigen::Index>(m));
    }
  }
  return all;
}

void Volume::add(VolumeAttribute attribute) { attributes_.push_back(std::move(attribute)); }

const VolumeAttribute* Volume::positions() const {
  for (const VolumeAttribute& attribute : attributes_) {
    if (slot_of(attribute.type()) == &gl::VertexBatch::vertex) return &attribute;
  }
  return nullptr;
}

void Volume::check() const {
  const VolumeAttribute* vertices = positions();
  if (vertices == nullptr) throw GluError{GLU_FFD_MISSING_DATA};
  std::vector<gl::VertexBatch::Attribute gl::VertexBatch::*> slots;
  if (normals_) slots.push_back(&gl::VertexBatch::normal);
  bool fits = !normals_ || normals_->rows() == static_cast<Eigen::Index>(vertices->vertices());
  for (const VolumeAttribute& attribute : attributes_) {
    const auto slot = slot_of(attribute.type());
    fits &= attribute.vertices() == vertices->vertices() &&
            std::find(slots.begin(), slots.end(), slot) == slots.end();
    slots.push_back(slot);
  }
  // n J^-1 is of positions, not of quotients of them.
  fits &= !normals_ || vertices->type() == GL_MAP3_VERTEX_3;
  if (!fits) throw GluError{GLU_FFD_MISSING_DATA};
  for (const GLuint element : elements()) {
    if (element >= vertices->vertices()) throw GluError{GLU_FFD_INVALID_INDEX};
  }
}

std::vector<GLuint> Volume::elements() const {
  if (elements_) return *elements_;
  std::vector<GLuint> in_order(positions()->vertices());
  std::iota(in_order.begin(), in_order.end(), 0U);
  return in_order;
}

Values Volume::deformed_normals(Device& device) const {
  const Values values = positions()->evaluate(device, true);
  Values deformed(normals_->rows(), 3);
  for (Eigen::Index v = 0; v < deformed.rows(); ++v) {
    Eigen::Matrix3d jacobian;
    for (int axis = 0; axis < 3; ++axis) {
      jacobian.col(axis) = values.row(v).segment<3>(3 * (axis + 1)).transpose();
    }
    const Eigen::RowVector3d normal = normals_->row(v);
    // A collapsed place has no normal; it gets none, rather than an infinite one.
    const double volume = jacobian.determinant();
    deformed.row(v) = std::abs(volume) > std::numeric_limits<double>::min()
                          ? Eigen::RowVector3d(normal * jacobian.inverse())
                          : Eigen::RowVector3d(0, 0, 0);
  }
  return deformed;
}

double Volume::work() const {
  double passes = normals_ ? 1 : 0;
  for (const VolumeAttribute& attribute : attributes_) passes += attribute.grid().passes();
  return passes * static_cast<double>(positions()->vertices());
}

gl::VertexBatch Volume::evaluate(Device& device, const Progress& progress) const {
  const Meter meter(device, work(), progress);
  gl::VertexBatch batch;
  for (const VolumeAttribute& attribute : attributes_) {
    batch.*slot_of(attribute.type()) = gl::VertexBatch::Attribute(attribute.evaluate(device));
  }
  if (normals_) batch.normal = gl::VertexBatch::Attribute(deformed_normals(device));
  return batch;
}

}  // namespace hwffd::glu
