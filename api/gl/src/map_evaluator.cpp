#include "map_evaluator.hpp"

#include "hwffd/glffd.h"

namespace hwffd::gl {
namespace {

/// The enabled map of the highest target between two; nothing if none is.
const Map3* enabled_map(const State& state, GLenum first, GLenum last) {
  for (GLenum target = last; target >= first; --target) {
    const int number = *map_number(target);
    if (state.enabled.test(number)) return &state.maps[number];
  }
  return nullptr;
}

const Map3* vertex_map(const State& state) {
  return enabled_map(state, GL_MAP3_VERTEX_3, GL_MAP3_VERTEX_4);
}

std::vector<Embedded> place(const Map3& map, const std::vector<Eigen::Vector3d>& uvw,
                            const VolumeBlending& blending) {
  std::vector<Embedded> places;
  places.reserve(uvw.size());
  for (const Eigen::Vector3d& point : uvw) {
    places.push_back(map.grid.place(map.normalized(point), blending));
  }
  return places;
}

VertexBatch::Attribute evaluate(State& state, const Map3* map,
                                const std::vector<Eigen::Vector3d>& uvw) {
  if (map == nullptr) return {};
  const VolumeBlending blending = state.blending_of(map->grid);
  return VertexBatch::Attribute(
      map->grid.evaluate(state.device(), place(*map, uvw, blending), blending));
}

VertexBatch::Attribute auto_normals(State& state, const Map3& map,
                                    const std::vector<Eigen::Vector3d>& uvw) {
  const VolumeBlending blending = state.blending_of(map.grid);
  return VertexBatch::Attribute(
      map.grid.sheet_normals(state.device(), place(map, uvw, blending), blending));
}

}  // namespace

bool makes_vertices(const State& state) { return vertex_map(state) != nullptr; }

VertexBatch evaluate_maps(State& state, const std::vector<Eigen::Vector3d>& uvw) {
  const auto of = [&](GLenum first, GLenum last) {
    return evaluate(state, enabled_map(state, first, last), uvw);
  };
  VertexBatch batch;
  batch.color = of(GL_MAP3_COLOR_4, GL_MAP3_COLOR_4);
  batch.index = of(GL_MAP3_INDEX, GL_MAP3_INDEX);
  batch.tex_coord = of(GL_MAP3_TEXTURE_COORD_1, GL_MAP3_TEXTURE_COORD_4);
  const Map3* vertices = vertex_map(state);
  batch.normal = state.auto_normal && vertices != nullptr ? auto_normals(state, *vertices, uvw)
                                                          : of(GL_MAP3_NORMAL, GL_MAP3_NORMAL);
  batch.vertex = evaluate(state, vertices, uvw);
  return batch;
}

}  // namespace hwffd::gl
