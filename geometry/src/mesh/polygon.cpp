#include "mesh/polygon.hpp"

#include <Eigen/Geometry>

#include "mesh/scene.hpp"

namespace hwffd {
namespace {

using Corners = std::vector<unsigned>;

// Time grows with the third power of the corners; a larger polygon is cut as if it were convex.
constexpr unsigned kMostCorners = 1000;

/// A polygon seen along its normal, so that it turns counterclockwise.
class Outline {
 public:
  Outline(const aiMesh& part, const aiFace& face) : part_(part) {
    const Eigen::Vector3d origin = at(face.mIndices[0]);
    for (unsigned c = 0; c < face.mNumIndices; ++c) {
      const unsigned next = face.mIndices[(c + 1) % face.mNumIndices];
      normal_ += (at(face.mIndices[c]) - origin).cross(at(next) - origin);
    }
  }

  /// Twice the area of a triangle; negative if it turns the other way than the polygon.
  double area(unsigned a, unsigned b, unsigned c) const {
    return normal_.dot((at(b) - at(a)).cross(at(c) - at(a)));
  }

  /// Whether corner i can be cut off: it is convex, and no other corner lies in its triangle.
  bool is_ear(const Corners& corners, std::size_t i) const {
    const unsigned a = corners[(i + corners.size() - 1) % corners.size()];
    const unsigned b = corners[i];
    const unsigned c = corners[(i + 1) % corners.size()];
    if (area(a, b, c) <= 0) return false;
    for (const unsigned p : corners) {
      if (p == a || p == b || p == c) continue;
      if (area(a, b, p) >= 0 && area(b, c, p) >= 0 && area(c, a, p) >= 0) return false;
    }
    return true;
  }

  bool is_convex(const Corners& corners) const {
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const unsigned next = corners[(i + 1) % corners.size()];
      if (area(corners[i], next, corners[(i + 2) % corners.size()]) < 0) return false;
    }
    return true;
  }

 private:
  Eigen::Vector3d at(unsigned vertex) const { return to_eigen(part_.mVertices[vertex]); }

  const aiMesh& part_;
  Eigen::Vector3d normal_ = Eigen::Vector3d::Zero();
};

}  // namespace

std::vector<std::array<unsigned, 3>> triangles_of(const aiMesh& part, const aiFace& face) {
  Corners corners(face.mIndices, face.mIndices + face.mNumIndices);
  std::vector<std::array<unsigned, 3>> triangles;
  const Outline outline(part, face);
  const bool is_fan =
      corners.size() <= 3 || corners.size() > kMostCorners || outline.is_convex(corners);
  while (corners.size() > 3 && !is_fan) {
    std::size_t i = 0;
    while (i < corners.size() && !outline.is_ear(corners, i)) ++i;
    if (i == corners.size()) break;  // it crosses itself: a fan is as good as anything
    const std::size_t n = corners.size();
    triangles.push_back({corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]});
    corners.erase(corners.begin() + static_cast<std::ptrdiff_t>(i));
  }
  for (std::size_t c = 2; c < corners.size(); ++c) {
    triangles.push_back({corners[0], corners[c - 1], corners[c]});
  }
  return triangles;
}

}  // namespace hwffd
