#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

#include "event_run.hpp"
#include "page_stimulus.hpp"

namespace hwffd::test {

/// A core of cores.csv.
struct PageBuild : BuiltCore {
  const char* row;
  PageCore core;
};

/// Those of the program, which CMake makes of the table, or some of them.
std::vector<PageBuild> page_builds(bool (*wanted)(const PageBuild&) = [](const PageBuild&) {
  return true;
});

/// Such a core, its model and the bench between them.
class PageRun : public EventRun<model::StreamModel> {
 public:
  PageRun(const PageBuild& build, std::uint64_t seed, const std::string& source = "always",
          const std::string& sink = "always")
      : EventRun(build, find_configuration(build.row).format, seed, source, sink,
                 find_configuration(build.row), build.core.features, build.core.axis,
                 build.core.pages, build.core.spans, build.core.grid_limit),
        build_(build) {}

  void send_bspline(Functions functions = Functions::kBlending) {
    send(coefficients_packet(watertight_bspline(codec()), codec(), functions));
  }
  /// To the end: every bit of every result, and how often each event came.
  ::testing::AssertionResult run() {
    if (const auto finished = finish(); !finished) return finished;
    return as_often(bench().events(), model().events(), 0);
  }

  /// What the model makes of beats that no core was sent.
  std::vector<Beat> model_of(const std::vector<Beat>& beats) { return model().run(beats); }

  const Configuration& row() const { return find_configuration(build_.row); }

 protected:
  PageBuild build_;
};

}  // namespace hwffd::test
