#include "order.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace hwffd::streams {
namespace {

constexpr unsigned kBits = 4;  // of an index
constexpr int kAxes = 3;

std::size_t place_by_cell(const Index3& cell) {
  std::size_t place = 0;
  for (const int index : cell) place = 16 * place + static_cast<std::size_t>(index);
  return place;
}

}  // namespace

const std::vector<std::string>& order_names() {
  static const std::vector<std::string> names{"file", "cell", "curve"};
  return names;
}

// From the highest bit down, each octant is a smaller curve, turned or mirrored so that its ends
// meet those of its neighbours (J. Skilling, "Programming the Hilbert curve", 2004). The bits of
// the three axes, interleaved, are then the place.
std::size_t place_on_curve(const Index3& cell) {
  std::array<unsigned, kAxes> x{};
  for (int a = 0; a < kAxes; ++a) x[a] = static_cast<unsigned>(cell[a]);
  for (unsigned bit = 1U << (kBits - 1); bit > 1; bit >>= 1U) {
    const unsigned below = bit - 1;
    for (unsigned& axis : x) {
      if ((axis & bit) != 0) {
        x[0] ^= below;
      } else {
        const unsigned exchanged = (x[0] ^ axis) & below;
        x[0] ^= exchanged;
        axis ^= exchanged;
      }
    }
  }
  for (int a = 1; a < kAxes; ++a) x[a] ^= x[a - 1];  // Gray code
  unsigned mirrored = 0;
  for (unsigned bit = 1U << (kBits - 1); bit > 1; bit >>= 1U)
    if ((x[kAxes - 1] & bit) != 0) mirrored ^= bit - 1;
  for (unsigned& axis : x) axis ^= mirrored;
  std::size_t place = 0;
  for (unsigned bit = 1U << (kBits - 1); bit > 0; bit >>= 1U)
    for (const unsigned axis : x) place = 2 * place + ((axis & bit) != 0 ? 1 : 0);
  return place;
}

std::vector<Embedded> ordered(const std::vector<Embedded>& vertices, const std::string& order) {
  if (order == "file") return vertices;
  std::vector<std::size_t> places(vertices.size());
  std::transform(vertices.begin(), vertices.end(), places.begin(), [&](const Embedded& vertex) {
    return order == "curve" ? place_on_curve(vertex.cell) : place_by_cell(vertex.cell);
  });
  std::vector<std::size_t> sorted(vertices.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
  std::vector<Embedded> result;
  result.reserve(vertices.size());
  for (const std::size_t v : sorted) result.push_back(vertices[v]);
  return result;
}

}  // namespace hwffd::streams
