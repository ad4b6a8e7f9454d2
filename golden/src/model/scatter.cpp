#include "hwffd/model/scatter.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "hwffd/model/organizations.hpp"

namespace hwffd::model {
namespace {

constexpr std::uint64_t kSumMask = (std::uint64_t{1} << kScatterSumBits) - 1;
constexpr std::uint64_t kSumSign = std::uint64_t{1} << (kScatterSumBits - 1);

/// Two's complement, modulo 2^35.
std::int64_t wrapped(std::uint64_t sum) {
  return static_cast<std::int64_t>((sum & kSumMask) ^ kSumSign) -
         static_cast<std::int64_t>(kSumSign);
}

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
    const auto cumulative = weights(vertex);
    VertexParts result;
    for (int c = 0; c < 3; ++c) {
      const auto parts =
          scattered<RoundedParts<F>>(cumulative, F::point(vertex.gradient[c]), vertex.derivative);
      for (int index = 0; index < 64; ++index) {
        const int l = local_of_bank(index >> 4, vertex.cell[0]);
        result.parts[16 * l + place(index, vertex)][c] = parts[index].value;
        result.saturated |= parts[index].saturated;
      }
    }
    return result;
  }

  VertexLayers layers(const GradientWords& vertex) const override {
    return layers_of(weights(vertex)[0], vertex.cell[0], vertex.gradient, vertex.derivative != 0);
  }

  std::unique_ptr<RowPlaces> row_places(const std::vector<AxisPlace>& places,
                                        int derivative) const override {
    auto result = std::make_unique<Places>();
    result->to_one = derivative != 0;
    for (const AxisPlace& place : places) {
      GradientWords vertex;
      vertex.local[0] = place.local;
      vertex.cell[0] = place.cell;
      vertex.derivative = derivative;
      result->places.push_back({weights(vertex)[0], place.cell});
    }
    return result;
  }

  LayerSpread spread(const GradientWords& row,
                     const std::array<std::int64_t, 3>& sum) const override {
    static_assert(F::kWidePartBits == kScatterSumBits);
    const auto cumulative = weights(row);
    LayerSpread result;
    for (int c = 0; c < 3; ++c) {
      const auto banks =
          scattered_from<WideParts<F>, 1>(cumulative, {sum[c], false}, row.derivative);
      for (int index = 0; index < 16; ++index) {
        result.added[place(index, row)][c] = banks[index].value;
        result.saturated |= banks[index].saturated;
      }
    }
    return result;
  }

 private:
  std::array<CumulativeWeights<F>, 3> weights(const GradientWords& vertex) const {
    LocalVertex<F> local;
    local.cell = vertex.cell;
    local.derivative = vertex.derivative;
    for (int axis = 0; axis < 3; ++axis) {
      local.local[axis] = F::coordinate(F::range(vertex.local[axis]).clamped);
    }
    return cumulative_of<F>(local, bank_, powers_);
  }

  struct Places final : RowPlaces {
    struct Place {
      CumulativeWeights<F> cumulative;
      int cell;
    };
    VertexLayers layers(std::size_t place,
                        const std::array<std::uint32_t, 3>& gradient) const override {
      return layers_of(places[place].cumulative, places[place].cell, gradient, to_one);
    }
    std::vector<Place> places;
    bool to_one = true;
  };

  static VertexLayers layers_of(const CumulativeWeights<F>& cumulative, int cell,
                                const std::array<std::uint32_t, 3>& gradient, bool to_one) {
    VertexLayers result;
    for (int c = 0; c < 3; ++c) {
      const auto banks = expanded<RoundedParts<F>>(cumulative, F::point(gradient[c]), to_one);
      for (int bank = 0; bank < 4; ++bank) {
        result.added[local_of_bank(bank, cell)][c] = banks[bank].value;
        result.saturated |= banks[bank].saturated;
      }
    }
    return result;
  }

  /// In local order along t and u, of the banks of these two.
  static int place(int index, const GradientWords& vertex) {
    return 4 * local_of_bank(index >> 2, vertex.cell[1]) + local_of_bank(index, vertex.cell[2]);
  }

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
  return wrapped(word);
}

void ScatterPage::put(std::size_t point, int component, std::uint64_t sum) {
  words_[point][component] = epoch_ << kScatterSumBits | (sum & kSumMask);
}

void ScatterPage::add_at(const std::array<int, 3>& at, const std::array<std::int64_t, 3>& added) {
  const int number = (at[0] * dims_[1] + at[1]) * dims_[2] + at[2];
  const auto point = static_cast<std::size_t>(number);
  for (int c = 0; c < 3; ++c) {
    put(point, c, static_cast<std::uint64_t>(sum(point, c) + added[c]));
  }
}

void ScatterPage::add(const std::array<int, 3>& cell, const VertexParts& vertex) {
  for (int p = 0; p < 64; ++p) {
    add_at({cell[0] + p / 16, cell[1] + p / 4 % 4, cell[2] + p % 4}, vertex.parts[p]);
  }
  count(vertex.saturated);
}

void ScatterPage::add_layer(const std::array<int, 3>& first, const LayerSpread& layer) {
  for (int p = 0; p < 16; ++p)
    add_at({first[0], first[1] + p / 4, first[2] + p % 4}, layer.added[p]);
  saturated_ |= layer.saturated;
}

void ScatterPage::count(bool saturated) {
  ++vertices_;
  saturated_ |= saturated;
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

bool ScatterRow::add(const GradientWords& vertex) { return add(vertex, scatter_->layers(vertex)); }

bool ScatterRow::add(const GradientWords& vertex, const VertexLayers& layers) {
  row_ = vertex;
  const auto first = static_cast<std::size_t>(vertex.cell[0]);
  if (sums_.size() < first + 4) {
    sums_.resize(first + 4);
    added_.resize(first + 4);
  }
  for (std::size_t l = 0; l < 4; ++l) {
    if (!added_[first + l]) layers_.push_back(vertex.cell[0] + static_cast<int>(l));
    added_[first + l] = true;
    auto& sum = sums_[first + l];
    for (int c = 0; c < 3; ++c) {
      sum[c] = wrapped(static_cast<std::uint64_t>(sum[c] + layers.added[l][c]));
    }
  }
  return layers.saturated;
}

std::vector<bool> ScatterRow::end(ScatterPage& page) {
  std::vector<bool> saturated;
  std::sort(layers_.begin(), layers_.end());
  for (const int layer : layers_) {
    auto& sum = sums_[static_cast<std::size_t>(layer)];
    const LayerSpread spread = scatter_->spread(row_, sum);
    page.add_layer({layer, row_.cell[1], row_.cell[2]}, spread);
    saturated.push_back(spread.saturated);
    sum = {};
    added_[static_cast<std::size_t>(layer)] = false;
  }
  layers_.clear();
  return saturated;
}

}  // namespace hwffd::model
