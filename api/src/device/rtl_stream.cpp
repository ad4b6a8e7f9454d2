#include <fmt/format.h>

#include "device/stream_device.hpp"
#include "hwffd/cores/scatter_core_factory.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/cores/stream_loop.hpp"
#include "hwffd/error.hpp"

namespace hwffd {
namespace {

constexpr std::uint64_t kSeed = 1;              // of the registers before reset
constexpr std::uint64_t kPatience = 1'000'000;  // clocks without a beat
constexpr int kResetClocks = 4;

// Offers the commands one after the other and takes every result at once.
class Conversation final : public cores::StreamParty {
 public:
  Conversation(cores::StreamLoop& loop, const cores::StreamCore& core,
               const std::vector<Beat>& commands, std::size_t results)
      : loop_(loop), core_(core), commands_(commands), results_(results) {
    out_.reserve(results);
  }

  bool one_cycle() override {
    const bool offered = next_ < commands_.size();
    const cores::StreamPins& pins = loop_.drive(offered, offered ? commands_[next_] : Beat{}, true);
    const bool accepted = offered && pins.input_ready;
    if (accepted) ++next_;
    if (pins.output_valid) out_.push_back(pins.output);
    const bool moved = accepted || pins.output_valid;
    loop_.clock();
    return moved;
  }
  // Until it is idle: a result that nobody asked for must not be left for the next run.
  std::uint64_t left() const override {
    const std::size_t missing = out_.size() < results_ ? results_ - out_.size() : 0;
    const std::size_t beats = commands_.size() - next_ + missing;
    return beats != 0 || out_.size() > results_ || core_.idle() ? beats : 1;
  }

  std::vector<Beat> take() { return std::move(out_); }
  std::size_t came() const { return out_.size(); }

 private:
  cores::StreamLoop& loop_;
  const cores::StreamCore& core_;
  const std::vector<Beat>& commands_;
  std::size_t results_;
  std::size_t next_ = 0;
  std::vector<Beat> out_;
};

class RtlStream final : public CommandStream {
 public:
  RtlStream(std::unique_ptr<cores::StreamCore> core, const std::string& name,
            const PointStore& store, bool grids)
      : name_(name), core_(std::move(core)), loop_(*core_), store_(store), grids_(grids) {
    reset();
  }

  void reset() override {
    loop_.reset(true);
    for (int edge = 0; edge < kResetClocks; ++edge) {
      loop_.drive(false, {}, true);
      loop_.clock();
    }
    loop_.reset(false);
  }

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress, std::size_t /*steps*/) override {
    Conversation conversation(loop_, *core_, commands, results);
    if (loop_.run(conversation, {kPatience}, progress) == cores::StreamEnd::kStalled) {
      throw Error(
          fmt::format("{}: {} of {} results came, then none for {} clocks; this is a "
                      "fault of the hardware: please report it",
                      name_, conversation.came(), results, kPatience));
    }
    return conversation.take();
  }

  std::uint64_t clocks() const override { return loop_.clocks(); }
  PointStore store() const override { return store_; }
  bool has_grids() const override { return grids_; }

 private:
  std::string name_;
  std::unique_ptr<cores::StreamCore> core_;
  cores::StreamLoop loop_;
  PointStore store_;
  bool grids_;
};

}  // namespace

std::unique_ptr<CommandStream> rtl_stream(const Configuration& row) {
  return rtl_stream(cores::make_stream_core(row, kSeed), row.name, {});
}

std::unique_ptr<CommandStream> rtl_scatter_stream(bool rows, const std::string& name) {
  return rtl_stream(cores::make_scatter_core(rows, kSeed), name, {});
}

std::unique_ptr<CommandStream> rtl_stream(std::unique_ptr<cores::StreamCore> core,
                                          const std::string& name, const PointStore& store,
                                          bool grids) {
  return std::make_unique<RtlStream>(std::move(core), name, store, grids);
}

}  // namespace hwffd
