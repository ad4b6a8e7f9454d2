#include "fuzz.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "current_input.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "mutator.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kLongestMessage = 200;
constexpr std::size_t kMostFailures = 20;

/// What is wrong with an error's text; empty if nothing.
std::string fault_of(const std::string& message) {
  const bool printable =
      std::all_of(message.begin(), message.end(), [](char c) { return c >= 0x20 && c < 0x7f; });
  if (message.empty()) return "the message is empty";
  if (message.size() > kLongestMessage) {
    return fmt::format("the message has {} characters", message.size());
  }
  return printable ? "" : "the message is not one printable line: " + excerpt(message, 200);
}

/// Runs one input; what is wrong, empty if nothing.
std::string run(const Target& target, const std::string& input, Tally& tally) {
  try {
    target.read(input);
    ++tally.valid;
  } catch (const Error& error) {
    ++tally.refused;
    return fault_of(error.what());
  } catch (const std::exception& error) {
    return std::string("another exception: ") + error.what();
  } catch (...) {
    return "something thrown that is no exception";
  }
  return "";
}

}  // namespace

void expect(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

Tally fuzz(const Target& target, std::uint64_t seed, std::uint64_t first, std::uint64_t inputs) {
  Tally tally;
  for (std::uint64_t number = first; number < first + inputs; ++number) {
    const std::string replay =
        fmt::format("HWFFD_FUZZ_SEED={} HWFFD_FUZZ_INPUT={} target {}", seed, number, target.name);
    const std::string input = Mutator(tb::derive_seed(seed, number), target.corpus).next();
    const CurrentInput current(replay);
    const std::string fault = run(target, input, tally);
    if (fault.empty()) continue;
    tally.failures.push_back(
        fmt::format("{}: {}; {} bytes: {}", replay, fault, input.size(), excerpt(input, 300)));
    if (tally.failures.size() == kMostFailures) break;
  }
  return tally;
}

}  // namespace hwffd
