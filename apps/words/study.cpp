#include "study.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

namespace hwffd::words {
namespace {

constexpr int kThreads = 2;
constexpr std::int64_t kBlock = 1024;  // vertices drawn at a time

struct Tally {
  double largest = 0;
  double squares = 0;
};

void measure_block(const Rows& rows, const std::vector<Sample>& block,
                   std::vector<Tally>& tallies) {
  for (std::size_t r = 0; r < rows.size(); ++r) {
    for (const Sample& sample : block) {
      const Point error = rows[r]->evaluate(sample) - sample.exact;
      tallies[r].largest = std::max(tallies[r].largest, error.cwiseAbs().maxCoeff());
      tallies[r].squares += error.squaredNorm();
    }
  }
}

/// Every block whose number leaves the thread's own on division: which thread it is decides what it
/// does, so that the sums are always the same.
std::vector<Tally> measure_part(const Rows& rows, std::int64_t vertices, std::uint64_t seed,
                                int thread, const Progress& progress) {
  const Samples samples;
  std::vector<Tally> tallies(rows.size());
  for (std::int64_t first = thread * kBlock; first < vertices; first += kThreads * kBlock) {
    const std::int64_t count = std::min(kBlock, vertices - first);
    const std::uint64_t block_seed = seed + 0x9E3779B97F4A7C15U * (first / kBlock + 1);
    measure_block(rows, samples.draw(block_seed, static_cast<int>(count)), tallies);
    if (thread == 0) progress(static_cast<double>(first) / static_cast<double>(vertices));
  }
  return tallies;
}

void on_threads(const std::function<void(int)>& work) {
  std::vector<std::thread> threads;
  for (int t = 0; t < kThreads; ++t) threads.emplace_back(work, t);
  for (std::thread& thread : threads) thread.join();
}

std::vector<double> bounds_of(const Rows& rows) {
  std::vector<double> bounds(rows.size());
  std::atomic<std::size_t> next{0};
  on_threads([&](int) {
    for (std::size_t r = next++; r < rows.size(); r = next++) bounds[r] = rows[r]->bound();
  });
  return bounds;
}

}  // namespace

std::vector<Result> study(const Rows& rows, std::int64_t vertices, std::uint64_t seed,
                          const Progress& progress) {
  std::vector<std::vector<Tally>> parts(kThreads);
  on_threads([&](int t) { parts[t] = measure_part(rows, vertices, seed, t, progress); });
  const std::vector<double> bounds = bounds_of(rows);
  progress(1);
  std::vector<Result> results;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Row& row = *rows[r];
    Result result{row.form(), row.format(), row.word_length(), row.is_fixed(), 0,
                  0,          bounds[r],    vertices};
    for (const std::vector<Tally>& part : parts) {
      result.max_error = std::max(result.max_error, part[r].largest);
      result.rms_error += part[r].squares;
    }
    result.rms_error = std::sqrt(result.rms_error / (3.0 * static_cast<double>(vertices)));
    results.push_back(result);
  }
  return results;
}

}  // namespace hwffd::words
