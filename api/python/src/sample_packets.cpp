#include "sample_packets.hpp"

#include <algorithm>
#include <cmath>

#include "hwffd/stream/blending.hpp"
#include "hwffd/stream/features.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packed.hpp"
#include "hwffd/stream/spans.hpp"

namespace hwffd::python {

namespace {

constexpr std::size_t kPacket = 24;        // vertices of one, at most
constexpr std::size_t kInterleaved = 3;    // of those that bring their points
constexpr double kRoom = 0.9;              // points and sums stay below 1
constexpr double kShare = 1.0 / (1 << 5);  // of vertices that are outside

}  // namespace

SamplePackets::SamplePackets(const SampledCore& core, std::uint64_t seed)
    : core_(core), codec_(core.format), random_(seed) {}

double SamplePackets::uniform(double low, double high) {
  return low + (high - low) * 0x1p-53 * static_cast<double>(random_() >> 11);
}

int SamplePackets::below(int end) {
  return static_cast<int>(random_() % static_cast<unsigned>(end));
}

std::vector<Beat> SamplePackets::functions() {
  const Functions which =
      has(model::kDerivativesFeature) ? Functions::kDerivativesToo : Functions::kBlending;
  if (core_.spans == 1) return coefficients_packet(watertight_bspline(codec_), codec_, which);
  const int cells = std::min(core_.spans, core_.axis - 3);
  const auto axis = encode(watertight_spans(clamped_knots(cells), codec_), codec_);
  return all_spans_packets({axis, axis, axis}, which);
}

std::array<std::uint32_t, 3> SamplePackets::point() {
  std::array<std::uint32_t, 3> words{};
  for (std::uint32_t& word : words) word = codec_.point(uniform(-kRoom, kRoom));
  return words;
}

LatticeWords SamplePackets::lattice(bool fourth) {
  LatticeWords lattice;
  std::size_t count = 1;
  for (int& points : lattice.dims) {
    points = 4 + below(std::min(core_.axis, 7) - 3);
    count *= static_cast<std::size_t>(points);
  }
  for (std::size_t p = 0; p < count; ++p) lattice.points.push_back(point());
  for (std::size_t p = 0; p < count && fourth; ++p) {
    lattice.fourth.push_back(codec_.point(uniform(kRoom / 2, kRoom)));
  }
  return lattice;
}

/// Rows along s, in which consecutive vertices are neighbours.
std::vector<VertexBeat> SamplePackets::vertices(std::size_t count, const Dims& dims) {
  std::vector<VertexBeat> list;
  VertexBeat vertex;
  for (std::size_t n = 0; n < count; ++n) {
    const bool row = n % 8 != 0;
    for (int axis = row ? 2 : 0; axis < 3; ++axis) {
      const int at = row ? 0 : axis;  // s moves on along a row, the others where one begins
      vertex.cell[at] = below(dims[at] - 3);
      const bool outside = uniform(0, 1) < kShare;
      vertex.local[at] = codec_.coordinate(outside ? uniform(1, 1.4) : uniform(0, 1));
    }
    vertex.tag = tag_++;
    list.push_back(vertex);
  }
  return list;
}

/// Those that the core has, one after the other.
Results SamplePackets::results(bool with_determinant) {
  const int kind = kind_of_results_++ % 4;
  if (kind == 1 && has(model::kDerivativesFeature)) return Results::kDerivatives;
  if (!with_determinant || !has(model::kDeterminantFeature)) return Results::kPosition;
  return kind == 2   ? Results::kDeterminant
         : kind == 3 ? Results::kDeterminantAlone
                     : Results::kPosition;
}

PageVertices SamplePackets::how(bool fourth) {
  PageVertices how;
  how.results = results(!fourth);
  how.fourth = fourth;
  how.large = has(model::kLargeFeature) && below(2) == 0;
  how.count = has(model::kMarksFeature) && below(2) == 0;
  how.interrupt = has(model::kMarksFeature) && below(2) == 0;
  how.half = has(model::kHalvesFeature) && !fourth && can_be_halved(how.results) && below(2) == 0;
  return how;
}

std::vector<Beat> SamplePackets::resident(std::size_t& left) {
  const LatticeWords loaded = lattice(false);
  std::vector<Beat> beats = lattice_packet(loaded);
  for (const OutsideMode mode : {OutsideMode::kClamp, OutsideMode::kPass, OutsideMode::kBlank}) {
    const std::size_t count = std::min(left, kPacket);
    left -= count;
    if (count == 0) break;
    append(beats, vertices_packet(vertices(count, loaded.dims), mode, results(true)));
  }
  return beats;
}

std::vector<Beat> SamplePackets::page(std::size_t& left) {
  const int number = below(core_.pages);
  const bool fourth = has(model::kFourthFeature) && below(2) == 0;
  LatticeWords loaded = lattice(fourth);
  std::vector<Beat> beats = page_packet(number, loaded);
  for (int turn = 0; turn < 2; ++turn) {
    const std::size_t count = std::min(left, kPacket);
    left -= count;
    if (count == 0) break;
    PageVertices wanted = how(fourth);
    wanted.every = turn == 1;
    append(beats, page_vertices_packet(number, vertices(count, loaded.dims), wanted));
    if (turn == 1) break;
    for (auto& moved : loaded.points) moved = point();
    append(beats, points_packet(number, loaded, 3, loaded.points.size() / 2));
  }
  return beats;
}

std::vector<Beat> SamplePackets::grid(std::size_t& left) {
  const LatticeWords loaded = lattice(false);
  const int number = has(model::kPagesFeature) ? below(core_.pages) : 0;
  std::vector<Beat> beats =
      has(model::kPagesFeature) ? page_packet(number, loaded) : lattice_packet(loaded);
  std::array<int, 3> count{static_cast<int>(std::min<std::size_t>(left, 7)), 1, 1};
  for (const int axis : {1, 2}) {
    const std::size_t vertices = static_cast<std::size_t>(count[0]) * count[1];
    count[axis] = static_cast<int>(std::min<std::size_t>(3, left / vertices));
  }
  std::array<double, 3> first{}, last{};
  for (int axis = 0; axis < 3; ++axis) {
    const double cells = loaded.dims[axis] - 3;
    first[axis] = uniform(0, cells);
    last[axis] = axis == 0 ? cells : uniform(0, cells);
  }
  const Grid made = grid_between(first, last, count, tag_);
  PageVertices wanted = how(false);
  if (!has(model::kPagesFeature)) wanted.half = wanted.count = wanted.interrupt = false;
  append(beats, grid_packet(made, number, wanted));
  left -= vertex_count(made);
  return beats;
}

std::vector<Beat> SamplePackets::packed_vertices(std::size_t& left) {
  const LatticeWords loaded = lattice(false);
  const std::size_t count = std::min(left, kPacket - 1);
  left -= count;
  std::vector<PackedVertex> list;
  for (const VertexBeat& vertex : vertices(count, loaded.dims)) {
    PackedVertex one;
    one.cell = vertex.cell;
    for (std::uint32_t& word : one.local) word = static_cast<std::uint32_t>(below(kPackedOne + 1));
    list.push_back(one);
  }
  std::vector<Beat> beats = lattice_packet(loaded);
  append(beats, packed_packet(list, OutsideMode::kClamp, results(true)));
  return beats;
}

std::vector<Beat> SamplePackets::interleaved(std::size_t& left) {
  const std::size_t count = std::min(left, kInterleaved);
  left -= count;
  std::vector<InterleavedVertex> list;
  for (const VertexBeat& vertex : vertices(count, {7, 7, 7})) {
    InterleavedVertex one;
    static_cast<VertexBeat&>(one) = vertex;
    for (std::uint32_t& word : one.points) word = codec_.point(uniform(-kRoom, kRoom));
    list.push_back(one);
  }
  return interleaved_packet(list, OutsideMode::kClamp, results(true));
}

/// With its points where the core takes such vertices, else with a lattice.
std::vector<Beat> SamplePackets::first() {
  std::size_t left = 1;
  if (has(model::kInterleavedFeature)) return interleaved(left);
  const LatticeWords loaded = lattice(false);
  std::vector<Beat> beats = lattice_packet(loaded);
  append(beats, vertices_packet(vertices(1, loaded.dims)));
  return beats;
}

std::vector<Beat> SamplePackets::packets(std::size_t vertices) {
  using Kind = std::vector<Beat> (SamplePackets::*)(std::size_t&);
  std::vector<Kind> kinds;
  if (has(model::kResidentFeature)) kinds.push_back(&SamplePackets::resident);
  if (has(model::kInterleavedFeature)) kinds.push_back(&SamplePackets::interleaved);
  if (has(model::kPagesFeature)) kinds.push_back(&SamplePackets::page);
  if (has(model::kGridsFeature)) kinds.push_back(&SamplePackets::grid);
  if (has(model::kPackedFeature)) kinds.push_back(&SamplePackets::packed_vertices);
  std::vector<Beat> beats = functions();
  if (vertices == 0) return beats;
  append(beats, first());
  beats_of_first_ = beats.size();
  --vertices;
  for (std::size_t turn = 0; vertices != 0; ++turn) {
    append(beats, (this->*kinds.at(turn % kinds.size()))(vertices));
  }
  return beats;
}

}  // namespace hwffd::python
