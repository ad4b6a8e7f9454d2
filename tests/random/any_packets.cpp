#include "any_packets.hpp"

#include <algorithm>
#include <utility>

#include "hwffd/model/stream_model.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::test {

int AnyPackets::page() {
  if (!has(model::kPagesFeature)) return 0;
  return static_cast<int>(random_.below(core_.pages + (random_.chance(0.03) ? 2 : 0)));
}

std::vector<Beat> AnyPackets::functions() {
  const Functions which =
      has(model::kDerivativesFeature) ? Functions::kDerivativesToo : Functions::kBlending;
  return random_.chance(0.5) ? coefficients_packet(watertight_bspline(codec_), codec_, which)
                             : coefficients_packet(random_coefficients(codec_, random_), which);
}

std::vector<Beat> AnyPackets::spans() { return random_span_packets(codec_, random_, core_); }

LatticeWords AnyPackets::fresh(const std::array<int, 3>& dims) {
  LatticeWords lattice = random_lattice(codec_, random_, dims);
  const bool fourth = has(model::kFourthFeature) && random_.chance(0.7);
  return fourth ? with_fourth(std::move(lattice), codec_, random_) : lattice;
}

std::array<int, 3> AnyPackets::dims_of(int page) const {
  const auto at = static_cast<std::size_t>(page);
  const bool known = at < lattices_.size() && !lattices_[at].points.empty();
  return known ? lattices_[at].dims : std::array<int, 3>{4, 4, 4};
}

std::vector<Beat> AnyPackets::resident_lattice() {
  LatticeWords lattice = fresh({4, 4, 4});
  lattice.fourth.clear();
  newest_ = lattices_.size() > 1 ? 1 - newest_ : 0;
  lattices_[newest_] = lattice;
  return lattice_packet(lattice);
}

std::vector<Beat> AnyPackets::page_lattice(int page) {
  std::array<int, 3> dims{4, 4, 4};
  if (random_.chance(0.85)) {
    for (int& points : dims)
      points = static_cast<int>(random_.pick({4, 4, std::min(core_.axis, 5)}));
  } else {
    dims[random_.below(3)] = core_.axis - static_cast<int>(random_.below(core_.axis > 5 ? 3 : 1));
  }
  const LatticeWords lattice = fresh(dims);
  if (static_cast<std::size_t>(page) < lattices_.size()) lattices_[page] = lattice;
  std::array<int, 3> origin{};
  for (int& cells : origin) {
    if (has(model::kSpansFeature)) cells = static_cast<int>(random_.below(random_.pick({4, 128})));
  }
  return page_packet(page, lattice, origin);
}

std::vector<Beat> AnyPackets::lattice() {
  if (!has(model::kResidentFeature)) return {};
  return has(model::kPagesFeature) && random_.chance(0.7) ? page_lattice(page())
                                                          : resident_lattice();
}

std::vector<Beat> AnyPackets::page_points(int page) {
  LatticeWords moved = random_lattice(codec_, random_, dims_of(page));
  const auto at = static_cast<std::size_t>(page);
  if (at < lattices_.size()) {
    moved.exponent = lattices_[at].exponent;
    if (!lattices_[at].fourth.empty()) moved = with_fourth(std::move(moved), codec_, random_);
  }
  const std::size_t all = moved.points.size();
  const std::size_t first = random_.below(all);
  return points_packet(page, moved, first,
                       1 + random_.below(std::min<std::size_t>(all - first, 9)));
}

PageVertices AnyPackets::flags(int page) {
  PageVertices how;
  const auto at = static_cast<std::size_t>(page);
  const bool fourth = at < lattices_.size() && !lattices_[at].fourth.empty();
  how.large = has(model::kLargeFeature) &&
              (random_.chance(0.5) || (at < lattices_.size() && is_large(lattices_[at])));
  how.count = has(model::kMarksFeature) && random_.chance(0.5);
  how.interrupt = has(model::kMarksFeature) && random_.chance(0.5);
  how.fourth = fourth && random_.chance(0.5);
  if (has(model::kDerivativesFeature)) how.results = static_cast<Results>(random_.below(2));
  if (has(model::kDeterminantFeature) && !how.fourth && random_.chance(0.3)) {
    how.results = random_.chance(0.5) ? Results::kDeterminant : Results::kDeterminantAlone;
  }
  how.half = has(model::kHalvesFeature) && !how.fourth && random_.chance(0.3);
  return how;
}

