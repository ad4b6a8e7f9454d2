#pragma once

#include <memory>

#include "mesh/mesh_writers.hpp"

namespace hwffd {

/// What Assimp's exporter of this name makes of a scene, in memory: it does not check its writes,
/// write_files() does.
/// @throws Error without the name of the file
Files assimp_export(const aiScene& scene, const std::string& exporter, const std::string& name);

/// The materials and textures of the output, with one triangle for the sake of exporters that need
/// one. Textures are named as seen from the output's folder.
/// @param is_utf8  whether names are made UTF-8
std::unique_ptr<aiScene> materials_of(const Output& output, bool is_utf8);

/// The whole scene, likewise.
std::unique_ptr<aiScene> copy_of(const Output& output, bool is_utf8);

}  // namespace hwffd
