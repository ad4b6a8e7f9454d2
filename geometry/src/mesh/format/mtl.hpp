#pragma once

#include <assimp/material.h>

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace hwffd {

/// A material of a library (mtl).
struct MtlMaterial {
  std::string name;
  std::unique_ptr<aiMaterial> material;
  /// Statements that the material above does not hold, such as "norm" or "-bm of map_Bump".
  std::vector<std::string> extras;
};

/// The material that a mesh without any has.
std::unique_ptr<aiMaterial> default_material();

/// A material of which nothing but its name is known.
std::unique_ptr<aiMaterial> named_material(const std::string& name);

/// The statements by which the first of two materials differs from a plain one and that the other
/// does not have, or otherwise.
std::vector<std::string> mtl_differences(const aiMaterial& material, const aiMaterial& other);

/// The materials of a library, in order. What is no statement of a material is passed over.
std::vector<MtlMaterial> read_mtl(std::string_view text);

}  // namespace hwffd
