// The checker on AXI4-Lite is fed faulty traffic: each flaw is reported once and as what it is,
// clean traffic not at all. The rules that it shares with AXI4 have more flaws in tests/bus/dma.
#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "hwffd/tb/axi_checker.hpp"
#include "named.hpp"

namespace hwffd::tb {
namespace {

using cores::AxiLiteMasterPins;
using cores::AxiLitePins;
using cores::AxiLiteSlavePins;
using Trace = std::vector<AxiLitePins>;

/// Two clocks of reset, one of rest, a write and a read whose requests and responses wait a clock
/// each, a rest. Clock 4: address and read offered; 5: accepted, data too; 6: responses; 7: taken.
Trace clean() {
  Trace trace(9);
  trace[0].in_reset = trace[1].in_reset = true;
  for (const unsigned clock : {4u, 5u}) {
    AxiLiteMasterPins& master = trace[clock].master;
    master = {true, 0x40, 0, true, 0x1234, 0xF, false, true, 0x40, 0, false};
  }
  trace[5].slave.awready = trace[5].slave.wready = trace[5].slave.arready = true;
  for (const unsigned clock : {6u, 7u}) {
    trace[clock].slave = {false, false, true, cores::kSlvErr, false, true, 0x5678, cores::kSlvErr};
  }
  trace[7].master.bready = trace[7].master.rready = true;
  return trace;
}

AxiChecker check(const Trace& trace) {
  AxiChecker checker(true);
  for (std::size_t clock = 0; clock < trace.size(); ++clock) checker.observe(trace[clock], clock);
  checker.finish(trace.size());
  return checker;
}

TEST(AxiLiteChecker, HasNothingToSayOfCleanTraffic) {
  const AxiChecker checker = check(clean());
  EXPECT_EQ(checker.violations(), 0u) << checker.reports().front();
  EXPECT_EQ(checker.most_writes(), 1u);
  EXPECT_EQ(checker.most_reads(), 1u);
}

struct Flaw {
  const char* name;
  AxiRule rule;
  std::function<void(Trace&)> plant;
};
void PrintTo(const Flaw& flaw, std::ostream* out) { *out << flaw.name; }

/// A pin that has another value in some clocks.
template <class Side, class Pins, class Value>
std::function<void(Trace&)> set(Side side, Value Pins::*pin, std::vector<unsigned> clocks,
                                unsigned value = 1) {
  return [=](Trace& trace) {
    for (const unsigned clock : clocks) trace[clock].*side.*pin = static_cast<Value>(value);
  };
}
/// The clock once more, without that one of its valids.
template <class Side, class Pins>
std::function<void(Trace&)> falls(Side side, bool Pins::*valid, unsigned clock) {
  return [=](Trace& trace) {
    trace.insert(trace.begin() + clock + 1, trace[clock]);
    trace[clock + 1].*side.*valid = false;
  };
}
constexpr auto kMaster = &AxiLitePins::master;
constexpr auto kSlave = &AxiLitePins::slave;
using M = AxiLiteMasterPins;
using S = AxiLiteSlavePins;

// Each is one change of the clean traffic.
const Flaw kFlaws[] = {
    {"aw_falls", AxiRule::kStable, falls(kMaster, &M::awvalid, 4)},
    {"w_falls", AxiRule::kStable, falls(kMaster, &M::wvalid, 4)},
    {"ar_falls", AxiRule::kStable, falls(kMaster, &M::arvalid, 4)},
    {"b_falls", AxiRule::kStable, falls(kSlave, &S::bvalid, 6)},
    {"r_falls", AxiRule::kStable, falls(kSlave, &S::rvalid, 6)},
    {"aw_changes", AxiRule::kStable, set(kMaster, &M::awaddr, {5}, 0x44)},
    {"aw_prot_changes", AxiRule::kStable, set(kMaster, &M::awprot, {5})},
    {"w_data_changes", AxiRule::kStable, set(kMaster, &M::wdata, {5}, 0x1235)},
    {"w_strobe_changes", AxiRule::kStable, set(kMaster, &M::wstrb, {5})},
    {"ar_changes", AxiRule::kStable, set(kMaster, &M::araddr, {5}, 0)},
    {"ar_prot_changes", AxiRule::kStable, set(kMaster, &M::arprot, {5})},
    {"b_changes", AxiRule::kStable, set(kSlave, &S::bresp, {7}, cores::kOkay)},
    {"r_data_changes", AxiRule::kStable, set(kSlave, &S::rdata, {7})},
    {"r_code_changes", AxiRule::kStable, set(kSlave, &S::rresp, {7}, cores::kOkay)},
    {"b_before_address", AxiRule::kUnasked,
     [](Trace& t) {
       t[5].slave.awready = false;
       t[6].master.awvalid = t[6].slave.awready = true;
       t[6].master.awaddr = 0x40;
     }},
    {"b_before_data", AxiRule::kUnasked,
     [](Trace& t) {
       t[5].slave.wready = false;
       t[6].master.wvalid = t[6].slave.wready = true;
       t[6].master.wdata = 0x1234;
       t[6].master.wstrb = 0xF;
     }},
    {"r_before_address", AxiRule::kUnasked,
     [](Trace& t) { t[3].slave.rvalid = t[3].master.rready = true; }},
    {"r_in_the_clock_of_its_address", AxiRule::kUnasked,
     [](Trace& t) {
       t[5].slave.rvalid = true;
       t[5].slave.rdata = 0x5678;
       t[5].slave.rresp = 2;
     }},
    {"second_r", AxiRule::kUnasked,
     [](Trace& t) { t[8].slave.rvalid = t[8].master.rready = true; }},
    {"no_b", AxiRule::kUnanswered, set(kSlave, &S::bvalid, {6, 7}, 0)},
    {"no_r", AxiRule::kUnanswered, set(kSlave, &S::rvalid, {6, 7}, 0)},
    {"address_without_data", AxiRule::kUnanswered,
     [](Trace& t) { t[8].master.awvalid = t[8].slave.awready = true; }},
    {"b_exokay", AxiRule::kShape, set(kSlave, &S::bresp, {6, 7}, cores::kExOkay)},
    {"r_exokay", AxiRule::kShape, set(kSlave, &S::rresp, {6, 7}, cores::kExOkay)},
    {"bvalid_in_reset", AxiRule::kReset, set(kSlave, &S::bvalid, {1})},
    {"rvalid_in_reset", AxiRule::kReset, set(kSlave, &S::rvalid, {1})},
    {"awready_in_reset", AxiRule::kReset, set(kSlave, &S::awready, {1})},
    {"wready_in_reset", AxiRule::kReset, set(kSlave, &S::wready, {1})},
    {"arready_in_reset", AxiRule::kReset, set(kSlave, &S::arready, {1})},
    {"awready_after_reset", AxiRule::kReset, set(kSlave, &S::awready, {2})},
    {"arvalid_in_reset", AxiRule::kReset, set(kMaster, &M::arvalid, {1})},
    {"awvalid_in_reset", AxiRule::kReset, set(kMaster, &M::awvalid, {0})},
    {"wvalid_in_reset", AxiRule::kReset, set(kMaster, &M::wvalid, {1})},
    {"no_reset", AxiRule::kReset, [](Trace& t) { t.erase(t.begin(), t.begin() + 2); }},
};

class PlantedBusFlaw : public testing::TestWithParam<Flaw> {};
INSTANTIATE_TEST_SUITE_P(Flaws, PlantedBusFlaw, testing::ValuesIn(kFlaws), test::by_name);

TEST_P(PlantedBusFlaw, IsReportedOnce) {
  Trace trace = clean();
  GetParam().plant(trace);
  const AxiChecker checker = check(trace);
  EXPECT_EQ(checker.violations(), 1u);
  EXPECT_EQ(checker.violations(GetParam().rule), 1u);
}

TEST(AxiLiteChecker, ResetForgetsWhatIsOpen) {
  Trace trace = clean();
  trace.resize(6);  // up to the requests
  trace.push_back({true, {}, {}});
  trace.push_back({true, {}, {}});
  trace.push_back({});
  EXPECT_EQ(check(trace).violations(), 0u);
}

TEST(AxiLiteChecker, RvalidAfterResetIsTwoFaults) {
  Trace trace = clean();
  trace[2].slave.rvalid = trace[2].master.rready = true;
  const AxiChecker checker = check(trace);
  EXPECT_EQ(checker.violations(), 2u) << "in the first clock after reset, and not asked for";
  EXPECT_EQ(checker.violations(AxiRule::kReset), 1u);
  EXPECT_EQ(checker.violations(AxiRule::kUnasked), 1u);
}

TEST(AxiLiteChecker, KeepsTwentyReports) {
  Trace trace = clean();
  for (unsigned i = 0; i < 50; ++i) {
    trace.push_back({});
    trace.back().slave.rvalid = trace.back().master.rready = true;
  }
  const AxiChecker checker = check(trace);
  EXPECT_EQ(checker.violations(), 50u);
  EXPECT_EQ(checker.reports().size(), AxiChecker::kMaxReports);
}

}  // namespace
}  // namespace hwffd::tb
