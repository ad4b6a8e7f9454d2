#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <stdexcept>

#include "axis.hpp"
#include "triples.hpp"

namespace hwffd::certified {

/// Where coordinates are too many to keep: 64 pieces of [0, 1], and errors to an eighth of a unit.
class Grid {
 public:
  explicit Grid(double unit)
      : side_(unit / 8), bits_(std::make_unique<std::atomic<std::uint64_t>[]>(kCells / 64)) {}

  void visit(const AxisPoint& point) {
    const Four e = point.error();
    auto cell = static_cast<std::int64_t>(std::min(point.x * kPieces, kPieces - 1.0));
    for (const double of_one : e) {
      const auto step = static_cast<std::int64_t>(std::floor(of_one / side_)) + kMiddle;
      if (step < 0 || step >= kSteps) throw std::logic_error("a weight's error leaves the grid");
      cell = cell * kSteps + step;
    }
    std::atomic<std::uint64_t>& word = bits_[static_cast<std::size_t>(cell / 64)];
    const std::uint64_t bit = std::uint64_t{1} << (cell % 64);
    // Nearly always set already: to read is cheaper.
    if ((word.load(std::memory_order_relaxed) & bit) == 0) word.fetch_or(bit);
  }

  std::vector<ErrorBox> boxes() const {
    std::vector<ErrorBox> result;
    for (std::int64_t cell = 0; cell < kCells; ++cell) {
      if ((bits_[static_cast<std::size_t>(cell / 64)] >> (cell % 64) & 1) == 0) continue;
      ErrorBox box;
      std::int64_t rest = cell;
      for (int l = 3; l >= 0; --l) {
        box.low[l] = static_cast<double>(rest % kSteps - kMiddle) * side_;
        box.high[l] = box.low[l] + side_;
        rest /= kSteps;
      }
      box.low_x = static_cast<double>(rest) / kPieces;
      box.high_x = static_cast<double>(rest + 1) / kPieces;
      result.push_back(box);
    }
    return result;
  }

 private:
  static constexpr int kPieces = 64;
  static constexpr std::int64_t kSteps = 64;
  static constexpr std::int64_t kMiddle = kSteps / 2;  // the step of an error of 0
  static constexpr std::int64_t kCells = kPieces * kSteps * kSteps * kSteps * kSteps;

  double side_;
  std::unique_ptr<std::atomic<std::uint64_t>[]> bits_;
};

/// All coordinates of a format, as boxes: one each where they are few.
template <class F>
class Boxes {
 public:
  static constexpr bool kFew = Coordinates<F>::kLast - Coordinates<F>::kFirst < 1 << 17;

  explicit Boxes(bool wanted) : wanted_(wanted) {
    if (wanted && !kFew) grid_ = std::make_unique<Grid>(Coordinates<F>::kUnit);
  }
  void visit(const AxisPoint& point) {
    if (!wanted_) return;
    if (grid_) {
      grid_->visit(point);
      return;
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    few_.emplace_back().add(point.x, point.error());
  }
  std::vector<ErrorBox> take() { return grid_ ? grid_->boxes() : std::move(few_); }

 private:
  bool wanted_;
  std::unique_ptr<Grid> grid_;
  std::mutex mutex_;
  std::vector<ErrorBox> few_;
};

}  // namespace hwffd::certified
