// Formats whose geometry Assimp's exporters write as it is.

#include <fmt/format.h>

#include <map>

#include "hwffd/error.hpp"
#include "mesh/assimp_export.hpp"
#include "mesh/scene.hpp"

namespace hwffd {
namespace {

void need_faces(const Output& output, const char* format, unsigned corners) {
  bool has_faces = false;
  each_part(output.scene, [&](const aiMesh& part, std::size_t) {
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      has_faces = has_faces || part.mFaces[f].mNumIndices >= corners;
    }
  });
  if (has_faces) return;
  throw Error(std::string("the mesh has no faces, and ") + format +
              " holds nothing else; use obj, ply or glb");
}

void replace(std::string& text, const std::string& part, const std::string& by) {
  const std::size_t at = text.find(part);
  if (at == text.npos) throw Error("cannot write the unit and the axis");
  text.replace(at, part.size(), by);
}

/// Puts the unit and the axis into the text of a file; Assimp's exporter calls every unit a metre
/// and y up.
void put_space(std::string& text, const Space& space) {
  static const std::map<double, const char*> kNames = {{0.001, "millimeter"},
                                                       {0.01, "centimeter"},
                                                       {0.0254, "inch"},
                                                       {0.3048, "foot"},
                                                       {1, "meter"}};
  const auto name = kNames.find(space.unit);
  replace(text, "<unit name=\"meter\" meter=\"1\" />",
          fmt::format("<unit name=\"{}\" meter=\"{}\" />",
                      name == kNames.end() ? "unit" : name->second, space.unit));
  replace(text, "<up_axis>Y_UP</up_axis>",
          fmt::format("<up_axis>{}_UP</up_axis>", "XYZ"[space.up]));
}

}  // namespace

Files write_stl(const Output& output) {
  constexpr unsigned kTriangle = 3;
  need_faces(output, "stl", kTriangle);
  const std::unique_ptr<aiScene> scene = copy_of(output, false);
  drop_points_and_lines(*scene);  // the exporter counts them, but does not write them
  return assimp_export(*scene, "stlb", output.path.filename().string());
}

Files write_dae(const Output& output) {
  constexpr unsigned kLine = 2;
  need_faces(output, "dae", kLine);
  const std::string name = output.path.filename().string();
  Files files = assimp_export(*copy_of(output, true), "collada", name);
  put_space(files.at(name), output.space);
  return files;
}

}  // namespace hwffd
