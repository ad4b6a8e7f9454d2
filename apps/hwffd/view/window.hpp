#pragma once

#include <exception>
#include <string>

#include "view/input.hpp"

struct GLFWwindow;

namespace hwffd::view {

/// The one window of the program, with an OpenGL context that is current: of the compatibility
/// profile, with four samples a pixel where there are as many. Esc closes it.
class Window {
 public:
  /// @throws Error, one line, where there is no display or no OpenGL
  Window(const std::string& title, int width, int height);
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;
  ~Window();

  /// Tells `input` what the user has done; waits until that is something.
  /// @throws what `input` throws
  void wait(Input& input);
  /// The same without waiting.
  void poll(Input& input);

  bool closed() const;
  void set_title(const std::string& title);
  /// Shows what has been drawn.
  void swap();
  /// Sets the viewport to the whole window and returns width by height.
  double whole_viewport();

 private:
  struct Listener;
  void listen(Input& input, void (*events)());

  GLFWwindow* window_ = nullptr;
  Pixels mouse_ = Pixels::Zero();  ///< where the last event had it
  Input* input_ = nullptr;         ///< while it listens
  std::exception_ptr failure_;     ///< of the input; it may not pass through C
};

}  // namespace hwffd::view
