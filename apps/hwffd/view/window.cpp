#include "view/window.hpp"

#include <fmt/format.h>

// OpenGL's declarations come from picture/opengl.hpp.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <utility>

#include "hwffd/error.hpp"
#include "picture/opengl.hpp"

namespace hwffd::view {
namespace {

constexpr int kSamples = 4;

Error no_window() {
  const char* why = nullptr;
  glfwGetError(&why);
  return Error(fmt::format("no window here: {}; set DISPLAY to a screen, or use hwffd deform",
                           why == nullptr ? "GLFW does not say why" : why));
}

}  // namespace

/// GLFW's callbacks, handed on to the window's input.
struct Window::Listener {
  template <typename Tell>
  static void tell(GLFWwindow* handle, Tell tell) {
    Window& window = *static_cast<Window*>(glfwGetWindowUserPointer(handle));
    if (window.input_ == nullptr || window.failure_) return;
    try {
      tell(*window.input_);
    } catch (...) {
      window.failure_ = std::current_exception();
    }
  }

  static void on_button(GLFWwindow* handle, int which, int action, int) {
    const Button button = which == GLFW_MOUSE_BUTTON_LEFT ? Button::kFirst : Button::kOther;
    // Where the mouse was by then: by now, which GLFW could say, it may be elsewhere.
    const Pixels mouse = static_cast<Window*>(glfwGetWindowUserPointer(handle))->mouse_;
    tell(handle, [&](Input& input) {
      if (action == GLFW_PRESS) {
        input.press(button, mouse);
      } else {
        input.release(button);
      }
    });
  }

  static void on_key(GLFWwindow* handle, int key, int, int action, int) {
    if (action != GLFW_PRESS) return;
    if (key == GLFW_KEY_ESCAPE) glfwSetWindowShouldClose(handle, GLFW_TRUE);
    if (key == GLFW_KEY_S) tell(handle, [](Input& input) { input.key(Key::kSave); });
    if (key == GLFW_KEY_R) tell(handle, [](Input& input) { input.key(Key::kReset); });
  }

  static void on_move(GLFWwindow* handle, double x, double y) {
    static_cast<Window*>(glfwGetWindowUserPointer(handle))->mouse_ = Pixels(x, y);
    tell(handle, [&](Input& input) { input.move(Pixels(x, y)); });
  }

  static void on_wheel(GLFWwindow* handle, double, double steps) {
    tell(handle, [&](Input& input) { input.wheel(steps); });
  }

  static void on_resize(GLFWwindow* handle, int width, int height) {
    tell(handle, [&](Input& input) { input.resize(width, height); });
  }

  /// The window was uncovered: what it shows must be drawn again.
  static void on_refresh(GLFWwindow* handle) {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(handle, &width, &height);
    on_resize(handle, width, height);
  }
};

Window::Window(const std::string& title, int width, int height) {
  if (glfwInit() == GLFW_FALSE) throw no_window();
  glfwWindowHint(GLFW_SAMPLES, kSamples);
  window_ = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  if (window_ == nullptr) {
    const Error error = no_window();
    glfwTerminate();
    throw error;
  }
  glfwMakeContextCurrent(window_);
  glfwSwapInterval(1);
  glfwSetWindowUserPointer(window_, this);
  glfwSetMouseButtonCallback(window_, Listener::on_button);
  glfwSetKeyCallback(window_, Listener::on_key);
  glfwSetCursorPosCallback(window_, Listener::on_move);
  glfwSetScrollCallback(window_, Listener::on_wheel);
  glfwSetWindowSizeCallback(window_, Listener::on_resize);
  glfwSetWindowRefreshCallback(window_, Listener::on_refresh);
}

Window::~Window() { glfwTerminate(); }

void Window::listen(Input& input, void (*events)()) {
  input_ = &input;
  events();
  input_ = nullptr;
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Window::wait(Input& input) { listen(input, glfwWaitEvents); }
void Window::poll(Input& input) { listen(input, glfwPollEvents); }

bool Window::closed() const { return glfwWindowShouldClose(window_) != GLFW_FALSE; }
void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
void Window::swap() { glfwSwapBuffers(window_); }

double Window::whole_viewport() {
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  glViewport(0, 0, width, height);
  return height > 0 ? static_cast<double>(width) / height : 1.0;
}

}  // namespace hwffd::view
