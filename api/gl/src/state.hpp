#pragma once

#include <bitset>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "control_grid.hpp"
#include "opengl.hpp"

namespace hwffd::gl {

/// A map of glMap3.
struct Map3 {
  ControlGrid grid;
  std::array<double, 6> domain{0, 1, 0, 1, 0, 1};  ///< u1, u2, v1, v2, w1, w2

  /// Where (u, v, w) lies in the domain, 0 to 1 an axis.
  Eigen::Vector3d normalized(const Eigen::Vector3d& uvw) const;
};

/// The grid of glMapGrid3.
struct MapGrid3 {
  Index3 segments{1, 1, 1};
  std::array<double, 6> domain{0, 1, 0, 1, 0, 1};

  Eigen::Vector3d point(const Index3& number) const;
};

constexpr int kMaps = 9;
/// Of a map, along an axis: the points that a core has room for.
constexpr int kMaxOrder = kAxisPoints;

/// Components of the maps' control points, in the order of the targets from GL_MAP3_COLOR_4 on.
constexpr std::array<int, kMaps> kComponents{4, 1, 3, 1, 2, 3, 4, 3, 4};

/// Number of a map; nothing if the target is none of glMap3's.
std::optional<int> map_number(GLenum target);

/// What the GL commands keep, one for each thread, as a thread has one current context.
class State {
 public:
  static State& current();

  std::vector<Map3> maps;  ///< kMaps
  std::bitset<kMaps> enabled;
  bool auto_normal = false;
  MapGrid3 grid;
  std::array<std::optional<AxisBlending>, 3> blending;  ///< nothing: Bernstein polynomials

  /// The blending functions that a map is evaluated with.
  /// @throws Error where they do not fit the numbers of its points
  VolumeBlending blending_of(const ControlGrid& grid) const;

  /// Made when first used, by the name given or by the environment.
  /// @throws UsageError if there is no such device
  Device& device();
  /// @param name  nothing: by the environment
  /// @throws UsageError if there is no such device
  void choose_device(const std::optional<std::string>& name);

 private:
  State();
  std::unique_ptr<Device> device_;
};

}  // namespace hwffd::gl
