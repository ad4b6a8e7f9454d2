#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace hwffd::bfp {

/// The largest errors of a form of eq. (1) over control points of a distribution, in ulp of the
/// largest magnitude of the control points, against eq. (1) in double of the words as given.
/// Coordinates, weights and alignment are in it.
struct Result {
  std::string points;     ///< how they are distributed
  std::string form;       ///< "product" or "factored"
  double of_lattice = 0;  ///< in ulp of the largest of the lattice
  double of_support = 0;  ///< in ulp of the largest of the 64 points that a vertex has
  double bound = 0;       ///< proved, of `of_lattice`
  std::int64_t vertices = 0;
};

/// Called with the done part of the work, 0 to 1, by one thread at a time.
using Progress = std::function<void(double)>;

/// Measures both forms over every distribution, `vertices` each, on all cores, in lattices of
/// 8 x 8 x 8 points. The results depend on seed and number of vertices only.
std::vector<Result> study(std::int64_t vertices, std::uint64_t seed, const Progress& progress);

}  // namespace hwffd::bfp
