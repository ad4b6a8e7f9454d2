#include "hwffd/tb/stream_driver.hpp"

#include <utility>

#include "lists.hpp"

namespace hwffd::tb {

void StreamDriver::push(std::vector<Beat> beats) {
  refill(queue_, next_, std::move(beats));
  if (record_) reserve_more(clocks_, queue_.size());
}

void StreamDriver::clear() {
  queue_.clear();
  next_ = 0;
  clocks_.clear();
  valid_ = false;
}

void StreamDriver::drive(bool willing) {
  if (valid_) return;
  if (willing && next_ < queue_.size()) {
    valid_ = true;
    return;
  }
  const std::uint64_t low = random_.bits();
  const std::uint64_t high = random_.bits();
  idle_.words = {static_cast<std::uint32_t>(low), static_cast<std::uint32_t>(low >> 32),
                 static_cast<std::uint32_t>(high), static_cast<std::uint32_t>(high >> 32)};
  idle_.last = ((low ^ (high >> 7)) & 1) != 0;
}

bool StreamDriver::accept(bool ready, std::uint64_t cycle) {
  if (!valid_ || !ready) return false;
  valid_ = false;
  ++next_;
  ++accepted_;
  if (record_) clocks_.push_back(cycle);
  return true;
}

}  // namespace hwffd::tb
