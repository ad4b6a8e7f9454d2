#pragma once

#include <string>
#include <vector>

#include "temp_folder.hpp"

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
std::vector<std::string> off_corpus();
std::vector<std::string> raw_corpus();

/// The mesh of obj_corpus() in triangles, with a moved node and a camera, as Assimp's exporters of
/// these names write it. Files that belong to it (bin) are in mesh_folder().
/// Some hold the date, which changes no length.
std::vector<std::string> exported_corpus(const std::vector<std::string>& exporters);

std::vector<std::string> gltf_corpus();  ///< as text, with all that our reader knows
std::vector<std::string> glb_corpus();   ///< the same in a container

/// Where meshes are to be read from.
const TempFolder& mesh_folder();

}  // namespace hwffd
