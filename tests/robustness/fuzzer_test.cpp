// The fuzzer itself.

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

#include "fuzz.hpp"
#include "hwffd/error.hpp"
#include "mutator.hpp"
#include "targets.hpp"

namespace hwffd {
namespace {

TEST(Fuzzer, HundredThousandInputs) {
  std::uint64_t inputs = 0;
  for (const Target& target : targets()) inputs += target.inputs;
  EXPECT_GE(inputs, 100000u);
}

TEST(Fuzzer, InputsDifferAndRepeat) {
  const std::vector<std::string> corpus{"{\"dims\": [4, 5, 6], \"shape\": \"box\"}"};
  std::set<std::string> inputs;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const std::string input = Mutator(seed, corpus).next();
    EXPECT_EQ(Mutator(seed, corpus).next(), input);
    inputs.insert(input);
  }
  EXPECT_GT(inputs.size(), 800u);
}

/// What `Error` itself does not allow.
struct TwoLines : Error {
  TwoLines() : Error("two lines") {}
  const char* what() const noexcept override { return "two\nlines"; }
};

/// A planted fault is found in the first input, and the report says how to repeat it.
TEST(Fuzzer, PlantedFaultsAreFound) {
  struct Fault {
    void (*read)(const std::string&);
    const char* report;
  };
  const std::vector<Fault> faults{
      {[](const std::string&) { throw Error(""); }, "the message is empty"},
      {[](const std::string&) { throw TwoLines(); }, "not one printable line"},
      {[](const std::string&) { throw Error("caf\xc3\xa9"); }, "not one printable line"},
      {[](const std::string&) { throw Error(std::string(501, 'x')); }, "has 501 characters"},
      {[](const std::string&) { throw std::out_of_range("at"); }, "another exception: at"},
      {[](const std::string&) { throw 1; }, "something thrown that is no exception"},
      {[](const std::string&) { expect(false, "broken"); }, "another exception: broken"}};
  for (const Fault& fault : faults) {
    const Tally tally = fuzz({"planted", 30, {"text"}, fault.read}, 7, 5, 30);
    ASSERT_EQ(tally.failures.size(), 20u) << fault.report;
    const std::string& first = tally.failures.front();
    EXPECT_EQ(first.rfind("HWFFD_FUZZ_SEED=7 HWFFD_FUZZ_INPUT=5 target planted: ", 0), 0u) << first;
    EXPECT_NE(first.find(fault.report), std::string::npos) << first;
  }
}

}  // namespace
}  // namespace hwffd
