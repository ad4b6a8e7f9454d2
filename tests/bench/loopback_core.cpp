#include "loopback_core.hpp"

#include <utility>

namespace hwffd::tb {

LoopbackCore::LoopbackCore(unsigned latency, Flaw flaw) : latency_(latency), flaw_(flaw) {}

void LoopbackCore::drive_input(bool valid, const Beat& beat) {
  in_valid_ = valid;
  in_beat_ = beat;
}

void LoopbackCore::settle() {
  settled_in_valid_ = in_valid_;
  settled_out_ready_ = out_ready_;
}

bool LoopbackCore::input_ready() const {
  if (flaw_ == Flaw::kReadyInReset && reset_) return true;
  if (flaw_ == Flaw::kReadyFollowsValid) return ready_q_ && settled_in_valid_;
  if (flaw_ == Flaw::kLosesFirstAfterReset && was_reset_ && !reset_) return true;
  return ready_q_;
}

bool LoopbackCore::output_valid() const {
  if (flaw_ == Flaw::kValidInReset && reset_) return true;
  if (flaw_ == Flaw::kValidAfterReset && was_reset_ && !reset_) return true;
  if (flaw_ == Flaw::kValidFollowsReady) return valid_q_ && settled_out_ready_;
  return valid_q_;
}

Beat LoopbackCore::output() const {
  // Data without valid must not matter: the complement of what comes next.
  Beat beat = ring_[read_ % ring_.size()].beat;
  if (flaw_ == Flaw::kDataFollowsReady && !settled_out_ready_) beat.words[0] ^= 1;
  if (!valid_q_) beat.words[0] = ~beat.words[0];
  return beat;
}

void LoopbackCore::push(const Beat& beat) {
  ring_[written_ % ring_.size()] = {beat, clock_ + latency_};
  ++written_;
}

void LoopbackCore::take(Beat beat) {
  const std::uint64_t number = accepted_++;
  if (number == kFlawedBeat) {
    if (flaw_ == Flaw::kLosesBeat) return;
    if (flaw_ == Flaw::kDuplicatesBeat) push(beat);
    if (flaw_ == Flaw::kFlipsBit) beat.words[2] ^= 1u << 31;
    if (flaw_ == Flaw::kFlipsLast) beat.last = !beat.last;
    if (flaw_ == Flaw::kSwapsBeats) {
      held_back_ = beat;
      return;
    }
  }
  push(beat);
  if (number == kFlawedBeat + 1 && flaw_ == Flaw::kSwapsBeats) push(held_back_);
}

void LoopbackCore::clock_in_reset() {
  if (flaw_ != Flaw::kKeepsBeatsOverReset) read_ = written_;
  accepted_ = 0;
  delivered_ = 0;
  idle_ = 0;
  waits_ = false;
  ready_q_ = false;
  valid_q_ = false;
  was_reset_ = true;
  sample_pending_ = false;
}

void LoopbackCore::watch(bool taken) {
  if (waits_ && !(in_valid_ && in_beat_ == before_)) ++withdrawn_;
  if (!in_valid_) {
    if (in_beat_.words == before_.words) ++idle_again_;
    ++idle_with_last_[in_beat_.last];
  }
  waits_ = in_valid_ && !taken;
  before_ = in_beat_;
}

void LoopbackCore::clock() {
  ++clock_;
  if (reset_) {
    clock_in_reset();
    return;
  }
  const bool taken = in_valid_ && input_ready();
  watch(taken);
  const bool transferred = output_valid() && out_ready_;
  const bool stalled = valid_q_ && !out_ready_;
  const bool first = std::exchange(was_reset_, false);

  if (std::exchange(sample_pending_, false)) take(in_beat_);
  if (taken && flaw_ == Flaw::kSamplesLate) {
    sample_pending_ = true;
  } else if (taken && !(first && flaw_ == Flaw::kLosesFirstAfterReset)) {
    take(in_beat_);
  }
  if (transferred && read_ != written_) {
    ++read_;
    ++delivered_;
  }

  idle_ = taken || transferred ? 0 : idle_ + 1;
  if (flaw_ == Flaw::kExtraBeat && idle_ == 20 && delivered_ > kFlawedBeat && !struck_) {
    struck_ = true;
    push(in_beat_);
  }
  offer(transferred);
  if (stalled && delivered_ >= kFlawedBeat && !struck_) {
    struck_ = true;
    if (flaw_ == Flaw::kPayloadChanges) ring_[read_ % ring_.size()].beat.words[1] ^= 1;
    if (flaw_ == Flaw::kValidDrops) valid_q_ = false;
  }
  ready_q_ = written_ - read_ < kDepth;
  if (flaw_ == Flaw::kStopsInput && accepted_ >= kFlawedBeat) ready_q_ = false;
}

void LoopbackCore::offer(bool transferred) {
  const bool due = read_ != written_ && ring_[read_ % ring_.size()].due <= clock_ + 1;
  const bool held = valid_q_ && !transferred;
  valid_q_ = due;
  if (flaw_ == Flaw::kStopsOutput && delivered_ >= kFlawedBeat) valid_q_ = false;
  if (flaw_ == Flaw::kHalfRate && transferred) valid_q_ = false;
  if (flaw_ == Flaw::kValidWaitsForReady) valid_q_ = due && (held || out_ready_);
}

std::vector<Beat> random_beats(std::size_t count, std::uint64_t seed) {
  Random random(seed);
  std::vector<Beat> beats(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (auto& word : beats[i].words) word = random.word();
    beats[i].words[3] = (beats[i].words[3] & 0xffff0000u) | static_cast<std::uint16_t>(i);
    beats[i].last = random.chance(0.25);
  }
  return beats;
}

}  // namespace hwffd::tb
