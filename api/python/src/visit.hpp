#pragma once

#include <pybind11/pybind11.h>

namespace hwffd::python {

namespace py = pybind11;

/// A thread in the library without the interpreter's lock, which it has again afterwards.
///
/// A thread that asks for this lock when the interpreter has ended is ended by Python in the middle
/// of C++, which ends the process. So what watch_exit() has called before the interpreter ends
/// makes work end where it looks, and threads that would come back stop for good.
class Visit {
 public:
  Visit();
  ~Visit();
  Visit(const Visit&) = delete;
  Visit& operator=(const Visit&) = delete;

 private:
  PyThreadState* state_;
};

/// Thrown where work looks when the interpreter is about to end: nobody waits for it any more.
struct InterpreterEnds {};

/// @throws InterpreterEnds, but on the thread that ends the interpreter
void check_interpreter();

/// Once, with the interpreter's lock.
void watch_exit();

/// How many processes this one was forked from since the library was loaded. Of those threads that
/// were at work in them this one has none.
unsigned fork_count();

}  // namespace hwffd::python
