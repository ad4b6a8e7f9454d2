#include <sys/resource.h>

#include <functional>
#include <utility>

#include "corpus.hpp"
#include "fuzz.hpp"
#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "temp_folder.hpp"

namespace hwffd {
namespace {

void expect_valid(const Mesh& mesh) {
  expect(mesh.vertex_count() > 0, "a mesh without vertices");
  expect(mesh.vertex_count() <= mesh.vertex_count_read(), "welding added vertices");
  expect(mesh.positions().allFinite(), "a position that is not finite");
  for (const Mesh::Triangle& triangle : mesh.triangles()) {
    for (const std::uint32_t v : triangle) expect(v < mesh.vertex_count(), "a corner out of range");
  }
}

/// Broken files ask for any amount of memory; more than this is refused them.
bool limit_memory() {
  constexpr rlim_t kBytes = rlim_t{2} << 30;
  const rlimit limit{kBytes, kBytes};
  return ::setrlimit(RLIMIT_AS, &limit) == 0;
}

/// One of the formats that are written, the same for the same input.
std::string output_for(const std::string& input) {
  static const std::vector<std::string> kNames{"out.obj", "out.ply",  "out.off", "out.stl",
                                               "out.glb", "out.gltf", "out.dae"};
  return kNames[std::hash<std::string>{}(input) % kNames.size()];
}

/// Saves the mesh in a folder of its own: all of its files are there afterwards, or none.
void save(const Mesh& mesh, const std::string& name) {
  const TempFolder folder;
  try {
    mesh.save(folder / name);
  } catch (const Error&) {
    expect(folder.files().empty(), "a file half written");
    throw;
  }
  expect(folder.files().count(name) == 1, "no file written");
  for (const std::string& file : folder.files()) expect(file[0] != '.', "a temporary file is left");
  if (name == "out.dae") return;  // whose exporter takes any name, and whose reader does not
  const Mesh again = Mesh::load(folder / name);
  const std::string text = "another number of vertices in " + name;
  // Below a node's transform the numbers of a file are rounded, and equal places become unequal;
  // and places that only doubles tell apart are one in most formats.
  if (mesh.edits(folder / name) && name == "out.stl") {  // whose vertices have no numbers
    expect(again.triangles().size() == mesh.triangles().size(), text.c_str());
  } else if (mesh.edits(folder / name)) {
    expect(again.vertex_count_read() == mesh.vertex_count_read(), text.c_str());
  } else if (name != "out.stl" && mesh.is_single()) {
    expect(again.vertex_count() == mesh.vertex_count(), text.c_str());
  }
}

void read_mesh(const std::string& name, const std::string& input) {
  static const bool limited = limit_memory();
  expect(limited, "no limit of memory");
  Mesh mesh = Mesh::load(mesh_folder().write(name, input));
  expect_valid(mesh);
  const std::size_t vertices = mesh.vertex_count();
  // A mirror about the origin: exact, so different places stay different.
  mesh.set_positions(-mesh.positions(),
                     std::vector<Eigen::Matrix3d>(vertices, -Eigen::Matrix3d::Identity()));
  expect_valid(mesh);
  save(mesh, output_for(input));
}

Target target(const char* format, std::vector<std::string> corpus) {
  const std::string name = std::string("a.") + format;
  return {format, std::move(corpus), [name](const std::string& input) { read_mesh(name, input); }};
}

std::vector<std::string> with(std::vector<std::string> corpus,
                              const std::vector<std::string>& others) {
  corpus.insert(corpus.end(), others.begin(), others.end());
  return corpus;
}

}  // namespace

std::vector<Target> targets() {
  return {target("obj", obj_corpus()),
          target("ply", ply_corpus()),
          target("stl", stl_corpus()),
          target("off", off_corpus()),
          target("raw", raw_corpus()),
          target("gltf", with(gltf_corpus(), exported_corpus({"gltf2"}))),
          target("glb", with(glb_corpus(), exported_corpus({"glb2"}))),
          target("dae", exported_corpus({"collada"})),
          target("fbx", exported_corpus({"fbxa"})),
          target("3ds", exported_corpus({"3ds"})),
          target("3mf", exported_corpus({"3mf"})),
          target("x", exported_corpus({"x"})),
          target("x3d", exported_corpus({"x3d"})),
          target("assbin", exported_corpus({"assbin"}))};
}

}  // namespace hwffd
