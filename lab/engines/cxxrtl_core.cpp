// The core that yosys has written as C++ (CXXRTL), of one row: HWFFD_CXXRTL_HEADER, HWFFD_ROW.

#include HWFFD_CXXRTL_HEADER

#include <stdexcept>

#include "hwffd/cores/stream_core_factory.hpp"

namespace hwffd::cores {
namespace {

class CxxrtlStreamCore final : public StreamCore {
 public:
  CxxrtlStreamCore() {
    dut_.p_aclk.set(false);
    dut_.p_aresetn.set(false);
    drive_input(false, {});
    drive_output_ready(false);
    dut_.step();
  }

  void drive_reset(bool asserted) override { dut_.p_aresetn.set(!asserted); }
  void drive_input(bool valid, const Beat& beat) override {
    dut_.p_s__axis__tvalid.set(valid);
    for (std::size_t i = 0; i < beat.words.size(); ++i) {
      dut_.p_s__axis__tdata.data[i] = beat.words[i];
    }
    dut_.p_s__axis__tlast.set(beat.last);
  }
  void drive_output_ready(bool ready) override { dut_.p_m__axis__tready.set(ready); }

  void settle() override {
    dut_.p_aclk.set(false);
    dut_.step();
  }
  void clock() override {
    settle();
    dut_.p_aclk.set(true);
    dut_.step();
  }

  bool input_ready() const override { return dut_.p_s__axis__tready.get<bool>(); }
  bool output_valid() const override { return dut_.p_m__axis__tvalid.get<bool>(); }
  Beat output() const override {
    Beat beat;
    for (std::size_t i = 0; i < beat.words.size(); ++i) {
      beat.words[i] = dut_.p_m__axis__tdata.data[i];
    }
    beat.last = dut_.p_m__axis__tlast.get<bool>();
    return beat;
  }
  std::uint32_t events() const override { return dut_.p_event__o.get<std::uint32_t>(); }
  bool idle() const override { return dut_.p_idle__o.get<bool>(); }

 private:
  cxxrtl_design::p_hwffd__stream dut_;
};

}  // namespace

bool stream_cores_can_trace() { return false; }

bool has_stream_core(const Configuration& row) { return row.name == std::string(HWFFD_ROW); }

std::unique_ptr<StreamCore> make_stream_core(const Configuration& row, std::uint64_t /*seed*/,
                                             const std::string& /*trace*/) {
  if (!has_stream_core(row)) throw std::invalid_argument("this program has " HWFFD_ROW " only");
  return std::make_unique<CxxrtlStreamCore>();
}

}  // namespace hwffd::cores
