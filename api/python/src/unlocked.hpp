#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <mutex>

#include "hwffd/on_threads.hpp"

namespace hwffd::python {

namespace py = pybind11;

/// While it lives, other threads of Python run, and Ctrl-C ends the work of this one: a Watch looks
/// for signals.
class Unlocked {
 public:
  Unlocked() : watch_(check_signals) {}

 private:
  static void check_signals() {
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

  py::gil_scoped_release released_;
  Watch watch_;
};

/// A mutex that is waited for without the interpreter's lock, and no longer than until Ctrl-C.
class Turn {
 public:
  explicit Turn(std::timed_mutex& mutex) : lock_(mutex, std::defer_lock) {
    while (!lock_.try_lock_for(std::chrono::milliseconds(50))) Watch::look();
  }

 private:
  Unlocked unlocked_;
  std::unique_lock<std::timed_mutex> lock_;
};

}  // namespace hwffd::python
