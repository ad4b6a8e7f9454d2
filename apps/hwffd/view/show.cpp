#include "view/show.hpp"

#include <fmt/format.h>

#include <chrono>

#include "hwffd/device/deformer.hpp"
#include "picture/lattice_drawing.hpp"
#include "picture/mesh_drawing.hpp"
#include "picture/studio.hpp"
#include "view/controls.hpp"
#include "view/window.hpp"

namespace hwffd::view {
namespace {

constexpr int kWidth = 1000;
constexpr int kHeight = 750;
constexpr double kAspect = static_cast<double>(kWidth) / kHeight;

/// Frames a second, from the time that recent ones took.
class FrameRate {
 public:
  void begin() { begin_ = Clock::now(); }
  void end() {
    const double seconds = std::chrono::duration<double>(Clock::now() - begin_).count();
    mean_ = mean_ == 0 ? seconds : mean_ + kNewest * (seconds - mean_);
  }
  double value() const { return 1 / mean_; }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr double kNewest = 0.2;  // weight of the newest frame

  Clock::time_point begin_;
  double mean_ = 0;
};

}  // namespace

void show(Scene scene, Device& device, const std::function<void(const Lattice&)>& save) {
  const Deformer deformer(scene.mesh.positions(), nullptr, {{scene.rest, scene.family}},
                          scene.outside);
  const Orbit orbit(scene.deformed.points(), Point(0.35, 0.3, 1), kAspect);
  Controls controls(LatticeDrag(scene.deformed, scene.family), orbit, kWidth, kHeight, save);
  const std::string title = scene.mesh.name() + " - " + device.name();
  Window window(title, kWidth, kHeight);
  FrameRate rate;
  while (!window.closed()) {
    if (!controls.take_changed()) {
      window.wait(controls);
      continue;
    }
    rate.begin();
    if (controls.take_lattice_moved()) {
      // Normals from the faces: derivatives would cost a frame four times the evaluations.
      const Deformer::Result result =
          deformer.deform({controls.lattice()}, device, Deformer::Gradients::kNone);
      scene.mesh.set_positions(result.positions);
    }
    const double aspect = window.whole_viewport();
    picture::draw_studio(controls.camera(), aspect, [&] {
      picture::draw_mesh(scene.mesh);
      picture::draw_lattice(controls.lattice());
    });
    window.swap();
    rate.end();
    window.set_title(fmt::format("{} - {:.0f} frames/s", title, rate.value()));
    window.poll(controls);
  }
}

}  // namespace hwffd::view
