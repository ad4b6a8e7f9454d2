#include "design.hpp"

#include <stdexcept>

namespace hwffd::web {

const Design& design_of(const Configuration& row) {
  for (const Design& design : designs()) {
    if (design.row == row.name) return design;
  }
  throw std::invalid_argument(std::string(row.name) + ": a row that the page does not have");
}

int read_latency_of(const Configuration& row) {
  return row.mul_latency < 2 ? 2 : row.n == 1 ? 4 : row.n >= 32 ? 3 : 2;
}

}  // namespace hwffd::web
