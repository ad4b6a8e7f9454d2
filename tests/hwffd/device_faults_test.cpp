// Devices that were interrupted, answers that are not what was asked for, and numbers that a format
// does not hold.

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>

#include "device/stream_device.hpp"
#include "errors.hpp"
#include "hwffd/cores/stream_core.hpp"
#include "hwffd/error.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"

namespace hwffd {
namespace {

const Points kCorners = (Points(2, 3) << -1, -1, -1, 1, 1, 1).finished();

Lattice box() { return lattice_around("box", kCorners, {5, 5, 5}); }

/// More than a packet, so that packets and tags repeat.
std::vector<Embedded> places(std::size_t count) {
  std::vector<Embedded> vertices(count);
  for (std::size_t v = 0; v < count; ++v) {
    vertices[v].cell = {static_cast<int>(v % 2), static_cast<int>(v / 2 % 2), 0};
    vertices[v].local = Eigen::Vector3d((v % 7) / 7.0, (v % 11) / 11.0, (v % 13) / 13.0);
  }
  return vertices;
}

struct Stop : std::runtime_error {
  using std::runtime_error::runtime_error;
};

TEST(DeviceFaults, AnInterruptedDeviceIsAsNew) {
  const Lattice lattice = Deformation::parse("random:3").apply(box());
  for (const char* kind : {"model", "rtl"}) {
    const std::unique_ptr<Device> device = make_device({kind, "basic", "fp32"});
    const Points expected = make_device({"model", "basic", "fp32"})->evaluate(lattice, places(300));
    for (const double when : {0.0, 0.3, 0.9}) {
      device->on_progress([&](double done) {
        if (done >= when) throw Stop("enough");
      });
      EXPECT_THROW(device->evaluate(lattice, places(300)), Stop) << kind;
      device->on_progress({});
      EXPECT_EQ(device->evaluate(lattice, places(300)), expected) << kind << " at " << when;
    }
  }
}

TEST(DeviceFaults, AnInterruptedPullBackLeavesNothingInTheSums) {
  const Index3 dims{5, 5, 5};
  const Points gradient = Points::Random(300, 3);
  const Points expected = make_pull_back_device("model")->pull_back(dims, places(300), gradient);
  const std::unique_ptr<Device> device = make_pull_back_device("rtl");
  for (const double when : {0.0, 0.3, 0.9}) {
    device->on_progress([&](double done) {
      if (done >= when) throw Stop("enough");
    });
    EXPECT_THROW(device->pull_back(dims, places(300), gradient), Stop);
    device->on_progress({});
    EXPECT_EQ(device->pull_back(dims, places(300), gradient), expected) << when;
  }
}

/// A core that takes all it is given, and gives some beats, or is never idle.
class SilentCore final : public cores::StreamCore {
 public:
  explicit SilentCore(int gives) : gives_(gives) {}

  void drive_reset(bool /*asserted*/) override {}
  void drive_input(bool valid, const Beat& /*beat*/) override { asked_ = asked_ || valid; }
  void drive_output_ready(bool /*ready*/) override {}
  void settle() override {}
  void clock() override { gives_ -= output_valid() ? 1 : 0; }
  bool input_ready() const override { return true; }
  bool output_valid() const override { return asked_ && gives_ > 0; }
  Beat output() const override { return {}; }
  bool idle() const override { return false; }

 private:
  int gives_;
  bool asked_ = false;
};

TEST(DeviceFaults, ACoreThatFallsSilentIsAFault) {
  const Configuration& row = find_configuration("basic-fp32-overlapped");
  for (const int came : {0, 7, 20}) {
    StreamDevice device("rtl", row, rtl_stream(std::make_unique<SilentCore>(came), row.name, {}));
    EXPECT_ERROR(device.evaluate(box(), places(20)),
                 "basic-fp32-overlapped: " + std::to_string(came) +
                     " of 20 results came, then none for 1000000 clocks; this is a fault of the "
                     "hardware: please report it");
  }
}

/// A model whose answer is spoilt.
class SpoiltStream final : public CommandStream {
 public:
  using Spoil = std::function<void(std::vector<Beat>&)>;

  SpoiltStream(const Configuration& row, const Spoil& spoil, int& resets)
      : model_(model_stream(row)), spoil_(spoil), resets_(resets) {}

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress, std::size_t steps) override {
    std::vector<Beat> beats = model_->run(commands, results, progress, steps);
    spoil_(beats);
    return beats;
  }
  void reset() override {
    ++resets_;
    model_->reset();
  }

