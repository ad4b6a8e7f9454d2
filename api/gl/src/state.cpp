#include "state.hpp"

#include <fmt/format.h>

#include "device_name.hpp"
#include "hwffd/error.hpp"
#include "hwffd/glffd.h"

namespace hwffd::gl {

Eigen::Vector3d Map3::normalized(const Eigen::Vector3d& uvw) const {
  Eigen::Vector3d part;
  for (int axis = 0; axis < 3; ++axis) {
    const double first = domain[2 * axis];
    part[axis] = (uvw[axis] - first) / (domain[2 * axis + 1] - first);
  }
  return part;
}

Eigen::Vector3d MapGrid3::point(const Index3& number) const {
  Eigen::Vector3d at;
  for (int axis = 0; axis < 3; ++axis) {
    const double first = domain[2 * axis];
    const double last = domain[2 * axis + 1];
    // The last point is hit exactly, as OpenGL promises.
    at[axis] = number[axis] == segments[axis]
                   ? last
                   : first + number[axis] * ((last - first) / segments[axis]);
  }
  return at;
}

std::optional<int> map_number(GLenum target) {
  if (target < GL_MAP3_COLOR_4 || target > GL_MAP3_VERTEX_4) return std::nullopt;
  return static_cast<int>(target - GL_MAP3_COLOR_4);
}

State& State::current() {
  thread_local State state;
  return state;
}

State::State() {
  // One point, the initial value of what the map makes.
  const std::array<std::vector<double>, kMaps> initial{{{1, 1, 1, 1},
                                                        {1},
                                                        {0, 0, 1},
                                                        {0},
                                                        {0, 0},
                                                        {0, 0, 0},
                                                        {0, 0, 0, 1},
                                                        {0, 0, 0},
                                                        {0, 0, 0, 1}}};
  for (int map = 0; map < kMaps; ++map) {
    maps.push_back({ControlGrid({1, 1, 1}, kComponents[map]), {0, 1, 0, 1, 0, 1}});
    maps.back().grid.values() = initial[map];
  }
}

VolumeBlending State::blending_of(const ControlGrid& grid) const {
  VolumeBlending functions{AxisBlending::bernstein(0), AxisBlending::bernstein(0),
                           AxisBlending::bernstein(0)};
  for (int axis = 0; axis < 3; ++axis) {
    const int points = grid.points()[axis];
    if (!blending[axis] && points > AxisBlending::kMaxDegree + 1) {
      throw Error(fmt::format("Bernstein polynomials of {} points; devices have degree 3", points));
    }
    functions[axis] = blending[axis] ? *blending[axis] : AxisBlending::bernstein(points - 1);
    if (!functions[axis].fits(points)) {
      throw Error(fmt::format("{} points under blending functions of degree {}; give 1 to {} cells",
                              points, functions[axis].degree(), AxisBlending::kMaxCells));
    }
  }
  return functions;
}

Device& State::device() {
  if (device_ == nullptr) choose_device(std::nullopt);
  return *device_;
}

void State::choose_device(const std::optional<std::string>& name) {
  device_ = make_device(name ? parse_device(*name) : device_of_environment());
}

}  // namespace hwffd::gl
