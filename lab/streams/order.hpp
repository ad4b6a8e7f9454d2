#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hwffd/lattice/lattice.hpp"

namespace hwffd::streams {

/// The orders in which vertices can be sent: that of the file, sorted by cell (k fastest), or with
/// the cells along Hilbert's curve. Vertices of a cell keep the order of the file.
const std::vector<std::string>& order_names();

/// The vertices in an order of order_names().
std::vector<Embedded> ordered(const std::vector<Embedded>& vertices, const std::string& order);

/// The place of a cell on Hilbert's curve through 16 x 16 x 16 cells; each index 0 to 15. Cells
/// that follow each other on it share a face.
std::size_t place_on_curve(const Index3& cell);

}  // namespace hwffd::streams
