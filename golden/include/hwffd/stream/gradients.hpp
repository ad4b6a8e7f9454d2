#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packets.hpp"

/// What a core `hwffd_scatter` takes and gives: gradients are added up at the control points, and
/// collected. docs/interface.md section 2, opcodes 10 and 11.
namespace hwffd {

// Flags of gradients, in word 0 of their header.
constexpr std::uint32_t kGridGradientsFlag = 1U << 22;  ///< the vertices are those of a grid
constexpr std::uint32_t kBeginFlag = 1U << 23;          ///< the sums of the page are zero before

/// In the status of a point that is collected: more vertices added than sums can surely hold.
constexpr std::uint32_t kStatusOverflowed = 1U << 23;

/// A vertex and its gradient as stream words; the tag is not looked at.
struct GradientBeats : VertexBeat {
  std::array<std::uint32_t, 3> gradient{};  ///< x, y, z
};

/// What gradients are added to, and how.
struct Gradients {
  std::array<int, 3> dims{};  ///< points an axis of the lattice
  /// 0: with respect to positions; 1, 2, 3: to derivatives along s, t, u.
  int along = 0;
  OutsideMode mode = OutsideMode::kClamp;  ///< or kBlank: a vertex outside adds nothing
  bool begin = false;                      ///< the sums of the page are zero before
};

/// The packet of gradients of vertices, 1 + 2 n beats.
/// @throws std::invalid_argument for points an axis, an `along` or a mode that no header can name,
///   or a page beyond 255
std::vector<Beat> gradients_packet(int page, const std::vector<GradientBeats>& vertices,
                                   const Gradients& how);

/// The packet of gradients of the vertices of a grid, s fastest, then t, then u: 4 + n beats. The
/// grid's tag does not go with it.
/// @throws std::invalid_argument as above, and unless there is a gradient for each vertex
std::vector<Beat> gradients_packet(int page, const Grid& grid,
                                   const std::vector<std::array<std::uint32_t, 3>>& gradients,
                                   const Gradients& how);

/// How the sums of a page are collected.
struct Collect {
  int shift = 0;           ///< 0 to 3: words are sums times 2^-shift
  std::uint16_t tag = 0;   ///< of the first point; the others count on
  bool count = false;      ///< a unit behind the points says how many they are
  bool interrupt = false;  ///< one comes when the last point is in memory
};

/// The packet that reads the sums of a page out and leaves zeros: a header alone.
/// @throws std::invalid_argument for another shift, or a page beyond 255
std::vector<Beat> collect_packet(int page, const Collect& how = {});

}  // namespace hwffd
