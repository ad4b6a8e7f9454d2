#include "wishbone_master.hpp"

namespace hwffd::test {

const cores::WishboneMasterPins& WishboneMaster::drive() {
  if (now_ && pins_.stb && random_.chance(give_up_)) {
    now_.reset();
    ++given_up_;
    pins_.cyc = random_.chance(0.5);
    pins_.stb = !pins_.cyc && random_.chance(0.5);  // either of the two ends it
    return pins_;
  }
  if (!now_ && !waiting_.empty() && random_.chance(willing_)) {
    now_ = waiting_.front();
    waiting_.pop_front();
    pins_ = {true, true, now_->write, now_->address, now_->data, now_->select};
  } else if (!now_) {
    const bool cyc = random_.chance(0.5);
    pins_ = {cyc,
             !cyc && random_.chance(0.5),
             random_.chance(0.5),
             random_.word(),
             random_.word(),
             static_cast<std::uint8_t>(random_.word() & 0xF)};
  }
  return pins_;
}

bool WishboneMaster::accept(const cores::WishboneSlavePins& slave) {
  if (!now_ || !(slave.ack || slave.err)) return false;
  now_.reset();
  return true;
}

void WishboneMaster::clear() {
  waiting_.clear();
  now_.reset();
  pins_ = {};
}

}  // namespace hwffd::test
