#pragma once

#include <cstdint>
#include <memory>

#include "hwffd/cores/stream_core.hpp"

namespace hwffd::cores {

/// The row whose weights the Verilated `hwffd_scatter` of a build has. It keeps kPages pages of up
/// to kAxisPoints points an axis.
constexpr const char* kScatterRow = "affine-fx17-overlapped";

/// Whether this build has it.
bool has_scatter_core();

/// It, its registers at random values drawn from the seed.
/// @throws std::invalid_argument where there is none
std::unique_ptr<StreamCore> make_scatter_core(std::uint64_t seed);

}  // namespace hwffd::cores
