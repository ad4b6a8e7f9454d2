#pragma once

#include <cstddef>
#include <functional>

namespace hwffd {

/// Calls `work` with 0 to count - 1 on as many threads as there are cores, and `progress` with the
/// number done after each, one thread at a time. Throws what the first call that threw threw.
void on_threads(
    std::size_t count, const std::function<void(std::size_t)>& work,
    const std::function<void(std::size_t done)>& progress = [](std::size_t) {});

}  // namespace hwffd
