#include "running_core.hpp"

#include <fmt/format.h>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"
#include "signal_table.hpp"

namespace hwffd::web {
namespace {

constexpr std::uint64_t kSeed = 1;              // of the registers before reset
constexpr std::uint64_t kPatience = 1'000'000;  // clocks without a beat
constexpr int kResetClocks = 4;
constexpr int kStuckBit = 24;

}  // namespace

RunningCore::RunningCore(const Configuration& row)
    : name_(row.name),
      core_(cores::make_stream_core(row, kSeed)),
      loop_(*core_),
      stuck_(SignalTable(core_->signals()).one("u_encoder:words_q")) {
  reset();
}

void RunningCore::reset() {
  loop_.reset(true);
  for (int i = 0; i < kResetClocks; ++i) {
    settle(nullptr);
    edge();
  }
  loop_.reset(false);
}

const cores::StreamPins& RunningCore::settle(const Beat* offered) {
  return loop_.drive(offered != nullptr, offered != nullptr ? *offered : Beat{}, true);
}

void RunningCore::edge() {
  loop_.clock();
  if (fault_) stuck_.set(kStuckBit);
}

Answers RunningCore::run(const std::vector<Beat>& commands, std::size_t results) {
  Answers answers;
  answers.beats.reserve(results);
  const std::uint64_t start = clocks();
  std::uint64_t moved = start;
  std::size_t next = 0;
  while (next < commands.size() || answers.beats.size() < results) {
    const Beat* const offered = next < commands.size() ? &commands[next] : nullptr;
    const cores::StreamPins& pins = settle(offered);
    const bool accepted = offered != nullptr && pins.input_ready;
    if (accepted) ++next;
    if (pins.output_valid) answers.beats.push_back(pins.output);
    if (accepted || pins.output_valid) moved = clocks();
    edge();
    if (answers.first == 0 && !answers.beats.empty()) answers.first = clocks() - start;
    if (clocks() - moved < kPatience) continue;
    throw Error(fmt::format("{}: {} of {} results came, then none for {} clocks; open it again",
                            name_, answers.beats.size(), results, kPatience));
  }
  answers.clocks = clocks() - start;
  return answers;
}

}  // namespace hwffd::web
