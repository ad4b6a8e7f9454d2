#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>

#ifdef HWFFD_TRACE
#include <verilated.h>
#include <verilated_fst_c.h>
#endif

namespace hwffd::cores {

/// The clocks that a waveform shows, from the first on: some 50 MB. A mesh of thousands of vertices
/// at the schedule of the paper takes millions of clocks.
inline constexpr std::uint64_t kTracedClocks = 100'000;

#ifdef HWFFD_TRACE

/// The FST waveform of one Verilated design, where one is wanted. A clock is 10 ns.
class Waveform {
 public:
  /// Whether this build can write waveforms (HWFFD_TRACE).
  static constexpr bool kAvailable = true;

  /// From now on into that file. Throws std::runtime_error where it cannot be made.
  template <class VDut>
  void open(VDut& dut, const std::string& path) {
    dut.contextp()->traceEverOn(true);
    file_ = std::make_unique<VerilatedFstC>();
    dut.trace(file_.get(), kAllLevels);
    file_->set_time_unit("1ns");
    file_->set_time_resolution("1ns");
    file_->open(path.c_str());
    if (!file_->isOpen()) throw std::runtime_error(path + ": cannot write the waveform");
  }

  /// Called with the design settled, once with the clock low and once with it high.
  void half_clock() {
    if (file_ == nullptr) return;
    file_->dump(time_);
    time_ += kHalfClock;
    if (time_ >= 2 * kHalfClock * kTracedClocks) file_.reset();
  }

 private:
  static constexpr int kAllLevels = 99;
  static constexpr std::uint64_t kHalfClock = 5;  // ns

  std::unique_ptr<VerilatedFstC> file_;
  std::uint64_t time_ = 0;
};

#else

/// Stands in where the build has no waveforms; costs nothing.
class Waveform {
 public:
  static constexpr bool kAvailable = false;

  template <class VDut>
  void open(VDut& /*dut*/, const std::string& path) {
    throw std::logic_error(path + ": this build writes no waveforms");
  }
  void half_clock() {}
};

#endif

}  // namespace hwffd::cores
