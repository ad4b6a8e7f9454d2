#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <string>

#include "event_run.hpp"
#include "scatter_builds.hpp"

namespace hwffd::test {

/// Such a core, its model and the bench between them.
class ScatterRun : public EventRun<model::ScatterStreamModel> {
 public:
  ScatterRun(const ScatterBuild& build, std::uint64_t seed, const std::string& source = "always",
             const std::string& sink = "always")
      : EventRun(build, build.row.format, seed, source, sink, build.row, build.axis, build.pages,
                 build.rows) {}

  /// To the end: every bit of every result, and every event. Places are those of the model but for
  /// events that have none (`has_place`): of those numbers are compared.
  ::testing::AssertionResult run();
};

}  // namespace hwffd::test
