#pragma once

#include <cstdint>
#include <string>

#include "hwffd/device/device.hpp"
#include "hwffd/model/configuration.hpp"

namespace hwffd {

/// What the model gives of a grid.
struct ModelGrid {
  Points positions;
  std::uint64_t saturated = 0;  ///< vertices beyond what fixed point holds
};

/// A grid on the bit-true model of a row that contracts one axis after the other (schedule.hpp): by
/// a GridWalker, whose rows are spread over threads (on_threads.hpp). No stream goes between, so
/// the lattice is taken whole. Bits are those of a stream with the grid's places, by pages or not.
/// @param grid  fits the lattice
/// @param device  its name, for messages
/// @throws Error as function_words()
ModelGrid evaluate_on_model(const Configuration& row, const std::string& device,
                            const Lattice& lattice, const Grid& grid,
                            const Device::Blending& blending, const Progress& progress);

}  // namespace hwffd
