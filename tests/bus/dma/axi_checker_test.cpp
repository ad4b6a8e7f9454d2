// The checker itself: good traffic breaks no rule, faulty traffic exactly the one it should.
#include "hwffd/tb/axi_checker.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <vector>

#include "named.hpp"

namespace hwffd::tb {
namespace {

/// A conversation, a cycle an entry: one read of 2 beats, one write of 2 beats.
std::vector<cores::AxiPins> good_traffic() {
  std::vector<cores::AxiPins> cycles(10);
  for (cores::AxiPins& pins : cycles) pins.r.ready = pins.b.ready = true;
  for (std::size_t i : {1, 2}) {  // waits a cycle
    cycles[i].ar = {true, i == 2, 0x1fe0, 1};
    cycles[i].aw = {true, i == 2, 0x2fe0, 1};
  }
  for (std::size_t i : {2, 3, 4}) {  // the first beat waits a cycle
    cycles[i].w.valid = true;
    cycles[i].w.ready = i != 2;
    cycles[i].w.last = i == 4;
    cycles[i].w.data[0] = i == 4;
  }
  for (std::size_t i : {4, 6}) {
    cycles[i].r.valid = true;
    cycles[i].r.last = i == 6;
  }
  cycles[7].b.valid = true;
  return cycles;
}

AxiChecker check(const std::vector<cores::AxiPins>& cycles, const AxiChecker::Limits& limits = {},
                 bool hardened = false, bool soft_reset = false) {
  AxiChecker checker;
  checker.set_hardened(hardened);
  checker.allow_ready_to_fall(soft_reset);
  checker.set_limits(limits);
  for (std::size_t i = 0; i < cycles.size(); ++i) checker.observe(cycles[i], i, false);
  checker.finish(cycles.size());
  return checker;
}

using Cycles = std::vector<cores::AxiPins>;

struct Flaw {
  const char* name;
  AxiRule rule;
  std::function<void(Cycles&)> plant;
};
void PrintTo(const Flaw& flaw, std::ostream* out) { *out << flaw.name; }

const Flaw kFlaws[] = {
    {"ArFalls", AxiRule::kStable,
     [](Cycles& c) {
       c[3].ar = c[2].ar;
       c[2].ar = {};
     }},
    {"ArChanges", AxiRule::kStable, [](Cycles& c) { c[1].ar.address = 0x1fc0; }},
    {"AwLengthChanges", AxiRule::kStable, [](Cycles& c) { c[1].aw.len = 0; }},
    {"WChanges", AxiRule::kStable, [](Cycles& c) { c[2].w.data[3] = 1; }},
    {"RChanges", AxiRule::kStable,
     [](Cycles& c) {
       for (std::size_t i : {0, 1, 2, 3, 4}) c[i].r.ready = false;
       c[5].r = c[4].r;
       c[5].r.ready = true;
       c[5].r.data[1] = 1;
     }},
    {"BFalls", AxiRule::kStable,
     [](Cycles& c) {
       for (cores::AxiPins& pins : c) pins.b.ready = false;
       c[9].b.ready = c[9].b.valid = true;
     }},
    {"NarrowRead", AxiRule::kShape, [](Cycles& c) { c[1].ar.size = c[2].ar.size = 3; }},
    {"WrappingWrite", AxiRule::kShape, [](Cycles& c) { c[1].aw.burst = c[2].aw.burst = 2; }},
    {"Strobe", AxiRule::kShape, [](Cycles& c) { c[4].w.strobe = 0x7fff; }},
    {"Misaligned", AxiRule::kAligned,
     [](Cycles& c) { c[1].ar.address = c[2].ar.address = 0x1f88; }},
    {"CrossesReading", AxiRule::kBoundary,
     [](Cycles& c) { c[1].ar.address = c[2].ar.address = 0x1ff0; }},
    {"CrossesWriting", AxiRule::kBoundary,
     [](Cycles& c) { c[1].aw.address = c[2].aw.address = 0x2ff0; }},
    {"WlastEarly", AxiRule::kWriteLast,
     [](Cycles& c) {
       c[2].w.last = c[3].w.last = true;
       c[4].w = {};
     }},
    {"WriteTooLong", AxiRule::kWriteLast,
     [](Cycles& c) {
       c[4].w.last = false;
       c[5].w = {true, true, {}, 0xffff, true};
     }},
    {"RlastMissing", AxiRule::kReadLast, [](Cycles& c) { c[6].r.last = false; }},
    {"RlastEarly", AxiRule::kReadLast, [](Cycles& c) { c[4].r.last = true; }},
    {"ReadUnasked", AxiRule::kUnasked, [](Cycles& c) { c[8].r = c[6].r; }},
    {"ResponseUnasked", AxiRule::kUnasked, [](Cycles& c) { c[8].b = c[7].b; }},
    {"ResponseBeforeData", AxiRule::kUnasked, [](Cycles& c) { c[3].b = c[7].b; }},
    {"ReadUnanswered", AxiRule::kUnanswered,
     [](Cycles& c) {
       c[6].r = {false, true};
     }},
    {"WriteUnanswered", AxiRule::kUnanswered, [](Cycles& c) { c[7].b.valid = false; }},
    {"DataWithoutAddress", AxiRule::kUnanswered,
     [](Cycles& c) {
       c[8].w = {true, true, {}, 0xffff, true};
     }},
    {"Stall", AxiRule::kStall,
     [](Cycles& c) {
       c[5].w = c[4].w;
       c[4].w = {};
     }},
    {"ReadyFalls", AxiRule::kReadyFell, [](Cycles& c) { c[9].r.ready = false; }},
    {"AddressAfterError", AxiRule::kAfterError,
     [](Cycles& c) {
       c[4].r.response = cores::kAxiSlverr;
       c[8].ar = c[9].ar = {true, false, 0x100, 0};
     }},
    {"WriteAfterError", AxiRule::kAfterError,
     [](Cycles& c) {
       c.resize(12, c[9]);
       c[7].b.response = cores::kAxiDecerr;
       c[11].aw = {true, false, 0x100, 0};
     }},
};

class Checker : public testing::TestWithParam<Flaw> {};
INSTANTIATE_TEST_SUITE_P(Axi, Checker, testing::ValuesIn(kFlaws), test::by_name);

TEST_P(Checker, FindsTheFlaw) {
  const Flaw& flaw = GetParam();
  std::vector<cores::AxiPins> cycles = good_traffic();
  flaw.plant(cycles);
  const AxiChecker checker = check(cycles);
  EXPECT_GE(checker.violations(flaw.rule), 1u);
  for (const std::string& report : checker.reports()) {
    EXPECT_NE(report.find(axi_rule_name(flaw.rule)), std::string::npos) << report;
  }
}

/// An address that was on its way when the error came may still appear, and stays.
TEST(AxiChecker, AnAddressOnItsWayAtAnErrorBreaksNoRule) {
  std::vector<cores::AxiPins> cycles = good_traffic();
  cycles[4].r.response = cores::kAxiSlverr;
  for (std::size_t i : {7, 8, 9}) cycles[i].ar = {true, i == 9, 0x100, 0};
  EXPECT_EQ(check(cycles).violations(AxiRule::kAfterError), 0u);
}

/// Of a core with a guard, two more a channel, and beats of which no byte is written in a soft
/// reset.
TEST(AxiChecker, AGuardMayDoMore) {
  std::vector<cores::AxiPins> cycles = good_traffic();
  cycles[4].r.response = cores::kAxiSlverr;
  for (unsigned late = 1; late <= kAxiAddressesInGuard + 1; ++late) {
    cycles.push_back(cycles[0]);
    cycles.back().ar = cycles.back().aw = {true, true, 0x100, 0};
    const unsigned more = late - std::min(late, kAxiAddressesInGuard);
    EXPECT_EQ(check(cycles, {}, true).violations(AxiRule::kAfterError), 2 * more);
    EXPECT_EQ(check(cycles, {}, false).violations(AxiRule::kAfterError), 2 * late);
  }
  cycles = good_traffic();
  cycles[4].w.strobe = 0;
  for (const bool hardened : {false, true}) {
    for (const bool soft_reset : {false, true}) {
      EXPECT_EQ(check(cycles, {}, hardened, soft_reset).violations(AxiRule::kShape),
                hardened && soft_reset ? 0u : 1u);
    }
  }
}

TEST(AxiChecker, GoodTrafficBreaksNoRule) {
  const AxiChecker checker = check(good_traffic(), {2, 1, 1, 0x1fe0, 0x1fff, 0x2fe0, 0x2fff});
  EXPECT_TRUE(checker.reports().empty()) << checker.reports()[0];
  EXPECT_EQ(checker.violations(), 0u);
  EXPECT_EQ(checker.most_reads(), 1u);
  EXPECT_EQ(checker.most_writes(), 1u);
}

TEST(AxiChecker, LimitsAreExact) {
  const auto count = [](AxiRule rule, const AxiChecker::Limits& limits) {
    return check(good_traffic(), limits).violations(rule);
  };
  EXPECT_EQ(count(AxiRule::kLength, {1}), 2u);
  EXPECT_GT(count(AxiRule::kOutstanding, {2, 0, 1}), 0u);
  EXPECT_GT(count(AxiRule::kOutstanding, {2, 1, 0}), 0u);
  EXPECT_EQ(count(AxiRule::kWindow, {2, 1, 1, 0x1fe1, 0x1fff}), 1u);
  EXPECT_EQ(count(AxiRule::kWindow, {2, 1, 1, 0x1fe0, 0x1ffe}), 1u);
  EXPECT_EQ(count(AxiRule::kWindow, {2, 1, 1, 0, ~std::uint64_t{0}, 0x2fe1, 0x2fff}), 1u);
  EXPECT_EQ(count(AxiRule::kWindow, {2, 1, 1, 0, ~std::uint64_t{0}, 0x2fe0, 0x2ffe}), 1u);
}

TEST(AxiChecker, ResetValues) {
  const auto count = [](const cores::AxiPins& pins, bool in_reset) {
    AxiChecker checker;
    checker.observe(cores::AxiPins{}, 0, true);
    checker.observe(pins, 1, in_reset);
    return checker.violations(AxiRule::kReset);
  };
  EXPECT_EQ(count(cores::AxiPins{}, true), 0u);
  for (cores::AxiAddressChannel cores::AxiPins::*channel :
       {&cores::AxiPins::ar, &cores::AxiPins::aw}) {
    cores::AxiPins pins;
    (pins.*channel).valid = true;
    EXPECT_EQ(count(pins, true), 1u);
    EXPECT_EQ(count(pins, false), 1u);
  }
  cores::AxiPins data;
  data.w.valid = true;
  EXPECT_EQ(count(data, false), 1u);
  cores::AxiPins ready;
  ready.r.ready = true;
  EXPECT_EQ(count(ready, true), 1u);
}

}  // namespace
}  // namespace hwffd::tb
