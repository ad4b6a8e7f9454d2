#include "study.hpp"

#include <algorithm>
#include <cmath>

#include "hwffd/numerics/largest_error.hpp"
#include "hwffd/on_threads.hpp"

namespace hwffd::words {
namespace {

constexpr int kParts = 2;              // of the vertices, measured side by side
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
      raise_to(tallies[r].largest, error.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
      tallies[r].squares += error.squaredNorm();
    }
  }
}

/// Every block whose number leaves the part's own on division, so that the sums are always the
/// same, whichever thread does it.
std::vector<Tally> measure_part(const Rows& rows, std::int64_t vertices, std::uint64_t seed,
                                int part, const Progress& progress) {
  const Samples samples;
  std::vector<Tally> tallies(rows.size());
  for (std::int64_t first = part * kBlock; first < vertices; first += kParts * kBlock) {
    const std::int64_t count = std::min(kBlock, vertices - first);
    const std::uint64_t block_seed = seed + 0x9E3779B97F4A7C15U * (first / kBlock + 1);
    measure_block(rows, samples.draw(block_seed, static_cast<int>(count)), tallies);
    if (part == 0) progress(static_cast<double>(first) / static_cast<double>(vertices));
  }
  return tallies;
}

std::vector<double> bounds_of(const Rows& rows) {
  std::vector<double> bounds(rows.size());
  on_threads(rows.size(), [&](std::size_t r) { bounds[r] = rows[r]->bound(); });
  return bounds;
}

}  // namespace

std::vector<Result> study(const Rows& rows, std::int64_t vertices, std::uint64_t seed,
                          const Progress& progress) {
  std::vector<std::vector<Tally>> tallies(kParts);
  on_threads(kParts, [&](std::size_t p) {
    tallies[p] = measure_part(rows, vertices, seed, static_cast<int>(p), progress);
  });
  const std::vector<double> bounds = bounds_of(rows);
  progress(1);
  std::vector<Result> results;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const Row& row = *rows[r];
    Result result{row.form(), row.format(), row.word_length(), row.is_fixed(), 0,
                  0,          bounds[r],    vertices};
    for (const std::vector<Tally>& part : tallies) {
      result.max_error = std::max(result.max_error, part[r].largest);
      result.rms_error += part[r].squares;
    }
    result.rms_error = std::sqrt(result.rms_error / (3.0 * static_cast<double>(vertices)));
    results.push_back(result);
  }
  return results;
}

}  // namespace hwffd::words
