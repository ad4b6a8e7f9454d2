#include <fmt/format.h>

#include <algorithm>

#include "device/stream_device.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"

namespace hwffd {
namespace {

constexpr std::uint64_t kSeed = 1;              // of the registers before reset
constexpr std::uint64_t kPatience = 1'000'000;  // clocks without a beat

class RtlStream final : public CommandStream {
 public:
  explicit RtlStream(const Configuration& row)
      : name_(row.name), core_(cores::make_stream_core(row, kSeed)) {
    reset();
  }

  void reset() override {
    core_->drive_reset(true);
    core_->drive_input(false, {});
    core_->drive_output_ready(true);
    for (int edge = 0; edge < 4; ++edge) {
      core_->settle();
      clock();
    }
    core_->drive_reset(false);
  }

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress) override {
    std::vector<Beat> out;
    out.reserve(results);
    const std::size_t step = results / 100 + 1;
    std::size_t next = 0;
    std::uint64_t moved = clocks_;
    // Until it is idle: a result that nobody asked for must not be left for the next run.
    while (next < commands.size() || out.size() < results ||
           (out.size() == results && !core_->idle())) {
      core_->drive_input(next < commands.size(), next < commands.size() ? commands[next] : Beat{});
      core_->settle();
      const bool accepted = next < commands.size() && core_->input_ready();
      if (core_->output_valid()) {
        out.push_back(core_->output());
        if (out.size() % step == 0) {
          progress(std::min(1.0, static_cast<double>(out.size()) / results));
        }
        moved = clocks_;
      }
      clock();
      if (accepted) {
        ++next;
        moved = clocks_;
      }
      if (clocks_ - moved > kPatience) {
        throw Error(
            fmt::format("{}: {} of {} results came, then none for {} clocks; this is a "
                        "fault of the hardware: please report it",
                        name_, out.size(), results, kPatience));
      }
    }
    core_->drive_input(false, {});
    progress(1);
    return out;
  }

  std::uint64_t clocks() const override { return clocks_; }

 private:
  void clock() {
    core_->clock();
    ++clocks_;
  }

  std::string name_;
  std::unique_ptr<cores::StreamCore> core_;
  std::uint64_t clocks_ = 0;
};

}  // namespace

std::unique_ptr<CommandStream> rtl_stream(const Configuration& row) {
  return std::make_unique<RtlStream>(row);
}

}  // namespace hwffd
