#pragma once

#include <functional>
#include <optional>
#include <utility>

#include "view/input.hpp"
#include "view/lattice_drag.hpp"
#include "view/orbit.hpp"

namespace hwffd::view {

/// What the user's mouse and keys do: the first button drags control points, the other turns the
/// view, the wheel zooms, S saves, R resets the lattice. It knows no window and draws nothing.
class Controls final : public Input {
 public:
  /// @param width, height  of the window in pixels
  /// @param save  what S does with the lattice
  Controls(LatticeDrag drag, Orbit orbit, int width, int height,
           std::function<void(const Lattice&)> save);

  void press(Button button, const Pixels& mouse) override;
  void release(Button button) override;
  void move(const Pixels& mouse) override;
  void wheel(double steps) override;
  void key(Key key) override;
  void resize(int width, int height) override;

  const Lattice& lattice() const { return drag_.lattice(); }
  picture::Camera camera() const { return orbit_.camera(); }

  /// Whether the lattice has been moved since this was asked last; true the first time.
  bool take_lattice_moved() { return std::exchange(lattice_moved_, false); }
  /// Whether there is anything new to see since this was asked last; true the first time.
  bool take_changed() { return std::exchange(changed_, false); }

 private:
  Screen screen() const { return Screen(camera(), width_, height_); }
  void lattice_moved() { lattice_moved_ = changed_ = true; }

  LatticeDrag drag_;
  Orbit orbit_;
  int width_;
  int height_;
  std::function<void(const Lattice&)> save_;
  std::optional<Pixels> turning_;  ///< where the mouse was last, while it turns the view
  bool lattice_moved_ = true;
  bool changed_ = true;
};

}  // namespace hwffd::view
