#include "hwffd/model/scatter.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "hwffd/model/organizations.hpp"

namespace hwffd::model {
namespace {

constexpr std::uint64_t kSumMask = (std::uint64_t{1} << kScatterSumBits) - 1;
constexpr std::uint64_t kSumSign = std::uint64_t{1} << (kScatterSumBits - 1);

template <int W>
class ScatterModelOf final : public ScatterModel {
  using F = Fixed<W>;

 public:
  explicit ScatterModelOf(bool powers) : powers_(powers) {}

  int width() const override { return W; }

  void load(int axis, const AxisWords& words) override {
    for (int l = 0; l < 4; ++l) {
      bank_.load(axis, l, words.degree, words.shift, words.word[l]);
      bank_.load_derivative(axis, l, words.degree, words.derivative.shift,
                            words.derivative.word[l]);
    }
  }

  VertexParts parts(const GradientWords& vertex) const override {
    LocalVertex<F> local;
    local.cell = vertex.cell;
    local.derivative = vertex.derivative;
    for (int axis = 0; axis < 3; ++axis) {
      local.local[axis] = F::coordinate(F::range(vertex.local[axis]).clamped);
    }
    const auto cumulative = cumulative_of<F>(local, bank_, powers_);
    VertexParts result;
    for (int c = 0; c < 3; ++c) {
      const auto parts =
          scattered<RoundedParts<F>>(cumulative, F::point(vertex.gradient[c]), vertex.derivative);
      for (int index = 0; index < 64; ++index) {
        const int l = local_of_bank(index >> 4, vertex.cell[0]);
        const int m = local_of_bank(index >> 2, vertex.cell[1]);
        const int n = local_of_bank(index, vertex.cell[2]);
        result.parts[16 * l + 4 * m + n][c] = parts[index].value;
        result.saturated |= parts[index].saturated;
      }
    }
    return result;
  }

 private:
  CoefficientBank<F> bank_{};
  bool powers_;
};

/// The width of a format's words, 0 unless it is fixed point.
int width_of(const std::string& format) {
  return format.rfind("fx", 0) == 0 ? std::stoi(format.substr(2)) : 0;
}

template <int W>
std::unique_ptr<ScatterModel> make(int width, bool powers) {
  if (W == width) return std::make_unique<ScatterModelOf<W>>(powers);
  if constexpr (W < kScatterMostWidth) return make<W + 1>(width, powers);
  throw std::invalid_argument("no scatter of such words");
}

}  // namespace

bool has_scatter(const Configuration& row) {
  const int width = width_of(row.format);
  return completes(organization_of(row).form) && width >= kScatterLeastWidth &&
         width <= kScatterMostWidth;
}

std::unique_ptr<ScatterModel> make_scatter_model(const Configuration& row) {
  if (!has_scatter(row)) {
    throw std::invalid_argument(std::string(row.name) +
                                ": only affine in fixed point of 12 to 18 bits has a transpose");
  }
  return make<kScatterLeastWidth>(width_of(row.format), wired_in(row));
}

ScatterPage::ScatterPage(int width, const std::array<int, 3>& dims)
    : width_(width),
      dims_(dims),
      words_(static_cast<std::size_t>(dims[0]) * static_cast<std::size_t>(dims[1]) *
             static_cast<std::size_t>(dims[2])),
      swept_(3 * words_.size()) {}

std::int64_t ScatterPage::sum(std::size_t point, int component) const {
  const std::uint64_t word = words_[point][component];
  if (word >> kScatterSumBits != epoch_) return 0;
  const std::uint64_t bits = word & kSumMask;
  return static_cast<std::int64_t>(bits ^ kSumSign) - static_cast<std::int64_t>(kSumSign);
}

void ScatterPage::put(std::size_t point, int component, std::uint64_t sum) {
  words_[point][component] = epoch_ << kScatterSumBits | (sum & kSumMask);
}

void ScatterPage::add(const std::array<int, 3>& cell, const VertexParts& vertex) {
  for (int p = 0; p < 64; ++p) {
    const int row = (cell[0] + p / 16) * dims_[1] + cell[1] + p / 4 % 4;
    const int number = row * dims_[2] + cell[2] + p % 4;
    const auto point = static_cast<std::size_t>(number);
    for (int c = 0; c < 3; ++c) {
      put(point, c, static_cast<std::uint64_t>(sum(point, c) + vertex.parts[p][c]));
    }
  }
  ++vertices_;
  saturated_ |= vertex.saturated;
}

void ScatterPage::join(const ScatterPage& other) {
  for (std::size_t point = 0; point < words_.size(); ++point) {
    for (int c = 0; c < 3; ++c) {
      put(point, c, static_cast<std::uint64_t>(sum(point, c) + other.sum(point, c)));
    }
  }
  vertices_ += other.vertices_;
  saturated_ |= other.saturated_;
}

bool ScatterPage::overflowed() const {
  return vertices_ > static_cast<std::uint64_t>(scatter_most_vertices(width_));
}

std::vector<CollectedPoint> ScatterPage::collect(int shift) {
  constexpr std::int64_t kTop = INT32_MAX;
  constexpr std::int64_t kBottom = INT32_MIN;
  const std::int64_t half = (std::int64_t{1} << shift) >> 1;
  std::vector<CollectedPoint> results(words_.size());
  for (std::size_t point = 0; point < words_.size(); ++point) {
    for (int c = 0; c < 3; ++c) {
      const std::int64_t rounded = (sum(point, c) + half) >> shift;
      const std::int64_t word = std::clamp(rounded, kBottom, kTop);
      results[point].words[c] = static_cast<std::uint32_t>(word);
      results[point].word_saturated |= word != rounded;
      put(point, c, 0);
    }
    results[point].saturated = saturated_ || results[point].word_saturated;
  }
  forget();
  return results;
}

void ScatterPage::begin() {
  sweep(3 * words_.size() - swept_);
  epoch_ ^= 1;
  swept_ = 0;
  forget();
}

void ScatterPage::sweep(std::size_t words) {
  const std::size_t end = swept_ + std::min(words, 3 * words_.size() - swept_);
  for (; swept_ < end; ++swept_) {
    const std::size_t point = swept_ / 3;
    const int component = static_cast<int>(swept_ % 3);
    if (word(point, component) >> kScatterSumBits != epoch_) put(point, component, 0);
  }
}

void ScatterPage::forget() {
  vertices_ = 0;
  saturated_ = false;
}

}  // namespace hwffd::model
