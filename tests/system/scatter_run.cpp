#include "scatter_run.hpp"

namespace hwffd::test {

::testing::AssertionResult ScatterRun::run() {
  if (const auto finished = finish(); !finished) return finished;
  const EventTally got = tally(events(), has_place);
  const EventTally expected = tally(model().events(), has_place);
  if (const auto same = same_events(got.placed, expected.placed); !same) return same;
  return as_often(got.others, expected.others, expected.others[event::kSaturated]);
}

}  // namespace hwffd::test
