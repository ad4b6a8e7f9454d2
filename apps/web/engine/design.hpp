#pragma once

#include <string>
#include <vector>

#include "hwffd/model/configuration.hpp"

namespace hwffd::web {

/// A block of the drawing of a core (blocks.csv).
struct Block {
  std::string id;
  std::string title;
  std::string module;
  std::string busy;  ///< signals, or lanes of the timeline
};

/// What design.py found in a row's elaborated design.
struct Design {
  std::string row;
  int evaluators;             ///< of polynomials
  std::vector<Block> blocks;  ///< in the order of the drawing
};

/// A signal whose waveform can be seen (ports.csv).
struct Port {
  std::string name;
  std::string signal;
  std::string description;
};

/// Those of all rows of the page; made by design.py.
const std::vector<Design>& designs();
const std::vector<Port>& ports();

/// That of a row. Throws std::invalid_argument where there is none.
const Design& design_of(const Configuration& row);

/// Clocks from a read to its points: READ_LATENCY of rtl/top/hwffd_stream.v.
int read_latency_of(const Configuration& row);

}  // namespace hwffd::web
