#pragma once

#include <assimp/scene.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "hwffd/points.hpp"
#include "mesh/space.hpp"

namespace hwffd {

/// A mesh on its way into files.
struct Output {
  const aiScene& scene;
  const Points& positions;                    ///< of welded vertices
  const std::vector<std::uint32_t>& welded;   ///< scene vertex -> welded vertex
  bool is_single;                             ///< whether positions are binary32
  const std::vector<std::uint32_t>& numbers;  ///< scene vertex -> vertex of the file
  std::filesystem::path path;
  std::filesystem::path texture_folder;  ///< that names of textures start from; empty: none
  Space space;                           ///< of coordinates
};

/// Name -> bytes; the file that refers to the others has the output's name.
using Files = std::map<std::string, std::string>;

/// @throws Error without the name of the file
Files write_obj(const Output& output);
Files write_ply(const Output& output);
Files write_off(const Output& output);
Files write_gltf(const Output& output);  ///< extension .glb: one binary file
Files write_stl(const Output& output);
Files write_dae(const Output& output);

/// Positions in the order of the file's vertices.
Points numbered_positions(const Output& output);

/// Whether the scene has several vertices for one of the file, with other normals or texture
/// coordinates.
bool repeats_vertices(const Output& output);

/// For a format without such repetition: scene vertex -> vertex of the file. These are the numbers
/// if none is repeated, else every vertex of the scene becomes one of the file.
std::vector<std::uint32_t> rows_of(const Output& output);

}  // namespace hwffd
