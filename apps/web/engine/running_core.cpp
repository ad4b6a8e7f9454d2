#include "running_core.hpp"

#include <fmt/format.h>

#include <utility>

#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"
#include "signal_table.hpp"

namespace hwffd::web {
namespace {

constexpr std::uint64_t kSeed = 1;              // of the registers before reset
constexpr std::uint64_t kPatience = 1'000'000;  // clocks without a beat
constexpr int kResetClocks = 4;
constexpr int kStuckBit = 24;

/// Offers the commands one after the other and takes every result at once.
class Conversation final : public cores::StreamParty {
 public:
  Conversation(RunningCore& core, const std::vector<Beat>& commands, std::size_t results)
      : core_(core), commands_(commands), results_(results), start_(core.clocks()) {
    answers_.beats.reserve(results);
  }

  bool one_cycle() override {
    const Beat* const offered = next_ < commands_.size() ? &commands_[next_] : nullptr;
    const cores::StreamPins& pins = core_.settle(offered);
    const bool accepted = offered != nullptr && pins.input_ready;
    const bool came = pins.output_valid;
    if (accepted) ++next_;
    if (came) answers_.beats.push_back(pins.output);
    core_.edge();
    answers_.clocks = core_.clocks() - start_;
    if (came && answers_.beats.size() == 1) answers_.first = answers_.clocks;
    return accepted || came;
  }
  std::uint64_t left() const override {
    const std::size_t came = answers_.beats.size();
    return commands_.size() - next_ + (came < results_ ? results_ - came : 0);
  }

  const Answers& answers() const { return answers_; }
  Answers take() { return std::move(answers_); }

 private:
  RunningCore& core_;
  const std::vector<Beat>& commands_;
  std::size_t results_;
  std::uint64_t start_;
  std::size_t next_ = 0;
  Answers answers_;
};

}  // namespace

RunningCore::RunningCore(const Configuration& row)
    : name_(row.name),
      core_(cores::make_stream_core(row, kSeed)),
      loop_(*core_),
      stuck_(SignalTable(core_->signals()).only("u_encoder:words_q")) {
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
  Conversation conversation(*this, commands, results);
  if (loop_.run(conversation, {kPatience}, {}) == cores::StreamEnd::kDone) {
    return conversation.take();
  }
  throw Error(fmt::format("{}: {} of {} results came, then none for {} clocks; open it again",
                          name_, conversation.answers().beats.size(), results, kPatience));
}

}  // namespace hwffd::web