std::vector<Beat> AnyPackets::grid(int page) {
  std::vector<Beat> packet = grid_packet(random_grid(random_, dims_of(page), 2), page, flags(page));
  if (random_.chance(0.8)) return packet;
  // No count is more than it was: grids stay small.
  Beat& any = packet[random_.below(packet.size())];
  if (random_.chance(0.5) && &any != packet.data()) {
    any.words[random_.below(4)] ^= 1U << random_.below(32);
  } else {
    packet[0].words[1] &= random_.chance(0.5) ? 0xFFFFU : 0xFFFF0000U;
  }
  return packet;
}

std::vector<Beat> AnyPackets::packed(int page, std::size_t most) {
  PageVertices how = flags(page);
  how.large = false;
  how.mode = static_cast<OutsideMode>(random_.below(4));
  const auto some = random_packed(random_, dims_of(page), random_.between(1, most), true);
  if (!has(model::kPagesFeature)) return packed_packet(some, how.mode, how.results);
  how.every = random_.chance(0.3);
  std::vector<Beat> packet = page_packed_packet(page, some, how);
  if (random_.chance(0.1)) packet.back().words[1] |= 1U << 31;
  return packet;
}

std::vector<Beat> AnyPackets::interleaved(std::size_t most) {
  const auto mode = static_cast<OutsideMode>(random_.below(4));
  const auto results =
      has(model::kDerivativesFeature) ? static_cast<Results>(random_.below(2)) : Results::kPosition;
  return interleaved_packet(
      make_stimulus(random_.pick({"corner", "extreme", "random"}), codec_,
                    random_.between(1, std::min<std::size_t>(most, 3)), random_.bits()),
      mode, results);
}

std::vector<Beat> AnyPackets::vertices(int page, std::size_t most) {
  if (!has(model::kResidentFeature)) return interleaved(most);
  if (has(model::kInterleavedFeature) && random_.chance(0.2)) return interleaved(most);
  if (has(model::kGridsFeature) && most > 1 && random_.chance(0.2)) return grid(page);
  if (has(model::kPackedFeature) && random_.chance(0.25)) return packed(page, most);
  PageVertices how = flags(page);
  how.mode = static_cast<OutsideMode>(random_.below(4));
  const bool of_page = has(model::kPagesFeature) && random_.chance(0.8);
  const auto dims = dims_of(of_page ? page : static_cast<int>(newest_));
  auto some = random_vertices(codec_, random_, dims, random_.between(1, most), random_.chance(0.4));
  // Runs that share a cell, t and u.
  for (std::size_t v = 1; v < some.size(); ++v) {
    if (random_.chance(0.5)) continue;
    some[v].cell = some[v - 1].cell;
    for (const int axis : {1, 2}) some[v].local[axis] = some[v - 1].local[axis];
  }
  if (!of_page) return vertices_packet(some, how.mode, how.results);
  how.every = random_.chance(0.3);
  return page_vertices_packet(page, some, how);
}

std::vector<Beat> AnyPackets::overwriting(int page) {
  if (has(model::kPagesFeature)) {
    return random_.chance(0.5) ? page_lattice(page) : page_points(page);
  }
  return functions();
}

std::vector<Beat> AnyPackets::spoil(std::vector<Beat> packet) {
  if (random_.chance(0.6)) return spoiled(std::move(packet), random_);
  auto& words = packet[0].words;
  switch (random_.below(3)) {
    case 0:
      words[0] ^= 0x10000U << random_.below(16);
      break;
    case 1:
      words[2 + random_.below(2)] ^= 1U << random_.below(10);
      break;
    default:
      words[0] = (words[0] & ~0xFF00U) | static_cast<std::uint32_t>(random_.below(8)) << 8;
  }
  return packet;
}

std::vector<Beat> AnyPackets::any(std::size_t most) {
  std::vector<Beat> packet;
  switch (random_.below(8)) {
    case 0:
      packet = functions();
      break;
    case 1:
      packet = lattice();
      break;
    case 2:
      if (has(model::kPagesFeature)) packet = page_points(page());
      break;
    case 3:
      if (has(model::kSpansFeature)) return spans();
      break;
    default:
      break;
  }
  if (packet.empty()) packet = vertices(page(), most);
  return random_.chance(0.25) ? spoil(std::move(packet)) : packet;
}

}  // namespace hwffd::test
