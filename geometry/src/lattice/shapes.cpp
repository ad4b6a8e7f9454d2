#include <algorithm>

#include "hwffd/lattice/shape.hpp"

namespace hwffd {

#define HWFFD_SHAPE(name) Shape name##_shape();
#include "shapes.inc"
#undef HWFFD_SHAPE

const std::vector<Shape>& shapes() {
  static const std::vector<Shape> all = {
#define HWFFD_SHAPE(name) name##_shape(),
#include "shapes.inc"
#undef HWFFD_SHAPE
  };
  return all;
}

const Shape* find_shape(const std::string& name) {
  const auto it = std::find_if(shapes().begin(), shapes().end(),
                               [&](const Shape& shape) { return name == shape.name; });
  return it == shapes().end() ? nullptr : &*it;
}

const std::vector<std::string>& shape_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const Shape& shape : shapes()) list.emplace_back(shape.name);
    return list;
  }();
  return names;
}

std::string shape_list(const char* before_last) {
  const std::vector<std::string>& names = shape_names();
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    list += (i == 0 ? "" : i + 1 == names.size() ? before_last : ", ") + names[i];
  }
  return list;
}

}  // namespace hwffd
