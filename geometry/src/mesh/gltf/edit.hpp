#pragma once

#include <filesystem>

#include "mesh/format/document.hpp"
#include "mesh/gltf/scene.hpp"

namespace hwffd::gltf {

/// Rows of a Content as they were read.
struct Rest {
  Points positions;
  Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor> normals;
  Eigen::Matrix<float, Eigen::Dynamic, 4, Eigen::RowMajor> tangents;
};

/// The file with a mesh that has moved. In its buffers only numbers of POSITION, NORMAL and TANGENT
/// that have changed are different, through the inverse of their node's transform, and, where faces
/// are turned round, indices; in its JSON min and max of those accessors.
///
/// Numbers that must not change are left where they are, and what has moved gets accessors of its
/// own behind the bytes of a buffer: of an accessor that has several uses which move apart (a mesh
/// that several nodes show, another scene, a texture coordinate), one whose bytes belong to other
/// accessors too, and a sparse one. A mesh of which nodes need different accessors is repeated.
/// @throws Error, without the file's name, for a value that the accessor's type does not hold
Files edited_files(const File& file, const Scene& scene, const Rest& rest, const Edit& edit,
                   const std::filesystem::path& path);

}  // namespace hwffd::gltf
