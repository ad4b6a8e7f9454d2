#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/org_powers.hpp"
#include "hwffd/model/resident_vertex.hpp"
#include "hwffd/numerics/fixed.hpp"
#include "hwffd/stream/grid.hpp"
#include "hwffd/stream/packets.hpp"

/// Organization `scatter`, the transpose of `affine`: gradients with respect to positions are added
/// up at the control points that made these (docs/numerics.md section 11).
namespace hwffd::model {

constexpr int kScatterLeastWidth = 12;  ///< of words, in fixed point
constexpr int kScatterMostWidth = 18;
constexpr int kScatterSumBits = 35;   ///< of a sum
constexpr int kScatterMostShift = 3;  ///< of a collect

/// So many vertices, at most, add to a page without that a sum can overflow.
constexpr std::int64_t scatter_most_vertices(int width) {
  return std::int64_t{1} << (kScatterSumBits - 1 - width);
}
/// So many, at most, leave sums that a collect without a shift gives exactly.
constexpr std::int64_t scatter_exact_vertices(int width) { return std::int64_t{1} << (31 - width); }

/// The sums of an axis's weights up to bank 0, 1 and 2. Those of all banks are 1, or 0.
template <class F>
using CumulativeWeights = std::array<typename F::Weight, 3>;

template <class F>
CumulativeWeights<F> cumulative(const std::array<typename F::Weight, 4>& weight) {
  const typename F::Weight second = F::cumulate(weight[0], weight[1]);
  return {weight[0], second, F::cumulate(second, weight[2])};
}

/// Parts as the hardware has them.
template <class F>
struct RoundedParts {
  using Format = F;
  using Part = typename F::Part;
  static Part zero() { return {}; }
  static Part share(typename F::Weight weight, Part part) { return F::share(weight, part); }
  static Part less(Part a, Part b) { return F::less(a, b); }
  /// All of a part, in the units of its shares.
  static Part whole(Part part) { return part; }
};

/// Parts of a layer's sum, as the hardware has them.
template <class F>
struct WideParts : RoundedParts<F> {
  using Part = typename F::Part;
  static Part share(typename F::Weight weight, Part part) { return F::wide_share(weight, part); }
  static Part less(Part a, Part b) { return F::wide_less(a, b); }
};

/// Parts without any rounding: each expansion has kWeightFraction more digits.
template <class F>
struct ExactParts {
  using Format = F;
  using Part = Int128;
  static Part zero() { return 0; }
  static Part share(typename F::Weight weight, Part part) { return weight.value * part; }
  static Part less(Part a, Part b) { return a - b; }
  static Part whole(Part part) { return part * (std::int64_t{1} << F::kWeightFraction); }
};

/// A part among the four banks of an axis: cumulative shares are rounded, and a bank has the
/// difference of two, so that all four sum to the part, or of a derivative to 0, to the bit.
template <class Parts>
std::array<typename Parts::Part, 4> expanded(
    const CumulativeWeights<typename Parts::Format>& cumulative, const typename Parts::Part& part,
    bool to_one) {
  std::array<typename Parts::Part, 4> banks;
  typename Parts::Part below = Parts::zero();
  for (int b = 0; b < 3; ++b) {
    const typename Parts::Part share = Parts::share(cumulative[b], part);
    banks[b] = Parts::less(share, below);
    below = share;
  }
  banks[3] = Parts::less(to_one ? Parts::whole(part) : Parts::zero(), below);
  return banks;
}

/// A part among the banks of the axes from `first` to u, two bits each, u fastest: along s, then t,
/// then u, 1 -> 4 -> 16 -> 64.
/// @param derivative  the axis along which it is the gradient of the derivative, or -1
template <class Parts, int first>
std::array<typename Parts::Part, 1 << 2 * (3 - first)> scattered_from(
    const std::array<CumulativeWeights<typename Parts::Format>, 3>& cumulative,
    const typename Parts::Part& part, int derivative) {
  std::array<typename Parts::Part, 1 << 2 * (3 - first)> parts;
  parts[0] = part;
  for (int axis = first; axis < 3; ++axis) {
    // From behind, so that a part is read before its place is written.
    for (int i = (1 << (2 * (axis - first))) - 1; i >= 0; --i) {
      const auto banks = expanded<Parts>(cumulative[axis], parts[i], axis != derivative);
      for (int b = 0; b < 4; ++b) parts[4 * i + b] = banks[b];
    }
  }
  return parts;
}

/// A component of a gradient among 64 banks, (s, t, u).
template <class Parts>
std::array<typename Parts::Part, 64> scattered(
    const std::array<CumulativeWeights<typename Parts::Format>, 3>& cumulative,
    const typename Parts::Part& gradient, int derivative) {
  return scattered_from<Parts, 0>(cumulative, gradient, derivative);
}

/// The cumulative weights of each axis. Bank 3 is never evaluated, and its flag is not seen.
/// @param powers  whether the evaluator is `powers`, else polynomials
template <class F>
std::array<CumulativeWeights<F>, 3> cumulative_of(const LocalVertex<F>& vertex,
                                                  const CoefficientBank<F>& bank, bool powers) {
  const AxisWeights<F> weight = powers ? powers_of<F>(vertex) : weights_of<F>(vertex, bank);
  return {cumulative<F>(weight[0]), cumulative<F>(weight[1]), cumulative<F>(weight[2])};
}

/// A vertex and its gradient as the stream brings them.
struct GradientWords {
  std::array<std::uint32_t, 3> local{};
  std::array<int, 3> cell{};
  std::array<std::uint32_t, 3> gradient{};
  int derivative = -1;  ///< with respect to the derivative along that axis; -1: to the position
};

/// What a vertex adds to the 64 points of its support, in local order, n fastest, in units of a
/// part, and whether anything saturated.
struct VertexParts {
  std::array<std::array<std::int64_t, 3>, 64> parts{};
  bool saturated = false;
};

/// What a vertex of a row adds to the sums of the four layers of its support, along s.
struct VertexLayers {
  std::array<std::array<std::int64_t, 3>, 4> added{};
  bool saturated = false;
};

/// What the sum of a layer adds to the layer's 16 points, in local order, n fastest.
struct LayerSpread {
  std::array<std::array<std::int64_t, 3>, 16> added{};
  bool saturated = false;
};

/// The places that all rows of a grid have along s, with their weights.
class RowPlaces {
 public:
  virtual ~RowPlaces() = default;
  /// What a vertex at one of them adds to the sums of its row.
  virtual VertexLayers layers(std::size_t place,
                              const std::array<std::uint32_t, 3>& gradient) const = 0;
};

/// The datapath of a scatter core, whatever the width of its words.
class ScatterModel {
 public:
  virtual ~ScatterModel() = default;
  virtual int width() const = 0;
  /// Functions of an axis and their derivatives.
  virtual void load(int axis, const AxisWords& words) = 0;
  /// What a vertex adds. Coordinates outside [0, 1] are clamped, as in mode 0.
  virtual VertexParts parts(const GradientWords& vertex) const = 0;
  /// Of a core with rows: what a vertex adds to the sums of its row.
  virtual VertexLayers layers(const GradientWords& vertex) const = 0;
  /// The same of vertices at these places along s; as long as the model lasts and loads nothing.
  virtual std::unique_ptr<RowPlaces> row_places(const std::vector<AxisPlace>& places,
                                                int derivative) const = 0;
  /// The same: what the sum of a layer adds. Of the vertex nothing counts but where it is along t
  /// and u, and its derivative.
  virtual LayerSpread spread(const GradientWords& row,
                             const std::array<std::int64_t, 3>& sum) const = 0;
};

/// Whether a row of the table has a transpose: `affine` in fixed point of 12 to 18 bits.
bool has_scatter(const Configuration& row);

/// The scatter with the weights of a row of `affine`.
/// @throws std::invalid_argument for one that has none
std::unique_ptr<ScatterModel> make_scatter_model(const Configuration& row);

/// A point as a collect gives it: `saturated` where a word of it did, or any vertex of the page.
struct CollectedPoint : ResultWords {
  bool word_saturated = false;  ///< a word of this point did
};

/// The sums of a page: of each control point three words {epoch, sum} of 36 bits.
class ScatterPage {
 public:
  /// All sums zero.
  /// @param width  of the core's words
  /// @param dims  points an axis
  ScatterPage(int width, const std::array<int, 3>& dims);

