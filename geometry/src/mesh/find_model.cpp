#include <fmt/format.h>

#include <system_error>

#include "hwffd/error.hpp"
#include "hwffd/mesh/mesh.hpp"

namespace hwffd {

namespace fs = std::filesystem;

fs::path find_model(const std::string& name, const std::vector<fs::path>& folders) {
  fs::path path(name);
  std::error_code ignored;
  if (path.has_parent_path()) return path;
  if (fs::is_regular_file(path, ignored)) return path;
  std::string tried;
  for (const fs::path& folder : folders) {
    if (!name.empty() && fs::is_regular_file(folder / path, ignored)) return folder / path;
    tried += " or " + folder.string();
  }
  throw Error(
      fmt::format("model '{}': no such file in this folder{}; give a path, or install the "
                  "package glmark2-data (cat.3ds, horse.3ds, bunny.obj)",
                  name, tried));
}

Mesh load_model(const std::string& name) {
  if (!name.empty()) return Mesh::load(find_model(name));
  fs::path cat;
  try {
    cat = find_model("cat.3ds");
  } catch (const Error&) {
    return Mesh::procedural();
  }
  return Mesh::load(cat);
}

}  // namespace hwffd
