#include "hwffd/on_threads.hpp"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

namespace hwffd {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds kPatience{50};

std::atomic<std::size_t> wanted{0};
thread_local Watch* innermost = nullptr;
thread_local Clock::time_point looked;

/// The work of one call of on_threads().
class Job {
 public:
  /// What a worker throws when the others are to end, too; nobody sees it.
  struct Stopped {};

  /// The job that this thread works on for another; null for a thread that does its own.
  static thread_local const Job* at_work;

  void go_on() const {
    if (stopped_) throw Stopped{};
  }

  Job(std::size_t count, const std::function<void(std::size_t)>& work,
      const std::function<void(std::size_t)>& progress)
      : count_(count), work_(work), progress_(progress) {}

  void run_here() {
    for (std::size_t i = 0; i < count_; ++i) {
      work_(i);
      progress_(i + 1);
      Watch::look();
    }
  }

  void run_on(std::size_t threads) {
    {
      Team team(*this);
      for (running_ = threads; team.threads.size() < threads;) {
        team.threads.emplace_back([this] { loop(); });
      }
      wait();
    }
    if (thrown_) std::rethrow_exception(thrown_);
    Watch::look();  // many short jobs are one long one
  }

 private:
  /// Threads that are waited for, whatever happens to the one that made them.
  struct Team {
    explicit Team(Job& of) : job(of) {}
    ~Team() {
      job.stop();
      for (std::thread& thread : threads) thread.join();
    }
    Job& job;
    std::vector<std::thread> threads;
  };

  void stop() {
    next_ = count_;
    stopped_ = true;
  }

  void loop() {
    at_work = this;
    for (std::size_t i = next_++; i < count_; i = next_++) {
      try {
        work_(i);
        const std::lock_guard<std::mutex> lock(mutex_);
        ++done_;
        changed_.notify_one();
      } catch (...) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (!thrown_) thrown_ = std::current_exception();
        stop();
      }
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    --running_;
    changed_.notify_one();
  }

  void wait() {
    std::unique_lock<std::mutex> lock(mutex_);
    for (std::size_t shown = 0; running_ > 0 || (shown < done_ && !thrown_);) {
      changed_.wait_for(lock, kPatience, [&] { return running_ == 0 || shown < done_; });
      const bool more = shown < done_ && !thrown_;
      shown = done_;
      lock.unlock();
      if (more) progress_(shown);
      Watch::look();
      lock.lock();
    }
  }

  std::size_t count_;
  const std::function<void(std::size_t)>& work_;
  const std::function<void(std::size_t)>& progress_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> stopped_{false};
  std::mutex mutex_;
  std::condition_variable changed_;
  std::exception_ptr thrown_;
  std::size_t done_ = 0;
  std::size_t running_ = 0;
};

thread_local const Job* Job::at_work = nullptr;

}  // namespace

std::size_t thread_count() {
  const std::size_t count = wanted;
  return count > 0 ? count : std::max(1U, std::thread::hardware_concurrency());
}

void set_thread_count(std::size_t count) { wanted = count; }

void on_threads(std::size_t count, const std::function<void(std::size_t)>& work,
                const std::function<void(std::size_t done)>& progress) {
  const std::size_t threads = Job::at_work == nullptr ? std::min(thread_count(), count) : 1;
  Job job(count, work, progress);
  if (threads <= 1) {
    job.run_here();
  } else {
    job.run_on(threads);
  }
}

void on_ranges(std::size_t count, std::size_t size,
               const std::function<void(std::size_t first, std::size_t end)>& work) {
  on_threads((count + size - 1) / size,
             [&](std::size_t range) { work(range * size, std::min(count, (range + 1) * size)); });
}

Watch::Watch(std::function<void()> check) : check_(std::move(check)), outer_(innermost) {
  innermost = this;
}

Watch::~Watch() { innermost = outer_; }

void Watch::look() {
  if (Job::at_work != nullptr) Job::at_work->go_on();
  if (innermost == nullptr) return;
  const Clock::time_point now = Clock::now();
  if (now - looked < kPatience) return;
  looked = now;
  innermost->check_();
}

}  // namespace hwffd
