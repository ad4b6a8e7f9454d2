#include <assimp/material.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "hwffd/excerpt.hpp"
#include "mesh/assimp_export.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

constexpr unsigned kMostCountedCorners = 255;  // of a face whose corners are counted in a byte

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

unsigned char byte_of(float part) {
  return static_cast<unsigned char>(std::lround(255.0f * std::clamp(part, 0.0f, 1.0f)));
}

/// What the vertices of any part have; it is written for all.
struct Layout {
  bool is_single = true;
  bool normals = false;
  bool textures = false;
  bool colours = false;
  unsigned most_corners = 0;  ///< of a face; 0: there are none
  std::size_t faces = 0;
  std::size_t corners = 0;  ///< of all faces

  std::size_t row_size() const {
    return (is_single ? 12u : 24u) + (normals ? 12u : 0u) + (textures ? 8u : 0u) +
           (colours ? 4u : 0u);
  }
};

Layout layout_of(const Output& output) {
  const aiScene& scene = output.scene;
  Layout layout;
  layout.is_single = output.is_single;
  each_part(scene, [&](const aiMesh& part, std::size_t) {
    layout.normals = layout.normals || part.HasNormals();
    layout.textures = layout.textures || part.HasTextureCoords(0);
    layout.colours = layout.colours || part.HasVertexColors(0);
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const unsigned corners = part.mFaces[f].mNumIndices;
      if (corners > 1) {  // a point is a vertex, which is there
        ++layout.faces;
        layout.corners += corners;
      }
      layout.most_corners = std::max(layout.most_corners, corners);
    }
  });
  return layout;
}

std::string header_of(const Output& output, const Layout& layout, std::size_t vertices) {
  std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by hwffd\n";
  const std::unique_ptr<aiScene> materials = materials_of(output, false);
  for (unsigned m = 0; m < materials->mNumMaterials; ++m) {
    aiString texture;
    materials->mMaterials[m]->GetTexture(aiTextureType_DIFFUSE, 0, &texture);
    if (texture.length == 0 || texture.data[0] == '*') continue;
    text += fmt::format("comment TextureFile {}\n", one_line(texture.C_Str()));
    break;
  }
  text += fmt::format("element vertex {}\n", vertices);
  const auto properties = [&](const char* type, std::initializer_list<const char*> names) {
    for (const char* name : names) text += fmt::format("property {} {}\n", type, name);
  };
  properties(layout.is_single ? "float" : "double", {"x", "y", "z"});
  if (layout.normals) properties("float", {"nx", "ny", "nz"});
  if (layout.textures) properties("float", {"s", "t"});
  if (layout.colours) properties("uchar", {"red", "green", "blue", "alpha"});
  if (layout.faces > 0) {
    const char* const count = layout.most_corners > kMostCountedCorners ? "uint" : "uchar";
    text +=
        fmt::format("element face {}\nproperty list {} uint vertex_indices\n", layout.faces, count);
  }
  return text + "end_header\n";
}

/// Puts what the layout has of a vertex where `row` begins.
/// @param position  of the vertex
void put_row(const aiMesh& part, unsigned v, const Point& position, const Layout& layout,
             char* row) {
  const auto vector = [&](const aiVector3D& value, std::size_t components) {
    const std::array<float, 3> numbers{value.x, value.y, value.z};
    row =
        std::copy_n(reinterpret_cast<const char*>(numbers.data()), components * sizeof(float), row);
  };
  if (layout.is_single) {
    vector(part.mVertices[v], 3);
  } else {
    row = std::copy_n(reinterpret_cast<const char*>(position.data()), 3 * sizeof(double), row);
  }
  if (layout.normals) vector(part.HasNormals() ? part.mNormals[v] : aiVector3D(), 3);
  if (layout.textures) {
    vector(part.HasTextureCoords(0) ? part.mTextureCoords[0][v] : aiVector3D(), 2);
  }
  if (layout.colours) {
    const aiColor4D c = part.HasVertexColors(0) ? part.mColors[0][v] : aiColor4D(1, 1, 1, 1);
    for (const float value : {c.r, c.g, c.b, c.a}) *row++ = static_cast<char>(byte_of(value));
  }
}

}  // namespace

Files write_ply(const Output& output) {
  const Layout layout = layout_of(output);
  const std::vector<std::uint32_t> rows = rows_of(output);
  const std::size_t size = layout.row_size();
  std::string bytes = header_of(output, layout, output.numbers.size());
  const std::size_t start = bytes.size();
  const std::size_t faces = start + output.numbers.size() * size;
  bytes.reserve(faces + (layout.faces + layout.corners) * sizeof(std::uint32_t));
  bytes.resize(faces);
  each_part(output.scene, [&](const aiMesh& part, std::size_t first) {
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      put_row(part, v, output.positions.row(output.welded[first + v]), layout,
              &bytes[start + rows[first + v] * size]);
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices < 2) continue;
      if (layout.most_corners > kMostCountedCorners) {
        append(bytes, std::uint32_t{face.mNumIndices});
      } else {
        append(bytes, static_cast<std::uint8_t>(face.mNumIndices));
      }
      for (unsigned c = 0; c < face.mNumIndices; ++c) append(bytes, rows[first + face.mIndices[c]]);
    }
  });
  Files files;
  files.emplace(output.path.filename().string(), std::move(bytes));
  return files;
}

}  // namespace hwffd
