#include <assimp/material.h>
#include <fmt/format.h>

#include <cstring>
#include <map>
#include <unordered_map>

#include "hwffd/excerpt.hpp"
#include "mesh/assimp_export.hpp"
#include "mesh/format/text.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

/// The lines of one kind of value (vt, vn), each value once, numbered from 1.
class Values {
 public:
  explicit Values(const char* keyword) : keyword_(keyword) {}

  std::size_t number_of(const aiVector3D& value, unsigned components, std::string& lines) {
    std::string key(reinterpret_cast<const char*>(&value), sizeof(value));
    const auto [entry, is_new] = numbers_.emplace(std::move(key), numbers_.size() + 1);
    if (is_new) {
      lines += fmt::format("{} {} {}", keyword_, value.x, value.y);
      lines += components > 2 ? fmt::format(" {}\n", value.z) : "\n";
    }
    return entry->second;
  }

 private:
  const char* keyword_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

class ObjText {
 public:
  ObjText(const Output& output, std::vector<std::string> materials)
      : output_(output), materials_(std::move(materials)) {
    each_part(output.scene, [&](const aiMesh&, std::size_t first) { firsts_.push_back(first); });
  }

  std::string write(const std::string& library) {
    text_ = fmt::format("mtllib {}\n", library);
    write_vertices();
    write_node(*output_.scene.mRootNode);
    return std::move(text_);
  }

 private:
  void write_vertices() {
    const Points positions = numbered_positions(output_);
    const auto count = static_cast<std::size_t>(positions.rows());
    std::vector<const aiColor4D*> colours(count, nullptr);
    each_part(output_.scene, [&](const aiMesh& part, std::size_t first) {
      for (unsigned v = 0; v < part.mNumVertices && part.HasVertexColors(0); ++v) {
        colours[output_.numbers[first + v]] = &part.mColors[0][v];
      }
    });
    for (std::size_t n = 0; n < count; ++n) {
      text_ += 'v';
      for (int axis = 0; axis < 3; ++axis) {
        text_ += ' ';
        append_number(text_, positions(static_cast<Eigen::Index>(n), axis), output_.is_single);
      }
      if (const aiColor4D* c = colours[n]) text_ += fmt::format(" {} {} {}", c->r, c->g, c->b);
      text_ += '\n';
    }
  }

  void write_node(const aiNode& node) {
    const bool is_root = &node == output_.scene.mRootNode;
    std::string group;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      const aiMesh& part = *output_.scene.mMeshes[node.mMeshes[i]];
      const aiString& name = is_root || node.mName.length == 0 ? part.mName : node.mName;
      if (name.length > 0 && name.C_Str() != group) {
        group = name.C_Str();
        text_ += fmt::format("g {}\n", one_line(group));
      }
      if (part.mNumFaces > 0) write_part(part, firsts_[node.mMeshes[i]]);
    }
    for (unsigned c = 0; c < node.mNumChildren; ++c) write_node(*node.mChildren[c]);
  }

  void write_part(const aiMesh& part, std::size_t first) {
    if (part.mMaterialIndex < materials_.size()) {
      text_ += fmt::format("usemtl {}\n", materials_[part.mMaterialIndex]);
    }
    std::vector<std::string> corners(part.mNumVertices);  // "v/vt/vn" of vertices met so far
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        std::string& corner = corners[face.mIndices[c]];
        if (corner.empty()) corner = corner_of(part, first, face.mIndices[c]);
      }
      const bool is_face = face.mNumIndices > 2;
      text_ += is_face ? 'f' : face.mNumIndices == 2 ? 'l' : 'p';
      for (unsigned c = 0; c < face.mNumIndices; ++c) {
        const std::string& corner = corners[face.mIndices[c]];
        text_ += ' ';
        text_ += is_face ? corner : corner.substr(0, corner.find('/'));
      }
      text_ += '\n';
    }
  }

  std::string corner_of(const aiMesh& part, std::size_t first, unsigned v) {
    std::string corner = std::to_string(output_.numbers[first + v] + 1);
    if (part.HasTextureCoords(0)) {
      const unsigned components = part.mNumUVComponents[0];
      const aiVector3D& value = part.mTextureCoords[0][v];
      corner += fmt::format("/{}", textures_.number_of(value, components, text_));
    }
    if (part.HasNormals()) {
      corner += part.HasTextureCoords(0) ? "/" : "//";
      corner += std::to_string(normals_.number_of(part.mNormals[v], 3, text_));
    }
    return corner;
  }

  const Output& output_;
  std::vector<std::string> materials_;  ///< as the library calls them
  std::vector<std::size_t> firsts_;     ///< first vertex of each part
  std::string text_;
  Values textures_{"vt"};
  Values normals_{"vn"};
};

/// The names of the materials in a library, in order.
std::vector<std::string> names_in(const std::string& library) {
  constexpr const char* kKeyword = "newmtl ";
  std::vector<std::string> names;
  for (std::size_t at = 0; at < library.size();) {
    const std::size_t end = std::min(library.find('\n', at), library.size());
    if (library.compare(at, std::strlen(kKeyword), kKeyword) == 0) {
      names.push_back(library.substr(at + std::strlen(kKeyword), end - at - std::strlen(kKeyword)));
    }
    at = end + 1;
  }
  return names;
}

/// A library knows a material by its name alone: where others have that name, too, a number
/// follows.
void part_names(aiScene& materials) {
  std::map<std::string, unsigned> numbers;  // of names in use: of the last that was tried behind it
  for (unsigned m = 0; m < materials.mNumMaterials; ++m) {
    aiString name;
    materials.mMaterials[m]->Get(AI_MATKEY_NAME, name);
    const std::string given = name.C_Str();
    std::string own = given;
    while (!numbers.emplace(own, 0).second) own = fmt::format("{}_{}", given, ++numbers[given]);
    name = aiString(own);
    materials.mMaterials[m]->AddProperty(&name, AI_MATKEY_NAME);
  }
}

}  // namespace

/// Materials are Assimp's: its library beside our vertices and faces.
Files write_obj(const Output& output) {
  const std::string name = output.path.filename().string();
  const std::string library = output.path.stem().string() + ".mtl";
  const std::unique_ptr<aiScene> materials = materials_of(output, false);
  part_names(*materials);
  Files files = assimp_export(*materials, "obj", name);
  files[name] = ObjText(output, names_in(files[library])).write(library);
  return files;
}

}  // namespace hwffd
