#include "hwffd/tb/stream_monitor.hpp"

#include "lists.hpp"

namespace hwffd::tb {

void StreamMonitor::clear() {
  beats_.clear();
  clocks_.clear();
}

void StreamMonitor::reserve(std::size_t more) {
  if (!record_) return;
  reserve_more(beats_, more);
  reserve_more(clocks_, more);
}

}  // namespace hwffd::tb
