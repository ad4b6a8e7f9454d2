#pragma once

#include <filesystem>
#include <string>

namespace hwffd {

/// The name of a file beside a mesh for who looks from another folder: relative names are found
/// from there, too. Pictures inside the mesh (*0), absolute paths and addresses stay.
/// @param folder  that the name starts from; empty: the name stays
/// @param output  the mesh in the other folder
std::string relocated(const std::string& name, const std::filesystem::path& folder,
                      const std::filesystem::path& output);

}  // namespace hwffd
