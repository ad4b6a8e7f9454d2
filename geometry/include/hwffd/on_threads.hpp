#pragma once

#include <cstddef>
#include <functional>

namespace hwffd {

/// How many threads work is spread over: as many as there are cores, unless set_thread_count() said
/// otherwise. No result depends on it.
std::size_t thread_count();
/// @param count  0: as many as there are cores. Holds for all of the program.
void set_thread_count(std::size_t count);

/// Calls `work` with 0 to count - 1 on thread_count() threads, and on the calling thread `progress`
/// with the number done whenever that has grown, at last with count. Throws what the first call
/// that threw threw, and what a Watch of the calling thread throws, which looks at the end too; no
/// further work is begun then, and work under way ends where it looks. What `work` spreads itself
/// runs on its own thread.
void on_threads(
    std::size_t count, const std::function<void(std::size_t)>& work,
    const std::function<void(std::size_t done)>& progress = [](std::size_t) {});

/// Calls `work` with the ranges [first, end) of `size` numbers each that [0, count) falls into, the
/// last of them shorter, as on_threads() does. Where the ranges lie depends on `count` and `size`
/// alone.
void on_ranges(std::size_t count, std::size_t size,
               const std::function<void(std::size_t first, std::size_t end)>& work);

/// While it lives, work that this thread began and what evaluates for it look every 50 ms whether
/// to go on: they call `check`, and what that throws ends them. For programs that can be
/// interrupted.
class Watch {
 public:
  explicit Watch(std::function<void()> check);
  ~Watch();
  Watch(const Watch&) = delete;
  Watch& operator=(const Watch&) = delete;

  /// Calls the check of this thread's last Watch, if it has one and was not looked at for 50 ms.
  static void look();

 private:
  std::function<void()> check_;
  Watch* outer_;
};

}  // namespace hwffd
