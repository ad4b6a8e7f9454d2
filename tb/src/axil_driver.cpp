#include "hwffd/tb/axil_driver.hpp"

namespace hwffd::tb {

void AxiLiteDriver::clear() {
  writes_.clear();
  reads_.clear();
  written_.clear();
  read_.clear();
  next_aw_ = next_w_ = next_ar_ = 0;
  const std::uint8_t prot = pins_.awprot;
  pins_ = {};
  protect(prot);
}

const cores::AxiLiteMasterPins& AxiLiteDriver::drive() {
  // A throttle is asked in every cycle, and heard where nothing is on offer yet.
  const bool aw = throttles_.aw.willing();
  const bool w = throttles_.w.willing();
  const bool ar = throttles_.ar.willing();
  if (!pins_.awvalid) {
    pins_.awvalid = aw && next_aw_ < writes_.size();
    pins_.awaddr = pins_.awvalid ? writes_[next_aw_].address : random_.word();
  }
  if (!pins_.wvalid) {
    pins_.wvalid = w && next_w_ < writes_.size();
    pins_.wdata = pins_.wvalid ? writes_[next_w_].data : random_.word();
    pins_.wstrb = pins_.wvalid ? writes_[next_w_].strobe : random_.word() & 0xF;
  }
  if (!pins_.arvalid) {
    pins_.arvalid = ar && next_ar_ < reads_.size();
    pins_.araddr = pins_.arvalid ? reads_[next_ar_] : random_.word();
  }
  pins_.bready = throttles_.b.willing();
  pins_.rready = throttles_.r.willing();
  return pins_;
}

void AxiLiteDriver::accept(const cores::AxiLiteSlavePins& slave, std::uint64_t cycle) {
  if (pins_.awvalid && slave.awready) {
    pins_.awvalid = false;
    ++next_aw_;
  }
  if (pins_.wvalid && slave.wready) {
    pins_.wvalid = false;
    ++next_w_;
  }
  if (pins_.arvalid && slave.arready) {
    pins_.arvalid = false;
    ++next_ar_;
  }
  if (slave.bvalid && pins_.bready) written_.push_back({slave.bresp, 0, cycle});
  if (slave.rvalid && pins_.rready) read_.push_back({slave.rresp, slave.rdata, cycle});
}

bool AxiLiteDriver::idle() const {
  return written_.size() >= writes_.size() && read_.size() >= reads_.size();
}

}  // namespace hwffd::tb
