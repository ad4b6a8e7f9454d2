#include "hwffd/stream/resident_pages.hpp"

#include <algorithm>
#include <stdexcept>

namespace hwffd {
namespace {

constexpr int kMostPages = 256;

bool same(const LatticePage& a, const LatticePage& b, bool origins) {
  return a.lattice.dims == b.lattice.dims && a.lattice.exponent == b.lattice.exponent &&
         (!origins || a.origin == b.origin) && a.lattice.points == b.lattice.points &&
         a.lattice.fourth == b.lattice.fourth;
}

/// The vertices of page `order[0]`, then those of `order[1]` and so on.
void reorder(PagedVertices& vertices, const std::vector<std::size_t>& order) {
  std::vector<std::size_t> begin(vertices.of_page.size());
  std::size_t end = 0;
  for (std::size_t p = 0; p < begin.size(); ++p) {
    begin[p] = end;
    end += vertices.of_page[p].size();
  }
  std::vector<std::size_t> from;
  from.reserve(end);
  for (const std::size_t p : order) {
    const auto first = vertices.from.begin() + static_cast<std::ptrdiff_t>(begin[p]);
    from.insert(from.end(), first, first + static_cast<std::ptrdiff_t>(vertices.of_page[p].size()));
  }
  vertices.from = std::move(from);
  vertices.sent = order;
}

}  // namespace

ResidentPages::ResidentPages(const PointStore& store) : store_(store) {
  if (store.pages < 1 || store.pages > kMostPages) {
    throw std::invalid_argument("a core keeps 1 to 256 pages");
  }
  slots_.resize(static_cast<std::size_t>(store.pages));
}

void ResidentPages::forget() { std::fill(slots_.begin(), slots_.end(), Slot{}); }

ResidentPages::Slot* ResidentPages::find(const LatticePage& page) {
  const auto it = std::find_if(slots_.begin(), slots_.end(), [&](const Slot& slot) {
    return !slot.page.lattice.points.empty() && same(slot.page, page, store_.spans);
  });
  return it == slots_.end() ? nullptr : &*it;
}

ResidentPages::Slot& ResidentPages::oldest() {
  return *std::min_element(slots_.begin(), slots_.end(),
                           [](const Slot& a, const Slot& b) { return a.used < b.used; });
}

std::vector<Beat> ResidentPages::packets(const std::vector<LatticePage>& pages,
                                         PagedVertices& vertices, OutsideMode mode,
                                         Results results) {
  std::vector<std::size_t> order;
  for (const bool there : {true, false}) {
    for (std::size_t p = 0; p < pages.size(); ++p) {
      if (vertices.of_page.at(p).empty()) continue;
      if ((find(pages[p]) != nullptr) == there) order.push_back(p);
    }
  }
  std::vector<Beat> beats;
  for (const std::size_t p : order) {
    const LatticePage& page = pages[p];
    Slot* slot = find(page);
    if (slot == nullptr) {
      slot = &oldest();
      slot->page = page;
      ++loads_;
      const auto number = static_cast<int>(slot - slots_.data());
      append(beats, store_.spans ? page_packet(number, page.lattice, page.origin)
                                 : page_packet(number, page.lattice));
    }
    slot->used = ++now_;
    PageVertices how;
    how.mode = mode;
    how.results = results;
    how.large = is_large(page.lattice);
    const auto number = static_cast<int>(slot - slots_.data());
    for (const auto& some : in_packets(vertices.of_page[p])) {
      append(beats, page_vertices_packet(number, some, how));
    }
  }
  reorder(vertices, order);
  return beats;
}

}  // namespace hwffd