 private:
  std::unique_ptr<CommandStream> model_;
  const Spoil& spoil_;
  int& resets_;
};

TEST(DeviceFaults, ResultsThatWereNotAskedForAreAFault) {
  const Configuration& row = find_configuration("basic-fp32-overlapped");
  SpoiltStream::Spoil spoil;
  int resets = 0;
  StreamDevice device("spoilt", row, std::make_unique<SpoiltStream>(row, spoil, resets));
  const SpoiltStream::Spoil spoilt[] = {
      [](auto& beats) { beats.pop_back(); },
      [](auto& beats) { beats.push_back(beats.back()); },
      [](auto& beats) { std::swap(beats[3], beats[5]); },
      [](auto& beats) { beats[1030].words[3] ^= 1; },
      [](auto& beats) { beats[1023].last = false; },
      [](auto& beats) { beats[700].last = true; },
      [](auto&) { throw Error("no answer"); },
  };
  const std::vector<Embedded> vertices = places(1500);
  spoil = [](auto&) {};
  const Points good = device.evaluate(box(), vertices);
  EXPECT_EQ(resets, 0);
  int expected = 0;
  for (const SpoiltStream::Spoil& fault : spoilt) {
    spoil = fault;
    EXPECT_THROW(device.evaluate(box(), vertices), Error) << "answer " << expected;
    EXPECT_EQ(resets, ++expected);
    spoil = [](auto&) {};
    EXPECT_EQ(device.evaluate(box(), vertices), good);
    EXPECT_EQ(device.tangents(box(), vertices).positions, good);
  }
}

/// A model with pages that fails once, and says that its reset has failed, too.
class FailingStream final : public CommandStream {
 public:
  FailingStream(const Configuration& row, const bool& fails)
      : model_(model_stream(row, kStore)), fails_(fails) {}

  std::vector<Beat> run(const std::vector<Beat>& commands, std::size_t results,
                        const Progress& progress, std::size_t steps) override {
    if (fails_) throw Error("no answer");
    return model_->run(commands, results, progress, steps);
  }
  void reset() override {
    model_->reset();
    if (fails_) throw Error("no reset");
  }
  PointStore store() const override { return kStore; }

 private:
  static constexpr PointStore kStore{7, 4, false};
  std::unique_ptr<CommandStream> model_;
  const bool& fails_;
};

TEST(DeviceFaults, PagesAreSentAgainAfterAResetThatFails) {
  const Configuration& row = find_configuration("basic-fx18-overlapped");
  bool fails = false;
  StreamDevice device("failing", row, std::make_unique<FailingStream>(row, fails));
  const Points good = device.evaluate(box(), places(20));
  fails = true;
  EXPECT_THROW(device.evaluate(box(), places(20)), Error);
  fails = false;
  EXPECT_EQ(device.evaluate(box(), places(20)), good);
}

TEST(DeviceFaults, NumbersThatAFormatDoesNotHoldAreNoResults) {
  const Points far = box().points() * 1e39;
  const Lattice lattice({5, 5, 5}, far);
  for (const DeviceChoice& choice :
       {DeviceChoice{"model", "basic", "fp32"}, DeviceChoice{"model", "basic", "bfp32"},
        DeviceChoice{"rtl", "basic", "fp32"}}) {
    const std::unique_ptr<Device> device = make_device(choice);
    EXPECT_THROW(device->evaluate(lattice, places(10)), Error) << device->name();
    EXPECT_THROW(device->tangents(lattice, places(10)), Error) << device->name();
  }
  for (const char* format : {"fx18", "fx32"}) {
    EXPECT_TRUE(make_device({"model", "basic", format})->evaluate(lattice, places(10)).allFinite());
  }
  EXPECT_TRUE(make_device({"reference", "", ""})->evaluate(lattice, places(10)).allFinite());
  // A sum of them that is held, with differences that are not.
  Points apart = far;
  for (Eigen::Index row = 0; row < apart.rows(); ++row) {
    apart.row(row).setConstant(row / 25 % 4 < 2 ? -3e38 : 3e38);
  }
  const std::vector<Embedded> middle{{{0, 0, 0}, {0.5, 0.5, 0.5}}};
  const std::unique_ptr<Device> single = make_device({"model", "basic", "fp32"});
  EXPECT_TRUE(single->evaluate(Lattice({5, 5, 5}, apart), middle).allFinite());
  EXPECT_ERROR_PART(single->tangents(Lattice({5, 5, 5}, apart), middle),
                    "vertex 0: the result is not finite; the control points are too large");
  const Device::Blending none{Eigen::Matrix4d::Constant(NAN), Oracle::linear(), Oracle::linear()};
  for (const char* format : {"fp32", "bfp32", "fx18"}) {
    EXPECT_THROW(make_device({"model", "basic", format})->evaluate(box(), places(3), none), Error)
        << format;
  }
}

}  // namespace
}  // namespace hwffd
