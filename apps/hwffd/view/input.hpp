#pragma once

#include "view/screen.hpp"

namespace hwffd::view {

enum class Button { kFirst, kOther };  ///< the left one; any other
enum class Key { kSave, kReset };      ///< S; R

/// What a window hears from its user. Places are pixels of the window.
class Input {
 public:
  virtual ~Input() = default;
  virtual void press(Button button, const Pixels& mouse) = 0;
  virtual void release(Button button) = 0;
  virtual void move(const Pixels& mouse) = 0;
  /// @param steps  of the wheel, away from the user
  virtual void wheel(double steps) = 0;
  virtual void key(Key key) = 0;
  virtual void resize(int width, int height) = 0;
};

}  // namespace hwffd::view
