#pragma once

#include <memory>
#include <string>

#include "Vaxi_marks.h"
#include "axi_run.hpp"
#include "hwffd/cores/verilated_axi_core.hpp"

namespace hwffd::test {

/// What the core axi_marks of CMakeLists.txt has.
inline PageCore marks_core() {
  PageCore core;
  core.features =
      model::kAllFeatures | model::kPagesFeature | model::kMarksFeature | model::kGridsFeature;
  core.grid_limit = 10;
  return core;
}

inline AxiRun marks_run(const std::string& throttles, std::uint64_t seed = 1) {
  return {find_configuration("basic-fx18-overlapped"),
          std::make_unique<cores::VerilatedAxiCore<Vaxi_marks>>(seed), seed, throttles,
          marks_core()};
}

}  // namespace hwffd::test
