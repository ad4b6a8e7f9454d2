#include "running_core.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"

namespace hwffd::web {
namespace {

constexpr std::uint64_t kSeed = 1;              // of the registers before reset
constexpr std::uint64_t kPatience = 1'000'000;  // clocks without a beat
constexpr int kResetClocks = 4;
constexpr int kStuckBit = 24;

cores::Signal stuck_in(const cores::StreamCore& core, const std::string& row) {
  for (const cores::Signal& signal : core.signals()) {
    if (signal.name == "words_q") return signal;
  }
  throw Error(fmt::format("{}: built without apps/web/engine/ffd_web.vlt; build it with that", row));
}

}  // namespace

RunningCore::RunningCore(const Configuration& row)
    : name_(row.name),
      core_(cores::make_stream_core(row, kSeed)),
      loop_(*core_),
      stuck_(stuck_in(*core_, name_)) {
  reset();
}

void RunningCore::reset() {
  loop_.reset(true);
  for (int edge = 0; edge < kResetClocks; ++edge) clock(nullptr);
  loop_.reset(false);
}

const cores::StreamPins& RunningCore::clock(const Beat* offered) {
  const cores::StreamPins& pins = loop_.drive(offered != nullptr, offered ? *offered : Beat{}, true);
  loop_.clock();
  if (fault_) stuck_.set(kStuckBit);
  return pins;
}

Answers RunningCore::run(const std::vector<Beat>& commands, std::size_t results) {
  Answers answers;
  answers.beats.reserve(results);
  const std::uint64_t start = clocks();
  std::uint64_t moved = start;
  std::size_t next = 0;
  while (next < commands.size() || answers.beats.size() < results) {
    const Beat* const offered = next < commands.size() ? &commands[next] : nullptr;
    const cores::StreamPins& pins = clock(offered);
    const bool accepted = offered != nullptr && pins.input_ready;
    if (accepted) ++next;
    if (pins.output_valid) {
      if (answers.beats.empty()) answers.first = clocks() - start;
      answers.beats.push_back(pins.output);
    }
    if (accepted || pins.output_valid) moved = clocks();
    if (clocks() - moved < kPatience) continue;
    throw Error(fmt::format("{}: {} of {} results came, then none for {} clocks; open it again",
                            name_, answers.beats.size(), results, kPatience));
  }
  answers.clocks = clocks() - start;
  return answers;
}

}  // namespace hwffd::web
