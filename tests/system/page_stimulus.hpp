#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "hwffd/stream/grid.hpp"
#include "stimulus.hpp"

namespace hwffd::test {

/// What a core with pages or spans has.
struct PageCore {
  std::uint32_t features = 0;
  int axis = kAxisPoints;
  int pages = kPages;
  int spans = 1;
  int grid_limit = kGridLimit;
};

/// A lattice with a fourth component of its own words.
LatticeWords with_fourth(LatticeWords lattice, const WordCodec& codec, tb::Random& random);

/// Makes packets for a core with pages. It remembers which lattice is in which page, so that most
/// packets are good; bad ones may make it wrong about that.
class PagePackets {
 public:
  PagePackets(const WordCodec& codec, tb::Random& random, const PageCore& core)
      : codec_(codec), random_(random), core_(core), lattices_(core.pages) {}

  /// Packets of every opcode in any order, some of them bad.
  std::vector<Beat> any(int packets);
  /// A packet for a page: its lattice, some of its points, or vertices of it.
  std::vector<Beat> any_packet();

 private:
  bool has(std::uint32_t feature) const { return (core_.features & feature) != 0; }
  std::vector<Beat> load(int page);
  std::vector<Beat> points(int page);
  std::vector<Beat> vertices(int page);
  std::vector<Beat> spoil(std::vector<Beat> packet);

  const WordCodec& codec_;
  tb::Random& random_;
  PageCore core_;
  std::vector<LatticeWords> lattices_;  // no points: none
};

}  // namespace hwffd::test
