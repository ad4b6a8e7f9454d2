#pragma once

#include <cstddef>
#include <vector>

#include "hwffd/stream/large_lattice.hpp"

namespace hwffd {

/// What a core keeps of lattices, as its parameters or registers say it.
struct PointStore {
  int axis_points = kAxisPoints;  ///< most points an axis of a lattice, AXIS
  int pages = 0;                  ///< behind opcodes 5 to 7, PAGES; 0: it has opcodes 2 and 3 only
  bool spans = false;             ///< pages have origins, which choose spans
};

/// Knows which lattices lie in the pages of a core, so that none is sent twice.
///
/// A batch of vertices, sorted by page, first takes the pages that are there already. Each of the
/// others is loaded into the page that was used longest ago, while vertices of others are still
/// inside. So a batch of P pages loads P of them the first time, and P less those that the core
/// keeps when it comes again.
class ResidentPages {
 public:
  /// @throws std::invalid_argument for a core without pages, or with more than 256
  explicit ResidentPages(const PointStore& store);

  /// Packets of opcodes 5 and 7 for all vertices, and what a core makes of them is remembered.
  /// @param pages     of `pages_of` with the store's `axis_points`
  /// @param vertices  of `by_page` of the same lattice; afterwards in the order in which they are
  ///   sent, for `in_order`
  std::vector<Beat> packets(const std::vector<LatticePage>& pages, PagedVertices& vertices,
                            OutsideMode mode = OutsideMode::kClamp,
                            Results results = Results::kPosition);
  /// After a reset of the core, or packets of other origin.
  void forget();
  /// Lattices sent so far.
  std::size_t loads() const { return loads_; }

 private:
  struct Slot {
    LatticePage page;      // no points: none
    std::size_t used = 0;  // when, in packets of vertices
  };

  Slot* find(const LatticePage& page);
  Slot& oldest();

  PointStore store_;
  std::vector<Slot> slots_;
  std::size_t now_ = 0;
  std::size_t loads_ = 0;
};

}  // namespace hwffd
