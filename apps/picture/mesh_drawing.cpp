#include "picture/mesh_drawing.hpp"

#include <assimp/scene.h>

#include <optional>
#include <vector>

#include "picture/opengl.hpp"

namespace hwffd::picture {
namespace {

/// Corners of a part's triangles; polygons are fans from their first corner.
std::vector<GLuint> corners_of(const aiMesh& part) {
  std::vector<GLuint> corners;
  for (unsigned f = 0; f < part.mNumFaces; ++f) {
    const aiFace& face = part.mFaces[f];
    for (unsigned c = 2; c < face.mNumIndices; ++c) {
      corners.insert(corners.end(), {face.mIndices[0], face.mIndices[c - 1], face.mIndices[c]});
    }
  }
  return corners;
}

void set_colour(const aiScene& scene, const aiMesh& part) {
  aiColor3D colour(0.72f, 0.70f, 0.66f);
  if (part.mMaterialIndex < scene.mNumMaterials) {
    scene.mMaterials[part.mMaterialIndex]->Get(AI_MATKEY_COLOR_DIFFUSE, colour);
  }
  glColor3f(colour.r, colour.g, colour.b);
}

/// Normals of the vertices first, first + 1 and so on of a mesh's scene.
std::vector<GLfloat> normals_of(const Mesh& mesh, const Points& normals, std::size_t first,
                                unsigned count) {
  std::vector<GLfloat> values;
  for (unsigned v = 0; v < count; ++v) {
    for (int c = 0; c < 3; ++c) {
      values.push_back(static_cast<GLfloat>(normals(mesh.welded()[first + v], c)));
    }
  }
  return values;
}

}  // namespace

void draw_mesh(const Mesh& mesh) {
  static_assert(sizeof(aiVector3D) == 3 * sizeof(GLfloat), "Assimp with its reals in binary32");
  const aiScene& scene = mesh.scene();
  glEnableClientState(GL_VERTEX_ARRAY);
  glEnableClientState(GL_NORMAL_ARRAY);
  std::optional<Points> normals;  // of all vertices, once a part wants some
  std::size_t first = 0;
  for (unsigned m = 0; m < scene.mNumMeshes; ++m) {
    const aiMesh& part = *scene.mMeshes[m];
    std::vector<GLfloat> smooth;
    if (!part.HasNormals()) {
      if (!normals) normals = mesh.smooth_normals();
      smooth = normals_of(mesh, *normals, first, part.mNumVertices);
    }
    const std::vector<GLuint> corners = corners_of(part);
    set_colour(scene, part);
    glVertexPointer(3, GL_FLOAT, 0, part.mVertices);
    glNormalPointer(GL_FLOAT, 0, part.HasNormals() ? &part.mNormals[0].x : smooth.data());
    glDrawElements(GL_TRIANGLES, static_cast<GLsizei>(corners.size()), GL_UNSIGNED_INT,
                   corners.data());
    first += part.mNumVertices;
  }
  glDisableClientState(GL_NORMAL_ARRAY);
  glDisableClientState(GL_VERTEX_ARRAY);
}

}  // namespace hwffd::picture
