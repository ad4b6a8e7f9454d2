#pragma once

#include <filesystem>
#include <string>

namespace hwffd {

/// All bytes of a file.
/// @throws Error if it is not there, is a folder or cannot be read
std::string read_file(const std::filesystem::path& path);

}  // namespace hwffd
