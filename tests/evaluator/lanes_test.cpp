// When units of an evaluator are busy: what its probes show against the latencies of its row.
#include "hwffd/cores/lanes.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/blending.hpp"
#include "hwffd/tb/evaluator_bench.hpp"
#include "hwffd/tb/recorded_lanes.hpp"
#include "named.hpp"

namespace hwffd::test {
namespace {

constexpr std::size_t kVertices = 8;

class EvaluatorLanes : public ::testing::TestWithParam<Configuration> {
 protected:
  /// Of vertices that enter as fast as the row takes them, from a core at rest.
  cores::Schedule recorded() {
    const Configuration& row = GetParam();
    const WordCodec codec(row.format);
    const auto core = cores::make_evaluator_core(row, 1);
    const auto model = model::make_evaluator_model(row);
    const AxisWords bspline = encode(watertight_bspline(codec), codec);
    tb::EvaluatorBench bench(*core, *model, {bspline, bspline, bspline});
    tb::EvaluatorStimulus stimulus = tb::random_stimulus(codec, kVertices, 1);
    for (tb::EvaluatorVertex& vertex : stimulus.vertices) vertex.jacobian = gives_jacobian(row);
    tb::ScheduleRecorder recorder(*core);
    bench.run(stimulus, tb::Throttle::always(), tb::Throttle::always(), &recorder);
    EXPECT_EQ(bench.mismatches(), 0U) << bench.first_mismatch();
    return tb::schedule_of(recorder);
  }

  static std::vector<cores::Lane> lanes_of(const cores::Schedule& schedule) {
    return cores::lanes_of(GetParam(), {1, tb::bench_read_latency(GetParam())}, schedule);
  }
};

// Each vertex passes each unit equally often, and no result comes before the last of them is done.
TEST_P(EvaluatorLanes, EachVertexPassesEachUnit) {
  const cores::Schedule schedule = recorded();
  const std::vector<cores::Lane> lanes = lanes_of(schedule);
  const auto side_by_side = static_cast<std::size_t>(hwffd::lanes(GetParam()));
  const std::size_t shown = (kVertices + side_by_side - 1) / side_by_side;  // by the first of them
  ASSERT_GE(lanes.size(), 4U);
  for (const cores::Lane& lane : lanes) {
    ASSERT_FALSE(lane.spans.empty()) << lane.name;
    EXPECT_EQ(lane.spans.size() % shown, 0U) << lane.name;
    std::uint64_t last = 0;
    for (const cores::Lane::Span& span : lane.spans) {
      EXPECT_LE(last, span.begin) << lane.name;
      EXPECT_LT(span.begin, span.end) << lane.name;
      EXPECT_LE(span.end, schedule.results.back().clock) << lane.name;
      last = span.begin;
    }
  }
}

TEST_P(EvaluatorLanes, AStepThatIsAClockLateDoesNotFit) {
  cores::Schedule schedule = recorded();
  ++schedule.steps.front().clock;
  EXPECT_THROW(lanes_of(schedule), std::logic_error);
}

INSTANTIATE_TEST_SUITE_P(, EvaluatorLanes,
                         ::testing::ValuesIn(rows_where([](const Configuration& row) {
                           return cores::has_evaluator_core(row);
                         })),
                         by_name);

}  // namespace
}  // namespace hwffd::test
