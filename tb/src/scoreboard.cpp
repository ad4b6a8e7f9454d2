#include "hwffd/tb/scoreboard.hpp"

#include <fmt/format.h>

#include "hwffd/tb/beat_text.hpp"
#include "lists.hpp"

namespace hwffd::tb {
namespace {

std::string name_differences(const Beat& expected, const Beat& got) {
  std::string text;
  for (std::size_t i = 0; i < expected.words.size(); ++i) {
    const std::uint32_t flipped = expected.words[i] ^ got.words[i];
    if (flipped != 0)
      text += fmt::format("{}word {} by {:08x}", text.empty() ? "" : ", ", i, flipped);
  }
  if (expected.last != got.last) text += text.empty() ? "last" : ", last";
  if (expected.user != got.user) text += text.empty() ? "user" : ", user";
  return "differs in " + text;
}

}  // namespace

void Scoreboard::expect(std::vector<Beat> beats) {
  expected_ += beats.size();
  refill(queue_, next_, std::move(beats));
}

void Scoreboard::fail(const Beat& got, std::uint64_t cycle) {
  const std::uint64_t number = checked_ + extra_ - received_before_restart_;
  const std::string where =
      fmt::format("{} seed {}: beat {}, cycle {}", test_.name, test_.seed, number, cycle);
  const bool is_extra = next_ == queue_.size();
  std::string text;
  if (is_extra) {
    ++extra_;
    text = fmt::format("{}, tag {:04x}: unexpected\n  got      {}", where, beat_tag(got),
                       beat_text(got));
  } else {
    const Beat& expected = queue_[next_];
    ++next_;
    ++checked_;
    ++mismatches_;
    if (mismatches_ + extra_ <= kMaxReports) {
      text = fmt::format("{}, tag {:04x}: wrong\n  expected {}\n  got      {}\n  {}", where,
                         beat_tag(expected), beat_text(expected), beat_text(got),
                         name_differences(expected, got));
    }
  }
  if (mismatches_ + extra_ > kMaxReports) return;
  reports_.push_back(text + "\n  replay   " + replay_command(test_));
}

void Scoreboard::restart() {
  expected_ -= outstanding();
  queue_.clear();
  next_ = 0;
  checked_before_restart_ = checked_;
  received_before_restart_ = checked_ + extra_;
}

bool Scoreboard::finish() {
  end_reports_.clear();
  const auto complain = [this](const std::string& what) {
    end_reports_.push_back(fmt::format("{} seed {}: {}\n  replay   {}", test_.name, test_.seed,
                                       what, replay_command(test_)));
  };
  if (checked_ == checked_before_restart_) {
    complain(checked_ == 0 ? "nothing was checked" : "nothing was checked after the last reset");
  }
  if (checked_ != expected_) {
    complain(fmt::format("{} of {} beats are missing, from beat {} on:\n  expected {}",
                         outstanding(), expected_, checked_ - checked_before_restart_,
                         beat_text(queue_.at(next_))));
  }
  if (extra_ != 0) complain(fmt::format("{} beats too many", extra_));
  return ok();
}

std::vector<std::string> Scoreboard::reports() const {
  std::vector<std::string> all = reports_;
  all.insert(all.end(), end_reports_.begin(), end_reports_.end());
  return all;
}

}  // namespace hwffd::tb
