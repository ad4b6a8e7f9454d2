#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace hwffd {

/// All bytes of a file.
/// @param most  bytes that it may have; some files, such as /dev/zero, have no end
/// @throws Error if it is not there, is a folder, cannot be read or has more bytes
std::string read_file(const std::filesystem::path& path, std::size_t most = SIZE_MAX);

}  // namespace hwffd