  /// Adds a vertex of a cell that the lattice has.
  void add(const std::array<int, 3>& cell, const VertexParts& vertex);
  /// Adds what a layer of a row does.
  /// @param first  its first point: the layer, and the row's cell along t and u
  void add_layer(const std::array<int, 3>& first, const LayerSpread& layer);
  /// Counts a vertex of a row.
  void count(bool saturated);
  /// Adds what another page of as many points has, modulo 2^35.
  void join(const ScatterPage& other);

  /// The words of all points in their order, sum / 2^shift each, and leaves zeros.
  /// @param shift  0 to 3
  std::vector<CollectedPoint> collect(int shift);

  /// All sums are zero from now on. What had the epoch before is swept later; what a begin before
  /// left is swept first.
  void begin();
  /// Sweeps so many words more of what the last begin left.
  void sweep(std::size_t words);

  /// The sum of a component of a point, two's complement.
  std::int64_t sum(std::size_t point, int component) const;
  /// What the memory has of it, 36 bits.
  std::uint64_t word(std::size_t point, int component) const { return words_[point][component]; }

  std::uint64_t vertices() const { return vertices_; }
  /// Whether more vertices added than sums can surely hold.
  bool overflowed() const;
  /// Whether any vertex saturated.
  bool saturated() const { return saturated_; }

 private:
  void put(std::size_t point, int component, std::uint64_t sum);
  void add_at(const std::array<int, 3>& at, const std::array<std::int64_t, 3>& added);
  void forget();

  int width_;
  std::array<int, 3> dims_;
  std::vector<std::array<std::uint64_t, 3>> words_;
  std::uint64_t epoch_ = 0;
  std::size_t swept_;  // words, of the sweep under way
  std::uint64_t vertices_ = 0;
  bool saturated_ = false;
};

/// The row under way in a core with rows: a sum of 35 bits for each of its layers.
class ScatterRow {
 public:
  explicit ScatterRow(const ScatterModel& scatter) : scatter_(&scatter) {}

  /// Adds a vertex, in any order. All of a row are at the same place along t and u.
  /// @return whether it saturated
  bool add(const GradientWords& vertex);
  /// The same of what it adds.
  /// @param vertex  whose place along t and u, cell along s and derivative count
  bool add(const GradientWords& vertex, const VertexLayers& layers);
  bool empty() const { return layers_.empty(); }
  /// Adds each layer to a page, and begins the next row.
  /// @return whether it saturated, of each layer, along s
  std::vector<bool> end(ScatterPage& page);

 private:
  const ScatterModel* scatter_;
  GradientWords row_;
  std::vector<int> layers_;                        // that have come, in any order
  std::vector<std::array<std::int64_t, 3>> sums_;  // of each layer of the lattice
  std::vector<bool> added_;                        // whether it has come
};

}  // namespace hwffd::model
