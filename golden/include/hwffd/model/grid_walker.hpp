#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

#include "hwffd/model/lane_evaluator.hpp"
#include "hwffd/model/org_factored.hpp"
#include "hwffd/model/resident_vertex.hpp"
#include "hwffd/stream/grid.hpp"

namespace hwffd::model {

/// The vertices of a grid, row by row along s, with the bits of each vertex by itself.
///
/// Eq. (1) is contracted along u, t and s, in the order of `contract_axes`, but what vertices share
/// is made once: the weights of an axis for each of its coordinates, the contraction along u for
/// each coordinate of u, and that along t for each row. A vertex is left with the contraction of
/// four points along s. In hardware that is `walk` (docs/organizations/walk.md).
class GridWalker {
 public:
  virtual ~GridWalker() = default;
  /// The results of rows `first` to `end - 1`, one after the other. Row b + c * count[1] has place
  /// b of t and c of u. Several threads may call it.
  virtual void evaluate(std::size_t first, std::size_t end,
                        std::vector<ResultWords>& results) const = 0;
};

/// Whether an organization contracts one axis after the other, with weights that it tells.
template <class Organization, class = void>
constexpr bool kContracts = false;
template <class Organization>
constexpr bool kContracts<Organization, std::void_t<decltype(&Organization::weights)>> = true;

/// The places of a grid along an axis: the layers of control points that they touch, and of each
/// place, by bank, the weights and the numbers of their layers.
template <class F>
struct WalkedAxis {
  explicit WalkedAxis(const std::vector<AxisPlace>& places) {
    for (const AxisPlace& place : places) {
      for (int l = 0; l < 4; ++l) layers.push_back(place.cell + l);
    }
    std::sort(layers.begin(), layers.end());
    layers.erase(std::unique(layers.begin(), layers.end()), layers.end());
    for (const AxisPlace& place : places) {
      std::array<std::uint32_t, 4>& of_bank = at.emplace_back();
      // The four layers of a cell follow each other.
      const auto first = std::lower_bound(layers.begin(), layers.end(), place.cell);
      for (int b = 0; b < 4; ++b) {
        of_bank[b] =
            static_cast<std::uint32_t>(first - layers.begin() + local_of_bank(b, place.cell));
      }
    }
  }

  std::vector<int> layers;
  std::vector<std::array<std::uint32_t, 4>> at;
  std::vector<std::array<typename F::Weight, 4>> weight;
};

/// The axes of a grid, with the weights of an organization.
/// @param places  as of `axis_places`, one an axis at least
template <class F, class Organization>
std::array<WalkedAxis<F>, 3> walked_axes(const CoefficientBank<F>& bank,
                                         const std::array<std::vector<AxisPlace>, 3>& places,
                                         int derivative) {
  std::array<WalkedAxis<F>, 3> axes{WalkedAxis<F>(places[0]), WalkedAxis<F>(places[1]),
                                    WalkedAxis<F>(places[2])};
  const std::size_t most = std::max({places[0].size(), places[1].size(), places[2].size()});
  for (std::size_t n = 0; n < most; ++n) {
    LocalVertex<F> vertex;
    vertex.derivative = derivative;
    for (int axis = 0; axis < 3; ++axis) {
      const AxisPlace& place = places[axis][std::min(n, places[axis].size() - 1)];
      vertex.local[axis] = F::coordinate(place.local);
      vertex.cell[axis] = place.cell;
    }
    const AxisWeights<F> weight = Organization::weights(vertex, bank);
    for (int axis = 0; axis < 3; ++axis) {
      if (n < places[axis].size()) axes[axis].weight.push_back(weight[axis]);
    }
  }
  return axes;
}

/// How a walker takes vertices: one after the other.
template <class F>
struct OneByOne {
  using Format = F;
  using Point = typename F::Point;
  static constexpr std::size_t kCount = 1;

  template <class Number>
  static void put(Number& to, std::size_t /*lane*/, const Number& from) {
    to = from;
  }
  static void out(const VectorSum<F>& sum, int exponent, std::size_t /*count*/,
                  ResultWords* results) {
    ResultWords result;
    for (int c = 0; c < 3; ++c) {
      const OutWord word = F::out(sum[c], exponent);
      result.words[c] = word.word;
      result.saturated |= word.saturated;
      result.nan |= word.nan;
    }
    *results = result;
  }

  /// The points of a row, one of each layer of s.
  class Planes {
   public:
    explicit Planes(std::size_t layers) : points_(layers) {}
    void set(std::size_t layer, const std::array<Point, 3>& point) { points_[layer] = point; }
    Point gathered(const std::array<std::uint32_t, kCount>& layer, int c) const {
      return points_[layer[0]][c];
    }

   private:
    std::vector<std::array<Point, 3>> points_;
  };
};

/// Eight at a time, in lanes of 64 bits.
template <int W>
struct EightByEight {
  using Format = Fixed<W, Lanes>;
  using Point = typename Format::Point;
  static constexpr std::size_t kCount = kLanes;

