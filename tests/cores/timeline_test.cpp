// The units of an organization and when they are busy, of a step alone, as its row's latencies say.
// tests/evaluator/lanes_test.cpp has the probes of the RTL, of the rows that a build has.
#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "hwffd/cores/lanes.hpp"

namespace hwffd::test {
namespace {

/// What the probes show of one step, and what follows.
struct Shown {
  const char* row;
  std::uint64_t polynomial;
  std::optional<std::uint64_t> combination;  ///< where there is a generator of these
  std::uint64_t step, sum, result;
  std::vector<std::string> lanes;  ///< when each begins and ends, and its name
};
void PrintTo(const Shown& shown, std::ostream* out) { *out << shown.row; }

cores::Schedule schedule_of(const Shown& shown) {
  cores::Schedule schedule;
  schedule.polynomials = {{shown.polynomial, 0}};
  if (shown.combination) schedule.combinations = {{*shown.combination, 0}};
  schedule.steps = {{shown.step, 0}};
  schedule.sums = {shown.sum};
  schedule.results = {{shown.result, 0}};
  schedule.end = shown.result + 1;
  return schedule;
}

class Lanes : public ::testing::TestWithParam<Shown> {
 protected:
  static std::vector<cores::Lane> of(const cores::Schedule& schedule) {
    return cores::lanes_of(find_configuration(GetParam().row), {1, 2}, schedule);
  }
};

TEST_P(Lanes, AStepPassesUnitAfterUnit) {
  std::vector<std::string> lanes;
  for (const cores::Lane& lane : of(schedule_of(GetParam()))) {
    ASSERT_EQ(lane.spans.size(), 1U) << lane.name;
    const cores::Lane::Span& span = lane.spans.front();
    lanes.push_back(std::to_string(span.begin) + " " + std::to_string(span.end) + " " + lane.name);
  }
  EXPECT_EQ(lanes, GetParam().lanes);
}

TEST_P(Lanes, AProbeThatIsAClockLateDoesNotFit) {
  cores::Schedule late = schedule_of(GetParam());
  ++late.steps.front().clock;
  EXPECT_THROW(of(late), std::logic_error);
}

const Shown kShown[] = {
    {"cg1-fx18-overlapped",
     4,
     53,
     54,
     60,
     124,
     {"4 19 1 polynomial evaluator", "53 54 combination generator", "54 56 weight products B B",
      "56 58 weight products (BB) B", "58 60 3 products (BBB) P", "60 61 3 accumulators"}},
    {"tree8-fx18-overlapped",
     2,
     std::nullopt,
     13,
     22,
     30,
     {"2 13 1 polynomial evaluator", "13 15 weight products B B", "15 17 weight products (BB) B",
      "17 19 24 products (BBB) P", "19 20 12 adders of the tree", "20 21 6 adders of the tree",
      "21 22 3 adders of the tree", "22 23 3 accumulators"}},
    {"parallel-fx18-overlapped",
     1,
     std::nullopt,
     12,
     24,
     24,
     {"1 12 1 polynomial evaluator", "12 14 weight products B B", "14 16 weight products (BB) B",
      "16 18 192 products (BBB) P", "18 19 96 adders of the tree", "19 20 48 adders of the tree",
      "20 21 24 adders of the tree", "21 22 12 adders of the tree", "22 23 6 adders of the tree",
      "23 24 3 adders of the tree"}},
    {"tree4-fp32-paper-fmac",
     2,
     std::nullopt,
     5,
     10,
     131,
     {"2 5 1 polynomial evaluator", "5 6 weight products B B", "6 7 weight products (BB) B",
      "7 8 6 products (BBB) P", "8 9 6 multiply-adds of the tree", "9 10 3 adders of the tree",
      "10 11 3 accumulators"}},
    {"basic-fp32-paper-fmac",
     2,
     std::nullopt,
     5,
     7,
     7,
     {"2 5 1 polynomial evaluator", "5 6 weight products B B", "6 7 weight products (BB) B",
      "7 8 3 accumulators"}},
    {"factored3-fx18-overlapped",
     1,
     std::nullopt,
     17,
     40,
     42,
     {"1 2 axis chosen", "2 19 1 polynomial evaluator", "17 19 32 points read",
      "19 23 64 products along u", "23 24 32 adders along u", "24 25 16 adders along u",
      "25 26 narrowed", "26 30 16 products along t", "30 31 8 adders along t",
      "31 32 4 adders along t", "32 33 narrowed", "33 34 the half read first waits",
      "34 38 4 products along s", "38 39 2 adders along s", "39 40 1 adder along s"}},
    {"jacobian3-fx17-overlapped",
     1,
     std::nullopt,
     16,
     42,
     44,
     {"1 2 axis chosen", "2 19 1 polynomial evaluator", "16 18 32 points read",
      "18 19 48 differences along u", "19 23 96 products along u", "23 24 64 adders along u",
      "24 25 32 adders along u", "25 26 narrowed", "26 27 24 differences along t",
      "27 31 36 products along t", "31 32 24 adders along t", "32 33 12 adders along t",
      "33 34 narrowed", "34 35 the half read first waits", "35 36 9 differences along s",
      "36 40 12 products along s", "40 41 8 adders along s", "41 42 4 adders along s"}},
    {"walk-fx17-overlapped",
     4,
     std::nullopt,
     19,
     39,
     61,
     {"4 5 axis chosen", "5 22 3 polynomials of u and t", "19 21 4 points read",
      "21 22 9 differences along u", "22 26 9 products along u", "26 27 6 adders along u",
      "27 28 3 adders along u", "28 29 narrowed", "29 30 3 differences along t",
      "30 34 3 products along t", "34 35 3 adders along t", "35 36 3 adders along t",
      "38 55 3 polynomials of s", "54 55 9 differences along s", "55 59 9 products along s",
      "59 60 6 adders along s", "60 61 3 adders along s"}},
};

INSTANTIATE_TEST_SUITE_P(, Lanes, ::testing::ValuesIn(kShown), [](const auto& info) {
  std::string name = info.param.row;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace hwffd::test
