#include "hwffd/lattice/around.hpp"

#include <array>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/box.hpp"
#include "hwffd/lattice/cylinder.hpp"
#include "hwffd/lattice/sphere.hpp"

namespace hwffd {
namespace {

template <class Shape>
Lattice around(const Points& points, const Index3& dims, double part) {
  const Point room =
      points.rows() == 0 ? Point::Zero() : Point(part * points.cwiseAbs().colwise().maxCoeff());
  return Shape::around(points, room).lattice(dims);
}

struct Entry {
  const char* name;
  Index3 dims;
  Lattice (*around)(const Points&, const Index3&, double);
};
const std::array<Entry, 3> kShapes{{{"box", {4, 4, 4}, around<Box>},
                                    {"cylinder", {4, 4, 9}, around<Cylinder>},
                                    {"sphere", {4, 6, 9}, around<Sphere>}}};

const Entry& find(const std::string& shape) {
  for (const Entry& entry : kShapes) {
    if (entry.name == shape) return entry;
  }
  throw UsageError("shape '" + excerpt(shape) + "' is unknown; one of box, cylinder, sphere");
}

}  // namespace

const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Entry& entry : kShapes) list.emplace_back(entry.name);
    return list;
  }();
  return names;
}

Index3 usual_dims(const std::string& shape) { return find(shape).dims; }

Lattice lattice_around(const std::string& shape, const Points& points, const Index3& dims,
                       double room) {
  return find(shape).around(points, dims, room);
}

}  // namespace hwffd
