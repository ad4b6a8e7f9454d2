#include "mesh/relocated.hpp"

#include <system_error>

namespace hwffd {

namespace fs = std::filesystem;

std::string relocated(const std::string& name, const fs::path& folder, const fs::path& output) {
  const fs::path file(name);
  const bool stays = name.empty() || name[0] == '*' || file.is_absolute() ||
                     name.find(':') != name.npos || folder.empty();
  if (stays) return name;
  std::error_code error;
  const fs::path to = fs::weakly_canonical(fs::absolute(output).parent_path(), error);
  const fs::path from = fs::weakly_canonical(folder, error);
  if (error || to == from) return name;
  const fs::path relative = (from / file).lexically_normal().lexically_relative(to);
  return relative.empty() ? name : relative.string();
}

}  // namespace hwffd
