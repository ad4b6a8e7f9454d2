// Work on threads: done once each, the same results however many there are, and an end when asked.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

#include "cube.hpp"
#include "hwffd/lattice/around.hpp"
#include "hwffd/lattice/deformation.hpp"
#include "hwffd/lattice/lattice_evaluator.hpp"
#include "hwffd/lattice/weights.hpp"
#include "hwffd/on_threads.hpp"
#include "same_bits.hpp"
#include "sample_lattices.hpp"

namespace hwffd {
namespace {

class Threads : public ::testing::Test {
 protected:
  ~Threads() override { set_thread_count(0); }
};

TEST_F(Threads, EveryRangeIsDoneOnce) {
  for (const std::size_t threads : {1, 2, 7}) {
    set_thread_count(threads);
    EXPECT_EQ(thread_count(), threads);
    for (const std::size_t count : {0, 1, 9, 10, 11, 1000}) {
      std::vector<std::atomic<int>> done(count);
      on_ranges(count, 10, [&](std::size_t first, std::size_t end) {
        EXPECT_TRUE(first % 10 == 0 && end <= count && end - first <= 10) << first << " " << end;
        for (std::size_t i = first; i < end; ++i) ++done[i];
      });
      for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
    }
  }
}

TEST_F(Threads, ProgressIsOfTheCallingThreadAndRisesToTheEnd) {
  for (const std::size_t threads : {1, 2, 7}) {
    set_thread_count(threads);
    for (const std::size_t count : {1, 9, 1000}) {
      std::vector<std::size_t> shown{0};
      on_threads(
          count, [](std::size_t) {},
          [&, caller = std::this_thread::get_id()](std::size_t done) {
            EXPECT_EQ(std::this_thread::get_id(), caller);
            EXPECT_GT(done, shown.back());
            shown.push_back(done);
          });
      EXPECT_EQ(shown.back(), count) << threads;
    }
  }
}

TEST_F(Threads, ThrowWhatTheWorkThrew) {
  for (const std::size_t threads : {1, 3}) {
    set_thread_count(threads);
    std::atomic<int> begun{0};
    EXPECT_THROW(on_threads(100000,
                            [&](std::size_t i) {
                              ++begun;
                              if (i == 10) throw std::out_of_range("ten");
                            }),
                 std::out_of_range);
    EXPECT_LT(begun, 100000);
  }
}

TEST_F(Threads, WorkWithinWorkStaysOnItsThread) {
  set_thread_count(3);
  std::atomic<int> done{0};
  on_threads(6, [&](std::size_t) {
    on_threads(50, [&, outer = std::this_thread::get_id()](std::size_t) {
      EXPECT_EQ(std::this_thread::get_id(), outer);
      ++done;
    });
  });
  EXPECT_EQ(done, 300);
}

// The other works for 100 s, and would go on.
TEST_F(Threads, WorkUnderWayEndsWithTheOneThatThrew) {
  set_thread_count(2);
  const auto start = std::chrono::steady_clock::now();
  std::atomic<bool> begun{false};
  const auto work = [&](std::size_t i) {
    if (i == 0) {
      while (!begun) std::this_thread::yield();
      throw std::out_of_range("zero");
    }
    on_threads(100000, [&](std::size_t) {
      begun = true;
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
  };
  EXPECT_THROW(on_threads(2, work), std::out_of_range);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

// Ends 100 s of work after some 50 ms; within 200 on a machine that is idle.
TEST_F(Threads, AWatchEndsThem) {
  struct Enough {};
  for (const std::size_t threads : {1, 3}) {
    set_thread_count(threads);
    const auto start = std::chrono::steady_clock::now();
    const auto wait = [](std::size_t) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    };
    {
      const Watch watch([] { throw Enough(); });
      EXPECT_THROW(on_threads(100000, wait), Enough);
    }
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
    on_threads(100, wait);  // nobody watches any more
    const Watch again([] { throw Enough(); });
    const auto many_short_ones = [&] {
      for (int job = 0; job < 1000; ++job) on_threads(4, wait);
    };
    EXPECT_THROW(many_short_ones(), Enough);
  }
}

TEST_F(Threads, BitsDoNotDependOnTheirNumber) {
  constexpr int kPoints = 40000;
  const Lattice rest = lattice_around("sphere", cube(), {5, 6, 9});
  const Lattice deformed = Deformation::parse("twist:50").apply(rest);
  const Points points = 1.2 * Points::Random(kPoints, 3);
  const auto all = [&](std::size_t threads) {
    set_thread_count(threads);
    const Attachment attachment(rest, points.topRows(500), Outside::parse("clamp"));
    const Oracle::Coefficients bspline = Oracle::uniform_bspline();
    std::vector<Embedded> places = test::known_places(rest, kPoints, 1);
    std::vector<Points> results{
        evaluate_in(deformed, places, {bspline, bspline, bspline}),
        attachment.follow(evaluate_in(deformed, attachment.places(), {bspline, bspline, bspline})),
        pull_back(attachment, points.topRows(500))};
    for (const Eigen::Matrix3d& gradient : attachment.gradients(deformed)) {
      results.emplace_back(gradient);
    }
    return results;
  };
  const std::vector<Points> serial = all(1);
  for (const std::size_t threads : {2, 5}) {
    const std::vector<Points> parallel = all(threads);
    ASSERT_EQ(parallel.size(), serial.size());
    for (std::size_t i = 0; i < serial.size(); ++i) {
      EXPECT_TRUE(same_bits(serial[i], parallel[i])) << i;
    }
  }
}

}  // namespace
}  // namespace hwffd