  /// Whether lanes hold the sums of four points with these weights: points are at most 2^(W-1) in
  /// magnitude, so these make at most 2^62.
  template <class Weights>
  static bool holds(const Weights& weights) {
    if (Fixed<W>::kShort) return true;
    std::int64_t all = 0;
    for (const auto& weight : weights) all += std::abs(weight.value);
    return all <= std::int64_t{1} << (63 - W);
  }
  template <class Number, class Scalar>
  static void put(Number& to, std::size_t lane, const Scalar& from) {
    to.value[lane] = from.value;
    to.saturated[lane] = from.saturated ? -1 : 0;
  }
  static void out(const VectorSum<Format>& sum, int /*exponent*/, std::size_t count,
                  ResultWords* results) {
    std::array<Lanes, 3> words;
    Lanes saturated{};
    for (int c = 0; c < 3; ++c) {
      const typename Format::Number number = Format::out_units(sum[c]);
      words[c] = number.value;
      saturated |= number.saturated;
    }
    for (std::size_t lane = 0; lane < count; ++lane) {
      results[lane] = {
          {static_cast<std::uint32_t>(words[0][lane]), static_cast<std::uint32_t>(words[1][lane]),
           static_cast<std::uint32_t>(words[2][lane])},
          saturated[lane] != 0,
          false};
    }
  }

  /// As of `OneByOne`; layers are set eight at a time.
  class Planes {
   public:
    explicit Planes(std::size_t layers) {
      for (auto& of : value_) of.resize((layers + kCount - 1) / kCount * kCount);
      saturated_ = value_;
    }
    void set(std::size_t layer, const std::array<Point, 3>& point) {
      if (layer == 0) any_ = Lanes{};
      for (int c = 0; c < 3; ++c) {
        for (std::size_t lane = 0; lane < kCount; ++lane) {
          value_[c][layer + lane] = point[c].value[lane];
          saturated_[c][layer + lane] = point[c].saturated[lane];
        }
        any_ |= point[c].saturated;
      }
    }
    Point gathered(const std::array<std::uint32_t, kCount>& layer, int c) const {
      Point point;
      point.value = lanes(value_[c].data(), layer);
      point.saturated = Lanes{};
      if (is_any()) point.saturated = lanes(saturated_[c].data(), layer);
      return point;
    }

   private:
    static Lanes lanes(const std::int64_t* of, const std::array<std::uint32_t, kCount>& at) {
      return Lanes{of[at[0]], of[at[1]], of[at[2]], of[at[3]],
                   of[at[4]], of[at[5]], of[at[6]], of[at[7]]};
    }
    bool is_any() const {
      std::int64_t any = 0;
      for (std::size_t lane = 0; lane < kCount; ++lane) any |= any_[lane];
      return any != 0;
    }

    std::array<std::vector<std::int64_t>, 3> value_;
    std::array<std::vector<std::int64_t>, 3> saturated_;
    alignas(sizeof(Lanes)) Lanes any_{};
  };
};

/// The walker of a number format, by `OneByOne` or `EightByEight`.
template <class F, class By>
class GridWalkerBy final : public GridWalker {
  using Format = typename By::Format;
  using Point = typename Format::Point;
  static constexpr std::size_t kCount = By::kCount;

 public:
  GridWalkerBy(const ResidentPoints& points, std::array<WalkedAxis<F>, 3> axes)
      : points_(points), axes_(std::move(axes)) {
    const auto& [s, t, u] = axes_;
    vertices_ = s.weight.size();
    packs_.resize((vertices_ + kCount - 1) / kCount);
    for (std::size_t v = 0; v < packs_.size() * kCount; ++v) {
      const std::size_t a = std::min(v, vertices_ - 1);  // the last is repeated
      for (int bank = 0; bank < 4; ++bank) {
        By::put(packs_[v / kCount].weight[bank], v % kCount, s.weight[a][bank]);
        packs_[v / kCount].layer[bank][v % kCount] = s.at[a][bank];
      }
    }
  }

  void evaluate(std::size_t first, std::size_t end,
                std::vector<ResultWords>& results) const override {
    const auto& [s, t, u] = axes_;
    results.resize((end - first) * vertices_);
    Slab slab(s.layers.size(), t.layers.size());
    typename By::Planes planes(s.layers.size());
    for (std::size_t row = first; row < end; ++row) {
      const std::size_t b = row % t.weight.size();
      const std::size_t c = row / t.weight.size();
      for (const std::uint32_t layer : t.at[b]) contract_column(layer, c, slab);
      ResultWords* const next = results.data() + (row - first) * vertices_;
      if constexpr (kCount == 1) {
        walk(b, slab, planes, next);
      } else {
        run(b, slab, planes, next);
      }
    }
  }

