// The bench allocates nothing while the clock runs.
#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

#include "hwffd/tb/stream_bench.hpp"
#include "loopback_core.hpp"

namespace {
std::size_t allocations = 0;
}

// Not inlined, one without the other: the compiler would see malloc() and delete, or new and
// free().
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  void* memory = std::malloc(size == 0 ? 1 : size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace hwffd::tb {
namespace {

TEST(Allocation, NoneWhileTheClockRuns) {
  for (const std::string& throttle : throttle_names()) {
    LoopbackCore core(5);
    StreamBench bench(core, throttled(throttle, throttle));
    loop_back(bench, 1, random_beats(20'000, 1));
    const std::size_t before = allocations;
    EXPECT_GT(before, 0u);
    EXPECT_TRUE(bench.run());
    EXPECT_EQ(allocations, before) << throttle;
    EXPECT_TRUE(bench.finish()) << bench.report();
    EXPECT_EQ(bench.scoreboard().checked(), 20'000u);
  }
}

}  // namespace
}  // namespace hwffd::tb
