#include "hwffd/stream/resident_pages.hpp"

#include <algorithm>
#include <stdexcept>

namespace hwffd {
namespace {

constexpr int kMostPages = 256;

bool same(const LatticePage& one, const LatticePage& other, bool origins) {
  return one.lattice.dims == other.lattice.dims && one.lattice.exponent == other.lattice.exponent &&
         (!origins || one.origin == other.origin) && one.lattice.points == other.lattice.points &&
         one.lattice.fourth == other.lattice.fourth;
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
  kept_.resize(static_cast<std::size_t>(store.pages));
}

void ResidentPages::forget() { std::fill(kept_.begin(), kept_.end(), Kept{}); }

ResidentPages::Kept* ResidentPages::find(const LatticePage& page) {
  const auto at = std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) {
    return !kept.page.lattice.points.empty() && same(kept.page, page, store_.spans);
  });
  return at == kept_.end() ? nullptr : &*at;
}

ResidentPages::Kept& ResidentPages::oldest() {
  return *std::min_element(kept_.begin(), kept_.end(), [](const Kept& one, const Kept& other) {
    return one.used < other.used;
  });
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
    Kept* kept = find(page);
    if (kept == nullptr) {
      kept = &oldest();
      kept->page = page;
      ++loads_;
      const auto number = static_cast<int>(kept - kept_.data());
      append(beats, store_.spans ? page_packet(number, page.lattice, page.origin)
                                 : page_packet(number, page.lattice));
    }
    kept->used = ++now_;
    PageVertices how;
    how.mode = mode;
    how.results = results;
    how.large = is_large(page.lattice);
    const auto number = static_cast<int>(kept - kept_.data());
    for (const auto& some : in_packets(vertices.of_page[p])) {
      append(beats, page_vertices_packet(number, some, how));
    }
  }
  reorder(vertices, order);
  return beats;
}

}  // namespace hwffd