 private:
  /// Vertices of a row that are evaluated together.
  struct Pack {
    std::array<typename Format::Weight, 4> weight;
    std::array<std::array<std::uint32_t, kCount>, 4> layer;
  };

  /// Control points contracted along u: for each layer of t a column, with those of all layers of
  /// s.
  struct Slab {
    Slab(std::size_t layers_s, std::size_t layers_t)
        : packs((layers_s + kCount - 1) / kCount),
          points(packs * layers_t),
          place(layers_t, std::size_t{0} - 1) {}

    std::size_t packs;  ///< of a column
    std::vector<std::array<Point, 3>> points;
    std::vector<std::size_t> place;  ///< of u, for which a column is there
  };

  /// Makes a column for place c of u, unless it is there.
  void contract_column(std::uint32_t layer, std::size_t c, Slab& slab) const {
    if (slab.place[layer] == c) return;
    slab.place[layer] = c;
    const auto& [s, t, u] = axes_;
    for (std::size_t n = 0; n < slab.packs * kCount; ++n) {
      const int i = s.layers[std::min(n, s.layers.size() - 1)];
      std::array<std::array<typename F::Point, 3>, 4> four;
      for (int bank = 0; bank < 4; ++bank) {
        const std::uint32_t* const words =
            points_.at({i, t.layers[layer], u.layers[u.at[c][bank]]});
        for (int axis = 0; axis < 3; ++axis) {
          four[bank][axis] = F::point(words[axis], points_.exponent);
        }
      }
      const VectorSum<F> sum = contract<F>(u.weight[c], four.data());
      std::array<Point, 3>& point = slab.points[layer * slab.packs + n / kCount];
      for (int axis = 0; axis < 3; ++axis) {
        By::put(point[axis], n % kCount, F::narrow(sum[axis]));
      }
    }
  }

  HWFFD_FOR_EACH_PROCESSOR void run(std::size_t b, const Slab& slab, typename By::Planes& planes,
                                    ResultWords* results) const {
    walk(b, slab, planes, results);
  }

  /// Contracts the columns of place b of t, and evaluates the row.
  void walk(std::size_t b, const Slab& slab, typename By::Planes& planes,
            ResultWords* results) const {
    const WalkedAxis<F>& t = axes_[1];
    std::array<typename Format::Weight, 4> weight;
    for (int bank = 0; bank < 4; ++bank) {
      for (std::size_t lane = 0; lane < kCount; ++lane) {
        By::put(weight[bank], lane, t.weight[b][bank]);
      }
    }
    std::array<std::array<Point, 3>, 4> four;
    for (std::size_t n = 0; n < slab.packs; ++n) {
      for (int bank = 0; bank < 4; ++bank) {
        four[bank] = slab.points[t.at[b][bank] * slab.packs + n];
      }
      const VectorSum<Format> sum = contract<Format>(weight, four.data());
      planes.set(n * kCount,
                 {Format::narrow(sum[0]), Format::narrow(sum[1]), Format::narrow(sum[2])});
    }
    for (std::size_t n = 0; n < packs_.size(); ++n) {
      const Pack& pack = packs_[n];
      for (int bank = 0; bank < 4; ++bank) {
        for (int c = 0; c < 3; ++c) four[bank][c] = planes.gathered(pack.layer[bank], c);
      }
      By::out(contract<Format>(pack.weight, four.data()), points_.exponent,
              std::min(kCount, vertices_ - n * kCount), results + n * kCount);
    }
  }

  const ResidentPoints& points_;
  std::array<WalkedAxis<F>, 3> axes_;  // s, t, u
  std::size_t vertices_;               // of a row
  std::vector<Pack> packs_;
};

/// The walker of a format: in lanes, where it has some that hold the sums.
template <class F>
struct MakeWalker {
  static std::unique_ptr<GridWalker> of(const ResidentPoints& points,
                                        std::array<WalkedAxis<F>, 3> axes) {
    return std::make_unique<GridWalkerBy<F, OneByOne<F>>>(points, std::move(axes));
  }
};
#ifndef HWFFD_NO_LANES
template <int W>
struct MakeWalker<Fixed<W>> {
  using F = Fixed<W>;
  static std::unique_ptr<GridWalker> of(const ResidentPoints& points,
                                        std::array<WalkedAxis<F>, 3> axes) {
    const auto held = [](const WalkedAxis<F>& axis) {
      return std::all_of(axis.weight.begin(), axis.weight.end(),
                         [](const auto& weight) { return EightByEight<W>::holds(weight); });
    };
    if (held(axes[0]) && held(axes[1])) {
      return std::make_unique<GridWalkerBy<F, EightByEight<W>>>(points, std::move(axes));
    }
    return std::make_unique<GridWalkerBy<F, OneByOne<F>>>(points, std::move(axes));
  }
};
#endif

}  // namespace hwffd::model
