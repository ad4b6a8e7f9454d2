#include "mesh/formats.hpp"

#include <algorithm>

#include "hwffd/mesh/extension.hpp"

namespace hwffd {

const MeshFormat* format_of(const std::filesystem::path& path) {
  const std::vector<MeshFormat>& formats = mesh_formats();
  const std::string extension = extension_of(path);
  const auto format = std::find_if(formats.begin(), formats.end(), [&](const MeshFormat& entry) {
    return extension == entry.extension;
  });
  return format == formats.end() ? nullptr : &*format;
}

}  // namespace hwffd
