#include "hwffd/tb/fault.hpp"

#include <stdexcept>

namespace hwffd::tb {

FaultInjector::FaultInjector(const Fault& fault) : fault_(fault) {
  if (fault.bit > 128) throw std::invalid_argument("Fault: a beat has bits 0 to 128");
}

unsigned FaultInjector::strike(Beat& beat) {
  struck_ = true;
  if (fault_.kind == Fault::Kind::kDrop) return 0;
  if (fault_.kind == Fault::Kind::kDuplicate) return 2;
  if (fault_.bit == 128) {
    beat.last = !beat.last;
  } else {
    beat.words[fault_.bit / 32] ^= std::uint32_t{1} << (fault_.bit % 32);
  }
  return 1;
}

}  // namespace hwffd::tb
