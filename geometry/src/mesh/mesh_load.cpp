#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <system_error>

#include "child.hpp"
#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "mesh/formats.hpp"
#include "mesh/read_scene.hpp"
#include "read_file.hpp"

namespace hwffd {
namespace {

namespace fs = std::filesystem;

/// Far more than a good file takes: Assimp needs up to 40 bytes a byte, and reads some MB a second.
ChildLimits limits_for(std::size_t bytes) {
  return {(std::uint64_t{1} << 30) + std::uint64_t{200} * bytes,
          10 + static_cast<unsigned>(bytes >> 17)};
}

/// Whether the property has the bytes that its type needs; Assimp does not look, or ends the
/// program.
bool is_whole(const aiMaterialProperty& property) {
  switch (property.mType) {
    case aiPTI_Buffer:
      return true;
    case aiPTI_Float:
    case aiPTI_Integer:
      return property.mDataLength >= sizeof(float);
    case aiPTI_Double:
      return property.mDataLength >= sizeof(double);
    case aiPTI_String:
      break;
    default:
      return false;
  }
  ai_uint32 length = 0;  // before the characters and a zero
  if (property.mDataLength < sizeof(length) + 1) return false;
  std::memcpy(&length, property.mData, sizeof(length));
  return property.mDataLength == sizeof(length) + std::uint64_t{length} + 1 && length < MAXLEN &&
         property.mData[property.mDataLength - 1] == '\0';
}

/// Consistent as far as whoever walks over the scene relies on it.
void check_references(const ReadScene& read) {
  const aiScene& scene = *read.scene;
  std::size_t vertices = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    vertices += scene.mMeshes[m]->mNumVertices;
    if (scene.mMeshes[m]->mMaterialIndex < std::max(1u, scene.mNumMaterials)) continue;
    throw not_a_mesh(fmt::format("part {} refers to material {} of {}", m,
                                 scene.mMeshes[m]->mMaterialIndex, scene.mNumMaterials));
  }
  for (unsigned m = 0; m < scene.mNumMaterials; ++m) {
    const aiMaterial& material = *scene.mMaterials[m];
    for (unsigned p = 0; p < material.mNumProperties; ++p) {
      if (!is_whole(*material.mProperties[p])) {
        throw not_a_mesh(fmt::format("material {} is broken", m));
      }
    }
  }
  if (!read.numbers.empty() && read.numbers.size() != vertices) throw not_a_mesh("lost vertices");
}

ReadScene read_apart(const fs::path& path, const std::string& bytes) {
  try {
    ReadScene read = unpack(
        run_in_child([&] { return pack(read_scene(path, bytes)); }, limits_for(bytes.size())));
    check_scene(*read.scene);
    check_references(read);
    return read;
  } catch (const ChildFailure& failure) {
    throw Error(fmt::format("{}: {}", path.string(), not_a_mesh(failure.what()).what()));
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
}

}  // namespace

Mesh Mesh::load(const fs::path& path) {
  const std::string file = path.string();
  std::error_code ignored;
  const auto refuse = [&](const char* what) {
    throw Error(fmt::format("{}: {}; give the path of a mesh: {}", file, what, kAcceptedMeshes));
  };
  if (!fs::exists(path, ignored)) refuse("no such file");
  if (!fs::is_regular_file(path, ignored)) refuse("not a file");
  std::string bytes = read_file(path);
  const MeshFormat* format = format_of(path);
  if (format == nullptr || format->read == nullptr) return Mesh(read_apart(path, bytes), path);
  try {
    return Mesh(read_document(format->read, path, std::move(bytes)), path);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", file, error.what()));
  }
}

}  // namespace hwffd
