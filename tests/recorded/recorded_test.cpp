// Recorded streams in every row of tier `test`: RTL and model give what was recorded, so that the
// two cannot change together unseen.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "hwffd/cores/evaluator_core_factory.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/tb/evaluator_bench.hpp"
#include "replay.hpp"
#include "system_run.hpp"

namespace hwffd::test {
namespace {

class Recorded : public PerConfiguration {
 protected:
  std::vector<Beat> stream(const std::string& kind) const {
    return read_recorded_stream(kind, GetParam().format);
  }
};
class RecordedStream : public Recorded {};

/// What the table of a kind says of a row; a row that it lacks has no hash to meet.
Recording recorded(const std::string& kind, const Configuration& row) {
  for (const Recording& recording : read_table(table_path(kind))) {
    if (recording.row == row.name) return recording;
  }
  return {};
}

/// A build of all tiers has rows, and formats, that are not recorded.
std::vector<Configuration> recorded_and_built() {
  std::vector<Configuration> rows = recorded_rows();
  rows.erase(std::remove_if(rows.begin(), rows.end(), std::not_fn(cores::has_stream_core)),
             rows.end());
  return rows;
}

void expect_equal(const Recording& got, const Recording& recorded) {
  EXPECT_EQ(got.row, recorded.row);
  EXPECT_GT(got.results, 0U);
  EXPECT_EQ(got.results, recorded.results);
  EXPECT_EQ(got.events, recorded.events);
  EXPECT_EQ(got.hash, recorded.hash) << std::hex << got.hash << " instead of " << recorded.hash;
}

TEST_P(Recorded, ModelAnswersCommandsAsEver) {
  expect_equal(model_answers(GetParam(), stream("commands")), recorded("commands", GetParam()));
}

TEST_P(Recorded, ModelAnswersAtItsReadPortAsEver) {
  expect_equal(model_answers_at_read_port(GetParam(), stream("read_port")),
               recorded("read_port", GetParam()));
}

TEST_P(Recorded, CoreAnswersAtItsReadPortAsEver) {
  if (!cores::has_evaluator_core(GetParam())) GTEST_SKIP() << "not Verilated in this build";
  const auto core = cores::make_evaluator_core(GetParam(), 1);
  const auto model = model::make_evaluator_model(GetParam());
  const ReadPortRecording recording = read_port_recording(stream("read_port"));
  tb::EvaluatorBench bench(*core, *model, recording.banks[0]);
  bench.load(1, recording.banks[1]);
  bench.run(recording.stimulus, tb::make_throttle("bernoulli", 1), tb::make_throttle("bursts", 2));
  EXPECT_EQ(bench.mismatches(), 0U) << bench.first_mismatch();
  expect_equal(answers_of(GetParam(), bench.results()), recorded("read_port", GetParam()));
}

TEST_P(RecordedStream, CoreAnswersCommandsAsEver) {
  SystemRun run(GetParam(), 1, "bursts", "bernoulli");
  run.send(stream("commands"));
  ASSERT_TRUE(run.run());
  Recording got;
  got.row = GetParam().name;
  got.results = run.bench().results().size();
  got.hash = hash_of(run.bench().results());
  got.events = recorded_events(run.bench().events());
  expect_equal(got, recorded("commands", GetParam()));
}

// The streams ask for everything: each event occurs, each status is seen, both banks are used.
TEST(Recordings, HaveEveryRowAndEveryEvent) {
  for (const char* kind : {"commands", "read_port"}) {
    std::set<std::string> rows;
    for (const Recording& recording : read_table(table_path(kind))) rows.insert(recording.row);
    for (const Configuration& row : recorded_rows())
      EXPECT_EQ(rows.count(row.name), 1U) << row.name;
  }
  RecordedEvents events{};
  for (const Recording& recording : read_table(table_path("commands"))) {
    for (std::size_t e = 0; e < events.size(); ++e) events[e] += recording.events[e];
  }
  for (std::size_t e = 0; e < events.size(); ++e) EXPECT_GT(events[e], 0U) << "event " << e;
}

TEST(Recordings, OneBitOfOneResultChangesTheHash) {
  const std::vector<Beat> beats(3, Beat{{1, 2, 3, 4}, false});
  const std::uint64_t hash = hash_of(beats);
  for (std::size_t beat = 0; beat < beats.size(); ++beat) {
    std::vector<Beat> changed = beats;
    changed[beat].last = true;
    EXPECT_NE(hash_of(changed), hash);
    for (int bit = 0; bit < 128; ++bit) {
      changed = beats;
      changed[beat].words[bit / 32] ^= 1U << bit % 32;
      EXPECT_NE(hash_of(changed), hash) << "beat " << beat << " bit " << bit;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(, Recorded, ::testing::ValuesIn(recorded_rows()), by_name);
INSTANTIATE_TEST_SUITE_P(, RecordedStream, ::testing::ValuesIn(recorded_and_built()), by_name);

}  // namespace
}  // namespace hwffd::test
