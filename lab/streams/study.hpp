#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "hwffd/mesh/mesh.hpp"
#include "hwffd/model/configuration.hpp"
#include "hwffd/tb/arrangement.hpp"

namespace hwffd::streams {

/// What one arrangement of one mesh in one lattice moves.
struct Row {
  std::string mesh;
  std::size_t vertices = 0;
  int points = 0;  ///< of the lattice, an axis
  std::string arrangement;
  std::string order;
  std::uint64_t predicted = 0;  ///< beats
  std::optional<std::uint64_t>
      counted{};                 ///< beats that the RTL took; nothing where it is not built
  std::uint64_t mismatches = 0;  ///< results that differ from the model

  double words_per_vertex() const {
    return 4.0 * static_cast<double>(predicted) / static_cast<double>(vertices);
  }
};

struct NamedMesh {
  std::string name;
  Mesh mesh;
};

using Progress = std::function<void(std::size_t done, std::size_t all)>;

/// All arrangements and orders for each mesh in a twisted box lattice of each number of points an
/// axis. Those that are built run on the RTL of `configuration`, several at a time.
/// @throws std::invalid_argument where this build does not have the configuration
std::vector<Row> study(const std::vector<NamedMesh>& meshes, const std::vector<int>& lattices,
                       const Configuration& configuration, const Progress& progress);

}  // namespace hwffd::streams
