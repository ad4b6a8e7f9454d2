// The cores of a library that is loaded: those of this version, else none. Compiled for each of
// what may lie there; HWFFD_IS_THERE says whether it is the one.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "hwffd/cores/scatter_core_factory.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "stream_core_exports.hpp"

namespace hwffd::cores {
namespace {

/// Some row that has a core, or any.
const Configuration& some_row() {
  const auto it = std::find_if(configurations().begin(), configurations().end(), has_stream_core);
  return it == configurations().end() ? configurations().front() : *it;
}

TEST(LoadedCores, AreThoseOfThisVersion) {
  EXPECT_EQ(has_stream_core(some_row()), HWFFD_IS_THERE == 1);
  EXPECT_FALSE(stream_cores_can_trace());
  EXPECT_EQ(has_scatter_core(), HWFFD_IS_THERE == 1);
}

TEST(LoadedCores, NoneIsMadeWithAWaveformOrOfAnotherRow) {
  EXPECT_THROW(make_stream_core(some_row(), 1, "wave.fst"), std::invalid_argument);
  for (const Configuration& row : configurations()) {
    if (has_stream_core(row)) continue;
    EXPECT_THROW(make_stream_core(row, 1), std::invalid_argument) << row.name;
  }
}

#if !HWFFD_IS_THERE
TEST(LoadedCores, NoneAddsGradientsUp) {
  EXPECT_THROW(make_scatter_core(false, 1), std::invalid_argument);
}
#endif

#if HWFFD_IS_THERE
TEST(LoadedCores, Run) {
  const std::unique_ptr<StreamCore> core = make_stream_core(some_row(), 1);
  for (int clocks = 0; clocks < 4; ++clocks) {
    core->drive_reset(clocks < 2);
    core->settle();
    core->clock();
  }
  EXPECT_TRUE(core->idle());
  EXPECT_FALSE(core->output_valid());
}

TEST(LoadedCores, TwoAddGradientsUp) {
  for (const bool rows : {false, true}) {
    const std::unique_ptr<StreamCore> core = make_scatter_core(rows, 1);
    int clocks = 0;
    for (; clocks < 4 || (!core->idle() && clocks < 10'000); ++clocks) {
      core->drive_reset(clocks < 2);
      core->settle();
      core->clock();
    }
    EXPECT_GT(clocks, 200) << "a sweep comes first";
    EXPECT_TRUE(core->idle());
    EXPECT_FALSE(core->output_valid());
  }
}

/// What it exports tells nothing by exceptions.
TEST(LoadedCores, OfNoRow) {
  void* const library = dlopen(HWFFD_RTL_LIBRARY, RTLD_NOW | RTLD_LOCAL);
  ASSERT_NE(library, nullptr) << dlerror();
  const auto has = reinterpret_cast<decltype(&hwffd_rtl_has)>(dlsym(library, "hwffd_rtl_has"));
  const auto make = reinterpret_cast<decltype(&hwffd_rtl_make)>(dlsym(library, "hwffd_rtl_make"));
  EXPECT_EQ(has("no-such-row"), 0);
  EXPECT_EQ(make("no-such-row", 1), nullptr);
  dlclose(library);
}
#endif

}  // namespace
}  // namespace hwffd::cores
