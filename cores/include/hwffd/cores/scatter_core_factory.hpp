#pragma once

#include <cstdint>
#include <memory>

#include "hwffd/cores/stream_core.hpp"

namespace hwffd::cores {

/// The row whose weights the two Verilated `hwffd_scatter` of a build have. Both keep kPages pages:
/// that of vertices of up to kAxisPoints points an axis, that of grids by rows (ROWS 1) of more.
constexpr const char* kScatterRow = "affine-fx17-overlapped";
constexpr int kScatterRowsAxis = 32;

/// Whether this build has them.
bool has_scatter_core();

/// One, its registers at random values drawn from the seed.
/// @throws std::invalid_argument where there is none
std::unique_ptr<StreamCore> make_scatter_core(bool rows, std::uint64_t seed);

}  // namespace hwffd::cores
