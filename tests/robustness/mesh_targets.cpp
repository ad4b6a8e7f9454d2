#include <sys/resource.h>

#include "corpus.hpp"
#include "hwffd/mesh/mesh.hpp"
#include "targets.hpp"
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

void read_mesh(const char* name, const std::string& input) {
  static const bool limited = limit_memory();
  static const TempFolder folder;
  expect(limited, "no limit of memory");
  Mesh mesh = Mesh::load(folder.write(name, input));
  expect_valid(mesh);
  const std::size_t vertices = mesh.vertex_count();
  mesh.set_positions(0.5 * mesh.positions(),
                     std::vector<Eigen::Matrix3d>(vertices, -0.5 * Eigen::Matrix3d::Identity()));
  expect_valid(mesh);
  mesh.save(folder / "out.obj");
}

}  // namespace

const std::vector<Target>& targets() {
  static const std::vector<Target> all{
      {"obj", 2000, obj_corpus(), [](const std::string& input) { read_mesh("a.obj", input); }},
      {"ply", 2000, ply_corpus(), [](const std::string& input) { read_mesh("a.ply", input); }},
      {"stl", 2000, stl_corpus(), [](const std::string& input) { read_mesh("a.stl", input); }}};
  return all;
}

}  // namespace hwffd
