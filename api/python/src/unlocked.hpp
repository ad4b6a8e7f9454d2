#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <mutex>
#include <thread>

#include "hwffd/error.hpp"
#include "hwffd/on_threads.hpp"
#include "visit.hpp"

namespace hwffd::python {

/// While it lives, other threads of Python run, and Ctrl-C ends the work of this one: a Watch looks
/// for signals.
class Unlocked {
 public:
  Unlocked() : watch_(check_signals) {}

 private:
  static void check_signals() {
    check_interpreter();
    const py::gil_scoped_acquire locked;
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }

  Visit visit_;
  Watch watch_;
};

/// A mutex that knows which thread of which process has it.
class OwnedMutex {
 public:
  void lock() {
    mutex_.lock();
    take();
  }
  template <typename Duration>
  bool try_lock_for(const Duration& duration) {
    const bool locked = mutex_.try_lock_for(duration);
    if (locked) take();
    return locked;
  }
  void unlock() {
    owner_ = kNobody;
    holder_ = std::thread::id();
    mutex_.unlock();
  }

  /// Whether this thread has it, which would wait for itself.
  bool is_mine() const { return owner_ == fork_count() && holder_ == std::this_thread::get_id(); }

  /// Whether a thread has it that this process was forked without.
  bool orphaned() const { return owner_ != kNobody && owner_ != fork_count(); }

 private:
  static constexpr unsigned kNobody = ~0U;

  void take() {
    holder_ = std::this_thread::get_id();
    owner_ = fork_count();
  }

  std::timed_mutex mutex_;
  std::atomic<unsigned> owner_{kNobody};
  std::atomic<std::thread::id> holder_{};
};

/// A mutex that is waited for without the interpreter's lock, and no longer than until Ctrl-C.
class Turn {
 public:
  /// @throws Error if no thread of this process will ever unlock it, or none but this one
  explicit Turn(OwnedMutex& mutex) : lock_(mutex, std::defer_lock) {
    if (mutex.is_mine()) {
      throw Error(
          "this lattice is at work in a call of this thread; in progress= and in handlers of "
          "signals use a copy, made before");
    }
    while (!lock_.try_lock_for(std::chrono::milliseconds(50))) {
      if (mutex.orphaned()) {
        throw Error(
            "another thread was using this lattice when the process was forked; make the lattice "
            "again in the child, or start children by spawn");
      }
      Watch::look();
    }
  }

 private:
  Unlocked unlocked_;
  std::unique_lock<OwnedMutex> lock_;
};

}  // namespace hwffd::python
