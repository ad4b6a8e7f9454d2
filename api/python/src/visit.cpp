#include "visit.hpp"

#include <pthread.h>

#include <chrono>
#include <condition_variable>
#include <mutex>
#include <new>
#include <thread>

namespace hwffd::python {
namespace {

constexpr std::chrono::seconds kPatience{2};  // with work that does not look

/// Who is in the library.
struct Visits {
  std::mutex mutex;
  std::condition_variable left;
  int inside = 0;
  bool ending = false;
  std::thread::id ender;

  /// With the mutex.
  bool turned_away() const { return ending && std::this_thread::get_id() != ender; }
};

alignas(Visits) unsigned char room[sizeof(Visits)];
Visits* visits = new (room) Visits;  // never destroyed: threads may outlive main()
unsigned forks = 0;

[[noreturn]] void stop_for_good() {
  while (true) std::this_thread::sleep_for(std::chrono::hours(1));
}

void leave() {
  const std::lock_guard<std::mutex> lock(visits->mutex);
  --visits->inside;
  visits->left.notify_all();
}

void end_visits() {
  const py::gil_scoped_release released;
  std::unique_lock<std::mutex> lock(visits->mutex);
  visits->ending = true;
  visits->ender = std::this_thread::get_id();
  visits->left.wait_for(lock, kPatience, [] { return visits->inside == 0; });
}

/// In a child other threads are gone, with whatever they had locked.
void begin_child() {
  ++forks;
  visits = new (room) Visits;
}

}  // namespace

Visit::Visit() : state_(PyEval_SaveThread()) {
  std::unique_lock<std::mutex> lock(visits->mutex);
  if (visits->turned_away()) {
    lock.unlock();
    stop_for_good();
  }
  ++visits->inside;
}

Visit::~Visit() {
  bool away = false;
  {
    const std::lock_guard<std::mutex> lock(visits->mutex);
    away = visits->turned_away();
  }
  if (away) {
    leave();
    stop_for_good();
  }
  PyEval_RestoreThread(state_);
  leave();
}

void check_interpreter() {
  const std::lock_guard<std::mutex> lock(visits->mutex);
  if (visits->turned_away()) throw InterpreterEnds{};
}

void watch_exit() {
  pthread_atfork(nullptr, nullptr, begin_child);
  py::module_::import("atexit").attr("register")(py::cpp_function(&end_visits));
}

unsigned fork_count() { return forks; }

}  // namespace hwffd::python
