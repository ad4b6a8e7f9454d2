#include "hwffd/tb/arrangement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <stdexcept>

#include "hwffd/lattice/interleave.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::tb {
namespace {

using Kind = Arrangement::Kind;

constexpr std::uint64_t kHeader = 1;
constexpr std::uint64_t kSupport = 64;  // points

std::uint64_t beats_of_words(std::uint64_t words) { return (words + 3) / 4; }

/// Two vertices a beat; a packet of an odd number has a beat that is half empty.
std::uint64_t packed_beats(std::uint64_t vertices) {
  static_assert(kPacketVertices % 2 == 0, "only the last packet may be odd");
  return (vertices + 1) / 2;
}

std::uint64_t beats_of_packets(std::uint64_t vertices) {
  return kHeader * ((vertices + kPacketVertices - 1) / kPacketVertices);
}

/// Points of a cell's support that another cell's support does not have.
std::uint64_t new_points(const Index3& cell, const Index3& before) {
  std::uint64_t shared = 1;
  for (int a = 0; a < 3; ++a)
    shared *= static_cast<std::uint64_t>(std::max(0, 4 - std::abs(cell[a] - before[a])));
  return kSupport - shared;
}

std::uint64_t changed_beats(const std::vector<Index3>& cells) {
  std::uint64_t beats = beats_of_packets(cells.size());
  for (std::size_t v = 0; v < cells.size(); ++v) {
    const std::uint64_t points = v == 0 ? kSupport : new_points(cells[v], cells[v - 1]);
    beats += 1 + beats_of_words(2 + 3 * points);  // the vertex, then mask and points
  }
  return beats;
}

/// Vertices between two cells that are loaded, a packet or more each.
std::uint64_t cell_beats(const std::vector<Index3>& cells, std::size_t capacity) {
  std::deque<Index3> cache;  // used last first
  std::uint64_t beats = 0;
  std::uint64_t run = 0;
  for (const Index3& cell : cells) {
    const auto it = std::find(cache.begin(), cache.end(), cell);
    if (it != cache.end()) {
      cache.erase(it);
    } else {
      beats += beats_of_packets(run) + run + kHeader + kSupport;
      run = 0;
      if (cache.size() == capacity) cache.pop_back();
    }
    cache.push_front(cell);
    ++run;
  }
  return beats + beats_of_packets(run) + run;
}

/// Each cell as a lattice of its own, whenever it is another than that of the vertex before.
void append_cells(std::vector<Beat>& beats, const Lattice& lattice,
                  const std::vector<Embedded>& vertices, const WordCodec& codec,
                  const Normalization& normalization) {
  for (std::size_t first = 0; first < vertices.size();) {
    const Index3 cell = vertices[first].cell;
    std::vector<Embedded> run;
    for (; first < vertices.size() && vertices[first].cell == cell; ++first) {
      run.push_back(vertices[first]);
      run.back().cell = {0, 0, 0};
    }
    Points points(lattice.support(cell));
    append(beats, lattice_packet(lattice_words({{4, 4, 4}, points}, codec, normalization)));
    append(beats, vertices_packets(vertex_beats(run, codec)));
  }
}

}  // namespace

std::string Arrangement::name() const {
  switch (kind) {
    case Kind::kInterleaved:
      return "interleaved";
    case Kind::kChanged:
      return "changed points";
    case Kind::kCells:
      return cells == 1 ? "1 cell" : fmt::format("{} cells", cells);
    case Kind::kPacked:
      return "packed";
    case Kind::kResident:
      break;
  }
  return "resident";
}

bool Arrangement::is_built() const {
  return kind == Kind::kInterleaved || kind == Kind::kResident ||
         (kind == Kind::kCells && cells == 1);
}

std::vector<Arrangement> arrangements() {
  return {{Kind::kInterleaved, 0, {"file"}},   {Kind::kChanged, 0, {"file", "cell", "curve"}},
          {Kind::kCells, 1, {"file", "cell"}},  // sorted, more of them change nothing
          {Kind::kCells, 4, {"file"}},         {Kind::kCells, 16, {"file"}},
          {Kind::kResident, 0, {"file"}},      {Kind::kPacked, 0, {"file"}}};
}

Arrangement find_arrangement(const std::string& name) {
  for (const Arrangement& arrangement : arrangements()) {
    if (arrangement.name() == name) return arrangement;
  }
  throw std::invalid_argument(name + ": no arrangement of this name");
}

std::uint64_t predicted_beats(const Arrangement& arrangement, const Index3& dims,
                              const std::vector<Index3>& cells) {
  const std::uint64_t vertices = cells.size();
  std::uint64_t beats = kHeader + kCoefficientBeats;
  switch (arrangement.kind) {
    case Kind::kInterleaved:
      return beats + beats_of_packets(vertices) + vertices * kVertexBeats;
    case Kind::kChanged:
      return beats + changed_beats(cells);
    case Kind::kCells:
      return beats + cell_beats(cells, arrangement.cells);
    case Kind::kResident:
    case Kind::kPacked:
      break;
  }
  const auto points = static_cast<std::uint64_t>(dims[0]) * dims[1] * dims[2];
  return beats + kHeader + points + beats_of_packets(vertices) +
         (arrangement.kind == Kind::kPacked ? packed_beats(vertices) : vertices);
}

std::vector<Beat> packets(const Arrangement& arrangement, const Lattice& lattice,
                          const std::vector<Embedded>& vertices, const std::string& format) {
  const WordCodec codec(format);
  const Normalization normalization = Normalization::of(lattice, codec);
  std::vector<Beat> beats = coefficients_packet(watertight_bspline(codec), codec);
  if (arrangement.kind == Kind::kInterleaved) {
    append(beats, interleaved_packets(interleave(lattice, vertices, codec, normalization)));
  } else if (arrangement.kind == Kind::kResident) {
    append(beats, lattice_packet(lattice_words(lattice, codec, normalization)));
    append(beats, vertices_packets(vertex_beats(vertices, codec)));
  } else if (arrangement.is_built()) {
    append_cells(beats, lattice, vertices, codec, normalization);
  } else {
    throw std::invalid_argument(arrangement.name() + ": the core does not take this arrangement");
  }
  return beats;
}

}  // namespace hwffd::tb
