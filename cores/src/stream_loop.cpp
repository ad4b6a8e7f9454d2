#include "hwffd/cores/stream_loop.hpp"

namespace hwffd::cores {
namespace {

// Tells the fraction that moved, in steps of at least 1 %, up to the end, which is told but once.
class Teller {
 public:
  Teller(std::uint64_t total, const StreamLoop::Progress& progress)
      : total_(total), step_(total / 100 + 1), next_(step_), progress_(progress) {}

  void tell(std::uint64_t left) {
    const std::uint64_t moved = total_ > left ? total_ - left : 0;
    if (!progress_ || moved < next_ || left == 0) return;
    next_ = moved + step_;
    progress_(static_cast<double>(moved) / static_cast<double>(total_));
  }

 private:
  std::uint64_t total_;
  std::uint64_t step_;
  std::uint64_t next_;
  const StreamLoop::Progress& progress_;
};

}  // namespace

void StreamLoop::reset(bool asserted) {
  pins_.in_reset = asserted;
  core_.drive_reset(asserted);
}

const StreamPins& StreamLoop::drive(bool input_valid, const Beat& input, bool output_ready) {
  core_.drive_input(input_valid, input);
  core_.drive_output_ready(output_ready);
  core_.settle();
  pins_.input_valid = input_valid;
  pins_.output_ready = output_ready;
  pins_.input_ready = core_.input_ready();
  pins_.output_valid = core_.output_valid();
  if (pins_.output_valid) pins_.output = core_.output();
  return pins_;
}

void StreamLoop::clock() {
  core_.clock();
  ++clocks_;
}

StreamEnd StreamLoop::run(StreamParty& party, const StreamLimits& limits,
                          const Progress& progress) {
  const std::uint64_t start = clocks_;
  std::uint64_t moved = clocks_;
  std::uint64_t left = party.left();
  Teller teller(left, progress);
  while (left != 0) {
    if (party.stopped()) return StreamEnd::kStopped;
    const bool any = party.one_cycle();
    left = party.left();
    if (any) {
      moved = clocks_;
      teller.tell(left);
    } else if (left != 0 && clocks_ - moved >= limits.stall) {
      return StreamEnd::kStalled;
    }
    if (left != 0 && clocks_ - start >= limits.cycles) return StreamEnd::kLate;
  }
  if (progress) progress(1);
  return StreamEnd::kDone;
}

}  // namespace hwffd::cores
