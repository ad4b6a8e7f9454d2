// The checker is fed faulty traffic: each flaw is reported once and in the right words, clean
// traffic not at all.
#include "hwffd/tb/axil_checker.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "named.hpp"

namespace hwffd::tb {
namespace {

using Trace = std::vector<cores::AxiLitePins>;

/// Two clocks of reset, one of rest, a write and a read whose requests and responses wait a clock
/// each, a rest. Clock 4: address and read offered; 5: accepted, data too; 6: responses; 7: taken.
Trace clean() {
  Trace trace(9);
  trace[0].in_reset = trace[1].in_reset = true;
  for (const unsigned clock : {4u, 5u}) {
    trace[clock].master.awvalid = trace[clock].master.arvalid = true;
    trace[clock].master.wvalid = true;
    trace[clock].master.awaddr = trace[clock].master.araddr = 0x40;
    trace[clock].master.wdata = 0x1234;
    trace[clock].master.wstrb = 0xF;
  }
  trace[5].slave.awready = trace[5].slave.wready = trace[5].slave.arready = true;
  for (const unsigned clock : {6u, 7u}) {
    trace[clock].slave.bvalid = trace[clock].slave.rvalid = true;
    trace[clock].slave.rdata = 0x5678;
    trace[clock].slave.bresp = trace[clock].slave.rresp = cores::kSlvErr;
  }
  trace[7].master.bready = trace[7].master.rready = true;
  return trace;
}

AxiLiteChecker check(const Trace& trace) {
  AxiLiteChecker checker;
  for (std::size_t clock = 0; clock < trace.size(); ++clock) checker.observe(trace[clock], clock);
  checker.finish(trace.size());
  return checker;
}

TEST(AxiLiteChecker, HasNothingToSayOfCleanTraffic) {
  const AxiLiteChecker checker = check(clean());
  EXPECT_EQ(checker.violations(), 0u) << checker.reports().front();
  EXPECT_EQ(checker.writes(), 1u);
  EXPECT_EQ(checker.reads(), 1u);
}

struct Flaw {
  const char* name;
  std::function<void(Trace&)> plant;
  const char* report;
};

class PlantedBusFlaw : public testing::TestWithParam<Flaw> {};

TEST_P(PlantedBusFlaw, IsReportedOnce) {
  Trace trace = clean();
  GetParam().plant(trace);
  const AxiLiteChecker checker = check(trace);
  ASSERT_EQ(checker.violations(), 1u)
      << (checker.reports().empty() ? "" : checker.reports().back());
  EXPECT_EQ(checker.reports().front(), GetParam().report);
}

/// The clock once more, without that one of its valids.
template <class Side, class Pins>
void falls(Trace& trace, unsigned clock, Side side, bool Pins::*valid) {
  trace.insert(trace.begin() + clock + 1, trace[clock]);
  trace[clock + 1].*side.*valid = false;
}

// Each is one change of the clean traffic.
const Flaw kFlaws[] = {
    {"aw_falls",
     [](Trace& t) {
       t.insert(t.begin() + 5, cores::AxiLitePins{false, {}, {}});
       t[5].master = t[4].master;
       t[5].master.awvalid = false;
     },
     "cycle 5: awvalid fell before it was accepted"},
    {"w_falls",
     [](Trace& t) { falls(t, 4, &cores::AxiLitePins::master, &cores::AxiLiteMasterPins::wvalid); },
     "cycle 5: wvalid fell before it was accepted"},
    {"ar_falls",
     [](Trace& t) { falls(t, 4, &cores::AxiLitePins::master, &cores::AxiLiteMasterPins::arvalid); },
     "cycle 5: arvalid fell before it was accepted"},
    {"b_falls",
     [](Trace& t) { falls(t, 6, &cores::AxiLitePins::slave, &cores::AxiLiteSlavePins::bvalid); },
     "cycle 7: bvalid fell before it was accepted"},
    {"r_falls",
     [](Trace& t) { falls(t, 6, &cores::AxiLitePins::slave, &cores::AxiLiteSlavePins::rvalid); },
     "cycle 7: rvalid fell before it was accepted"},
    {"aw_changes", [](Trace& t) { t[5].master.awaddr = 0x44; },
     "cycle 5: aw changed while it waited, from 40 to 44"},
    {"w_data_changes", [](Trace& t) { t[5].master.wdata = 0x1235; },
     "cycle 5: w changed while it waited, from f00001234 to f00001235"},
    {"w_strobe_changes", [](Trace& t) { t[5].master.wstrb = 1; },
     "cycle 5: w changed while it waited, from f00001234 to 100001234"},
    {"ar_changes", [](Trace& t) { t[5].master.araddr = 0; },
     "cycle 5: ar changed while it waited, from 40 to 0"},
    {"b_changes", [](Trace& t) { t[7].slave.bresp = cores::kOkay; },
     "cycle 7: b changed while it waited, from 2 to 0"},
    {"r_data_changes", [](Trace& t) { t[7].slave.rdata = 1; },
     "cycle 7: r changed while it waited, from 200005678 to 200000001"},
    {"r_code_changes", [](Trace& t) { t[7].slave.rresp = cores::kOkay; },
     "cycle 7: r changed while it waited, from 200005678 to 5678"},
    {"b_before_address",
     [](Trace& t) {
       t[5].slave.awready = false;
       t[6].master.awvalid = true;
       t[6].master.awaddr = 0x40;
       t[6].slave.awready = true;
     },
     "cycle 6: bvalid without an accepted address"},
    {"b_before_data",
     [](Trace& t) {
       t[5].slave.wready = false;
       t[6].master.wvalid = true;
       t[6].master.wdata = 0x1234;
       t[6].master.wstrb = 0xF;
       t[6].slave.wready = true;
     },
     "cycle 6: bvalid without accepted data"},
    {"r_before_address",
     [](Trace& t) {
       t[3].slave.rvalid = true;
       t[3].master.rready = true;
     },
     "cycle 3: rvalid without an accepted address"},
    {"r_in_the_clock_of_its_address",
     [](Trace& t) {
       t[5].slave.rvalid = true;
       t[5].slave.rdata = 0x5678;
       t[5].slave.rresp = 2;
     },
     "cycle 5: rvalid without an accepted address"},
    {"second_r",
     [](Trace& t) {
       t[8].slave.rvalid = true;
       t[8].master.rready = true;
     },
     "cycle 8: rvalid without an accepted address"},
    {"no_b", [](Trace& t) { t[6].slave.bvalid = t[7].slave.bvalid = false; },
     "cycle 9: writes without a response: 1 addresses, 1 data"},
    {"no_r", [](Trace& t) { t[6].slave.rvalid = t[7].slave.rvalid = false; },
     "cycle 9: reads without a response: 1"},
    {"address_without_data", [](Trace& t) { t[8].master.awvalid = t[8].slave.awready = true; },
     "cycle 9: writes without a response: 1 addresses, 0 data"},
    {"b_exokay", [](Trace& t) { t[6].slave.bresp = t[7].slave.bresp = cores::kExOkay; },
     "cycle 6: bresp is EXOKAY"},
    {"r_exokay", [](Trace& t) { t[6].slave.rresp = t[7].slave.rresp = cores::kExOkay; },
     "cycle 6: rresp is EXOKAY"},
    {"bvalid_in_reset", [](Trace& t) { t[1].slave.bvalid = true; },
     "cycle 1: bvalid is high in reset"},
    {"rvalid_in_reset", [](Trace& t) { t[1].slave.rvalid = true; },
     "cycle 1: rvalid is high in reset"},
    {"awready_in_reset", [](Trace& t) { t[1].slave.awready = true; },
     "cycle 1: awready is high in reset"},
    {"wready_in_reset", [](Trace& t) { t[1].slave.wready = true; },
     "cycle 1: wready is high in reset"},
    {"arready_in_reset", [](Trace& t) { t[1].slave.arready = true; },
     "cycle 1: arready is high in reset"},
    {"awready_after_reset", [](Trace& t) { t[2].slave.awready = true; },
     "cycle 2: awready is high in the first cycle after reset"},
    {"master_valid_in_reset", [](Trace& t) { t[1].master.arvalid = true; },
     "cycle 1: arvalid is high in reset"},
    {"no_reset", [](Trace& t) { t.erase(t.begin(), t.begin() + 2); }, "cycle 7: no reset was seen"},
};

INSTANTIATE_TEST_SUITE_P(Flaws, PlantedBusFlaw, testing::ValuesIn(kFlaws), test::by_name);

TEST(AxiLiteChecker, RvalidAfterResetIsTwoFaults) {
  Trace trace = clean();
  trace[2].slave.rvalid = true;
  trace[2].master.rready = true;
  EXPECT_EQ(check(trace).violations(), 2u);  // too early, and without a request
}

TEST(AxiLiteChecker, ResetForgetsWhatIsOpen) {
  Trace trace = clean();
  trace.resize(6);  // up to the requests
  trace.push_back({true, {}, {}});
  trace.push_back({true, {}, {}});
  trace.push_back({});
  EXPECT_EQ(check(trace).violations(), 0u);
}

TEST(AxiLiteChecker, KeepsTwentyReports) {
  Trace trace = clean();
  for (unsigned i = 0; i < 50; ++i) {
    trace.push_back({});
    trace.back().slave.rvalid = trace.back().master.rready = true;
  }
  const AxiLiteChecker checker = check(trace);
  EXPECT_EQ(checker.violations(), 50u);
  EXPECT_EQ(checker.reports().size(), AxiLiteChecker::kMaxReports);
}

}  // namespace
}  // namespace hwffd::tb
