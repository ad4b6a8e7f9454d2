#pragma once

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string>

namespace hwffd {

/// The extension of a path with its dot, in lower case: it names the format.
inline std::string extension_of(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return extension;
}

}  // namespace hwffd
