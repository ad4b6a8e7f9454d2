#include "view/controls.hpp"

#include <cmath>

namespace hwffd::view {
namespace {

constexpr double kRadiansPerPixel = 0.008;
constexpr double kZoomPerStep = 1.1;

}  // namespace

Controls::Controls(LatticeDrag drag, Orbit orbit, int width, int height,
                   std::function<void(const Lattice&)> save)
    : drag_(std::move(drag)),
      orbit_(std::move(orbit)),
      width_(width),
      height_(height),
      save_(std::move(save)) {}

void Controls::press(Button button, const Pixels& mouse) {
  if (button == Button::kFirst && !turning_) {
    drag_.grab(screen(), mouse);
  } else if (button == Button::kOther && !drag_.holds()) {
    turning_ = mouse;
  }
}

void Controls::release(Button button) {
  if (button == Button::kFirst) {
    drag_.release();
  } else {
    turning_.reset();
  }
}

void Controls::move(const Pixels& mouse) {
  if (drag_.holds()) {
    drag_.drag(screen(), mouse);
    lattice_moved();
  } else if (turning_) {
    const Pixels way = kRadiansPerPixel * (mouse - *turning_);
    orbit_.turn(way.x(), way.y());
    turning_ = mouse;
    changed_ = true;
  }
}

void Controls::wheel(double steps) {
  if (drag_.holds()) return;
  orbit_.zoom(std::pow(kZoomPerStep, steps));
  changed_ = true;
}

void Controls::key(Key key) {
  if (key == Key::kSave) {
    save_(lattice());
  } else {
    drag_.reset();
    lattice_moved();
  }
}

void Controls::resize(int width, int height) {
  if (width < 1 || height < 1) return;
  width_ = width;
  height_ = height;
  changed_ = true;
}

}  // namespace hwffd::view
