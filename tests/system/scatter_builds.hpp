#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "hwffd/cores/stream_core.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd::test {

/// A simulated `hwffd_scatter`.
struct ScatterBuild {
  std::string name;   ///< scatter_<first cell of its row in CMakeLists.txt>
  Configuration row;  ///< as one of `affine`, whose weights it has
  int axis;           ///< points an axis, at most
  int pages;
  std::unique_ptr<cores::StreamCore> (*make)(std::uint64_t seed);
};

inline void PrintTo(const ScatterBuild& build, std::ostream* out) { *out << build.name; }

/// All of them, which CMake makes of its table.
std::vector<ScatterBuild> scatter_builds();

}  // namespace hwffd::test
