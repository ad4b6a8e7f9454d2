#pragma once

#include <string>
#include <vector>

namespace hwffd {

/// Looks at a ply file before Assimp does, whose reader trusts the header: with a file cut short,
/// or numbers that are too large, it reads beyond its buffer or does not end.
/// @param bytes the whole file
/// @return what is wrong, in a few words; empty if header and data belong together
std::string fault_of_ply(const std::string& bytes);

/// What a ply file without a fault holds that is not read: "property quality of vertex".
std::vector<std::string> unread_of_ply(const std::string& bytes);

}  // namespace hwffd
