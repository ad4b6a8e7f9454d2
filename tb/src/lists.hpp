#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace hwffd::tb {

/// Room for `more` elements; at least doubles the capacity, so that many small calls stay cheap.
template <class T>
void reserve_more(std::vector<T>& list, std::size_t more) {
  const std::size_t need = list.size() + more;
  if (need > list.capacity()) list.reserve(std::max(need, 2 * list.capacity()));
}

/// Appends to a queue, which forgets the elements before `next` here and not one by one while the
/// clock runs.
template <class T>
void refill(std::vector<T>& queue, std::size_t& next, std::vector<T> more) {
  queue.erase(queue.begin(), queue.begin() + static_cast<std::ptrdiff_t>(next));
  next = 0;
  if (queue.empty()) {
    queue = std::move(more);
  } else {
    queue.insert(queue.end(), more.begin(), more.end());
  }
}

}  // namespace hwffd::tb
