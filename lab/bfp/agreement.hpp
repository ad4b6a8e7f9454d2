#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "hwffd/model/configuration.hpp"

namespace hwffd::bfp {

/// Rows of one form, each at its read port in RTL, over the same vertices.
struct Agreement {
  std::string form;                 ///< "product" or "factored"
  std::vector<std::string> rows;    ///< by name
  std::uint64_t vertices = 0;       ///< of each row
  std::uint64_t mismatches = 0;     ///< results that differ from the model's
  std::uint64_t disagreements = 0;  ///< results that differ from those of the form's first row
};

/// The form of a row: product but for `factored`, however often folded.
std::string form_of(const Configuration& row);

/// Runs the rows given, each over the same vertices, infinities and NaN among their points.
/// `progress` is called with the number of rows done.
/// @throws std::invalid_argument where this build does not have a row
std::vector<Agreement> compare(const std::vector<const Configuration*>& rows, std::size_t vertices,
                               std::uint64_t seed,
                               const std::function<void(std::size_t, std::size_t)>& progress);

}  // namespace hwffd::bfp
