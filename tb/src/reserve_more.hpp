#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace hwffd::tb {

/// Room for `more` elements; at least doubles the capacity, so that many small calls stay cheap.
template <class T>
void reserve_more(std::vector<T>& list, std::size_t more) {
  const std::size_t need = list.size() + more;
  if (need > list.capacity()) list.reserve(std::max(need, 2 * list.capacity()));
}

}  // namespace hwffd::tb
