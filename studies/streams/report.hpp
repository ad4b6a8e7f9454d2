#pragma once

#include <string>
#include <vector>

#include "study.hpp"

namespace hwffd::streams {

/// Words a vertex: a line an arrangement and order of each mesh, a column a lattice.
std::string table(const std::vector<Row>& rows);
/// docs/verification.md has the fields.
std::string json_report(const std::vector<Row>& rows);
/// The same as curves over the lattice's size, a panel a mesh.
std::string plot(const std::vector<Row>& rows);
/// A line for each row whose count differs from its prediction or whose results differ from the
/// model; empty if all is well.
std::string faults(const std::vector<Row>& rows);

}  // namespace hwffd::streams
