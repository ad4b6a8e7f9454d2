#pragma once

#include <vector>

#include "expand_stimulus.hpp"
#include "span_stimulus.hpp"

namespace hwffd::test {

/// Packets of every kind for any core, good and bad. It remembers which lattice lies where, so that
/// most vertices have one; a bad packet may make it wrong about that.
class AnyPackets {
 public:
  AnyPackets(const WordCodec& codec, tb::Random& random, const PageCore& core)
      : codec_(codec), random_(random), core_(core), lattices_(core.pages) {}

  /// Functions of all axes, with derivatives where the core has them: the B-spline, or any.
  std::vector<Beat> functions();
  /// Functions of some spans, in a core that has spans.
  std::vector<Beat> spans();
  /// A lattice, in a page where the core has pages.
  std::vector<Beat> lattice();
  /// Good vertices of a page, at most so many, in any form that the core has; or a grid, where that
  /// is more than one.
  std::vector<Beat> vertices(int page, std::size_t most);
  /// A good packet that overwrites what vertices of a page read.
  std::vector<Beat> overwriting(int page);
  /// Any packet with at most so many vertices, one in four with something wrong.
  std::vector<Beat> any(std::size_t most);

  /// A page, now and then one beyond the last; 0 in a core without pages.
  int page();
  bool has(std::uint32_t feature) const { return (core_.features & feature) != 0; }

 private:
  LatticeWords fresh(const std::array<int, 3>& dims);
  std::array<int, 3> dims_of(int page) const;
  PageVertices flags(int page);
  std::vector<Beat> resident_lattice();
  std::vector<Beat> page_lattice(int page);
  std::vector<Beat> page_points(int page);
  std::vector<Beat> grid(int page);
  std::vector<Beat> packed(int page, std::size_t most);
  std::vector<Beat> interleaved(std::size_t most);
  std::vector<Beat> spoil(std::vector<Beat> packet);

  const WordCodec& codec_;
  tb::Random& random_;
  PageCore core_;
  std::vector<LatticeWords> lattices_;  // of each page; no points: none
  std::size_t newest_ = 0;              // the page that opcode 2 filled last
};

}  // namespace hwffd::test
