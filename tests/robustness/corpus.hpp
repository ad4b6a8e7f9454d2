#pragma once

#include <string>
#include <vector>

namespace hwffd {

/// Valid inputs of each kind, small, with every entry that the kind knows.
std::vector<std::string> lattice_corpus();
std::vector<std::string> deformation_corpus();
std::vector<std::string> outside_corpus();
std::vector<std::string> stages_corpus();  ///< words of a command line, joined by blanks
std::vector<std::string> points_corpus();
std::vector<std::string> obj_corpus();
std::vector<std::string> ply_corpus();  ///< text and binary
std::vector<std::string> stl_corpus();  ///< text and binary

}  // namespace hwffd
