#pragma once

#include <cstdint>

#include "hwffd/cores/stream_core.hpp"

// What the library of Verilated cores has for the library hwffd of the same version.
extern "C" {

/// HWFFD_VERSION of the library.
__attribute__((visibility("default"))) const char* hwffd_rtl_version();

/// Whether it has the core of that row of the table of configurations.
__attribute__((visibility("default"))) int hwffd_rtl_has(const char* row);

/// A core, its registers at random values drawn from the seed; whoever called deletes it. Null
/// where there is none.
__attribute__((visibility("default"))) hwffd::cores::StreamCore* hwffd_rtl_make(const char* row,
                                                                                std::uint64_t seed);

/// The same of a core that adds gradients up, of grids by rows or not.
__attribute__((visibility("default"))) hwffd::cores::StreamCore* hwffd_rtl_make_scatter(
    int rows, std::uint64_t seed);

}  // extern "C"
