#include "page_stimulus.hpp"

#include <utility>

#include "hwffd/model/stream_model.hpp"

namespace hwffd::test {

LatticeWords with_fourth(LatticeWords lattice, const WordCodec& codec, tb::Random& random) {
  const LatticeWords other = random_lattice(codec, random, lattice.dims);
  for (const auto& point : other.points) lattice.fourth.push_back(point[0]);
  return lattice;
}

std::vector<Beat> PagePackets::any(int packets) {
  std::vector<Beat> beats;
  for (int p = 0; p < packets; ++p) {
    append(beats, random_.chance(0.3)   ? random_packets(codec_, random_, 1)
                  : random_.chance(0.2) ? spoil(any_packet())
                                        : any_packet());
  }
  return beats;
}

std::vector<Beat> PagePackets::any_packet() {
  // Now and then a page beyond the last, which is then beyond what lattices_ knows.
  const int page = static_cast<int>(random_.below(core_.pages + (random_.chance(0.05) ? 3 : 0)));
  switch (random_.below(4)) {
    case 0:
      return load(page);
    case 1:
      return points(page);
    default:
      return vertices(page);
  }
}

std::vector<Beat> PagePackets::load(int page) {
  std::array<int, 3> dims;
  for (int& points : dims) points = static_cast<int>(random_.between(4, 6));
  // One axis as long as the core takes it.
  if (random_.chance(0.2)) {
    dims = {4, 4, 4};
    dims[random_.below(3)] = core_.axis - static_cast<int>(random_.below(3));
  }
  LatticeWords lattice = random_lattice(codec_, random_, dims);
  if (has(model::kFourthFeature) && random_.chance(0.7)) {
    lattice = with_fourth(lattice, codec_, random_);
  }
  if (page < core_.pages) lattices_[page] = lattice;
  std::array<int, 3> origin{};
  if (has(model::kSpansFeature)) {
    for (int& cells : origin)
      cells = static_cast<int>(random_.below(random_.chance(0.5) ? 8 : 128));
  }
  return page_packet(page, lattice, origin);
}

std::vector<Beat> PagePackets::points(int page) {
  LatticeWords lattice = random_lattice(codec_, random_, 4);
  if (page < core_.pages && !lattices_[page].points.empty()) {
    const LatticeWords& loaded = lattices_[page];
    LatticeWords moved = random_lattice(codec_, random_, loaded.dims);
    moved.exponent = loaded.exponent;
    if (!loaded.fourth.empty() && random_.chance(0.7)) moved = with_fourth(moved, codec_, random_);
    lattice = std::move(moved);
  }
  const std::size_t all = lattice.points.size();
  const std::size_t first = random_.below(all);
  const std::size_t most = random_.chance(0.5) ? 3 : all;
  std::vector<Beat> packet = points_packet(
      page, lattice, first, std::min<std::size_t>(all - first, 1 + random_.below(most)));
  if (random_.chance(0.1)) packet[0].words[1] += static_cast<std::uint32_t>(random_.below(all));
  if (random_.chance(0.05)) packet[0].words[2] = random_.word() & 0x3FFFF;
  return packet;
}

std::vector<Beat> PagePackets::vertices(int page) {
  const bool known = page < core_.pages && !lattices_[page].points.empty();
  const std::array<int, 3> dims = known ? lattices_[page].dims : std::array<int, 3>{4, 4, 4};
  PageVertices how;
  how.mode = static_cast<OutsideMode>(random_.below(4));
  if (has(model::kDerivativesFeature)) how.results = static_cast<Results>(random_.below(2));
  if (has(model::kDeterminantFeature) && random_.chance(0.3)) {
    how.results = random_.chance(0.5) ? Results::kDeterminant : Results::kDeterminantAlone;
  }
  how.every = random_.chance(0.3);
  how.count = has(model::kMarksFeature) && random_.chance(0.5);
  how.interrupt = has(model::kMarksFeature) && random_.chance(0.5);
  how.large = has(model::kLargeFeature) && random_.chance(0.7);
  how.fourth = has(model::kFourthFeature) &&
               random_.chance(known && !lattices_[page].fourth.empty() ? 0.8 : 0.1);
  how.half = has(model::kHalvesFeature) && random_.chance(0.3);
  auto some = random_vertices(codec_, random_, dims, random_.between(1, 9), true);
  for (VertexBeat& vertex : some) {
    if (random_.chance(0.1)) vertex.cell[random_.below(3)] = static_cast<int>(random_.below(64));
  }
  return page_vertices_packet(page, some, how);
}

/// Something wrong that only headers of pages can have, or any packet.
std::vector<Beat> PagePackets::spoil(std::vector<Beat> packet) {
  if (random_.chance(0.5)) return spoiled(std::move(packet), random_);
  switch (random_.below(3)) {
    case 0:
      packet[0].words[0] |= 0x10000U << random_.below(16);
      break;
    case 1:
      packet[0].words[2 + random_.below(2)] |= 1U << random_.below(32);
      break;
    default:
      packet[0].words[0] =
          (packet[0].words[0] & ~0xFF00U) | static_cast<std::uint32_t>(random_.below(8)) << 8;
  }
  return packet;
}

}  // namespace hwffd::test
