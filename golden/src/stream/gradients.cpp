#include "hwffd/stream/gradients.hpp"

#include <stdexcept>

namespace hwffd {
namespace {

/// Makes a header with its page that of gradients; counts are there.
void make_header(Beat& header, const Gradients& how, std::uint32_t flags) {
  if (how.along < 0 || how.along > 3) {
    throw std::invalid_argument("gradients are along 0, or 1 to 3");
  }
  if (how.mode != OutsideMode::kClamp && how.mode != OutsideMode::kBlank) {
    throw std::invalid_argument("a gradient outside is clamped or blank");
  }
  header.words[0] = (header.words[0] & 0xFF00) | static_cast<std::uint32_t>(Opcode::kGradients) |
                    flags | (how.begin ? kBeginFlag : 0);
  header.words[2] =
      static_cast<std::uint32_t>(how.mode) << 24 | static_cast<std::uint32_t>(how.along) << 26;
  for (int axis = 0; axis < 3; ++axis) {
    if (how.dims[axis] < 0 || how.dims[axis] > 255) {
      throw std::invalid_argument("a header has up to 255 points an axis");
    }
    header.words[2] |= static_cast<std::uint32_t>(how.dims[axis]) << (8 * axis);
  }
}

Beat gradient_beat(const std::array<std::uint32_t, 3>& gradient) {
  return {{gradient[0], gradient[1], gradient[2], 0}, false};
}

}  // namespace

std::vector<Beat> gradients_packet(int page, const std::vector<GradientBeats>& vertices,
                                   const Gradients& how) {
  const std::vector<Beat> plain =
      page_vertices_packet(page, {vertices.begin(), vertices.end()}, PageVertices{});
  std::vector<Beat> beats = {plain[0]};
  make_header(beats[0], how, 0);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    beats.push_back(plain[1 + v]);
    beats.back().last = false;
    beats.push_back(gradient_beat(vertices[v].gradient));
  }
  beats.back().last = true;
  return beats;
}

std::vector<Beat> gradients_packet(int page, const Grid& grid,
                                   const std::vector<std::array<std::uint32_t, 3>>& gradients,
                                   const Gradients& how) {
  if (gradients.size() != vertex_count(grid)) {
    throw std::invalid_argument("a grid has a gradient for each vertex");
  }
  std::vector<Beat> beats = grid_packet(grid, page);
  make_header(beats[0], how, kGridGradientsFlag);
  beats[0].words[3] &= 0xFFFF;
  beats.back().last = false;
  for (const auto& gradient : gradients) beats.push_back(gradient_beat(gradient));
  beats.back().last = true;
  return beats;
}

std::vector<Beat> collect_packet(int page, const Collect& how) {
  if (how.shift < 0 || how.shift > 3) throw std::invalid_argument("a shift is 0 to 3");
  PageVertices flags;
  flags.count = how.count;
  flags.interrupt = how.interrupt;
  Beat header = page_vertices_packet(page, {}, flags)[0];
  header.words = {(header.words[0] & ~0xFFU) | static_cast<std::uint32_t>(Opcode::kCollect), 0,
                  static_cast<std::uint32_t>(how.shift), how.tag};
  return {header};
}

}  // namespace hwffd
