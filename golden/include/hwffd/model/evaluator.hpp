#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <type_traits>
#include <vector>

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/determinant.hpp"
#include "hwffd/model/grid_walker.hpp"
#include "hwffd/model/lane_evaluator.hpp"
#include "hwffd/model/organization.hpp"
#include "hwffd/model/resident_vertex.hpp"
#include "hwffd/numerics/out_word.hpp"

namespace hwffd::model {

/// The words of one vertex as the stream brings them: coordinates s, t, u, the cell, and 64 points
/// of three words in local order, n fastest.
struct VertexWords {
  static constexpr int kPosition = -1;

  std::array<std::uint32_t, 3> local{};
  std::array<int, 3> cell{};
  std::array<std::uint32_t, 192> points{};
  int derivative = kPosition;  ///< or the axis along which q is differentiated
  int exponent = 0;            ///< of the points, where the format has one for all (bfp32)
};

/// The bit-true model of an evaluator, whatever its format and organization: words in, words out.
/// Mirrors ffd_eval_stream with its converters.
class EvaluatorModel {
 public:
  virtual ~EvaluatorModel() = default;

  /// Loads one blending function: axis 0 to 2, function 0 to 3, coefficients of 1, x, x^2, x^3.
  virtual void load(int bank, int axis, int function, int degree, int shift,
                    const std::array<std::uint32_t, 4>& words) = 0;
  /// Loads its derivative in the same way.
  virtual void load_derivative(int bank, int axis, int function, int degree, int shift,
                               const std::array<std::uint32_t, 4>& words) = 0;
  /// Evaluates one vertex with the coefficients of a bank (0 or 1).
  virtual ResultWords evaluate(int bank, const VertexWords& vertex) const = 0;
  /// Evaluates vertices of a lattice that is there: what `evaluate` gives of each, in their order.
  /// @param derivative  as of `VertexWords`
  virtual void evaluate(int bank, const ResidentPoints& points,
                        const std::vector<ResidentVertex>& vertices, int derivative,
                        std::vector<ResultWords>& results) const = 0;
  /// A walker over the vertices of a grid of such a lattice, with the functions that are loaded
  /// now: what `evaluate` gives of each. None where the organization does not contract one axis
  /// after the other.
  /// @param points  stay until it is gone
  /// @param places  as of `axis_places`
  virtual std::unique_ptr<GridWalker> walker(int bank, const ResidentPoints& points,
                                             const std::array<std::vector<AxisPlace>, 3>& places,
                                             int derivative = VertexWords::kPosition) const = 0;
  /// det J of a vertex, whatever its `derivative` says: the word x, with y and z 0.
  virtual ResultWords determinant(int bank, const VertexWords& vertex) const = 0;
  /// The word of a coordinate that could not be computed.
  virtual std::uint32_t blank_word() const = 0;
  /// The word of the coordinate 1.
  virtual std::uint32_t one_word() const = 0;
  /// Whether a coordinate's word is a number in [0, 1].
  virtual CoordinateRange range(std::uint32_t word) const = 0;
};

/// The words of a vertex of a lattice that is there, with its support.
/// @param fourth  whether that is the points' fourth component, three times
VertexWords with_support(const ResidentPoints& points, const ResidentVertex& vertex,
                         bool fourth = false);

/// Number format `F` and organization `Organization<F>` behind the interface of words.
template <class F, template <class> class Organization>
class EvaluatorModelOf final : public EvaluatorModel {
  static constexpr bool kLaned = InLanes<F>::kThere;
  struct NoLanes {
    explicit NoLanes(const Configuration& /*configuration*/) {}
  };
  using Eight = std::conditional_t<kLaned, LaneEvaluator<F, Organization>, NoLanes>;

 public:
  explicit EvaluatorModelOf(const Configuration& configuration)
      : organization_(configuration), lanes_{Eight(configuration), Eight(configuration)} {}

  void load(int bank, int axis, int function, int degree, int shift,
            const std::array<std::uint32_t, 4>& words) override {
    banks_[bank].load(axis, function, degree, shift, words);
    if constexpr (kLaned) lanes_[bank].bank().load(axis, function, degree, shift, words);
  }

  void load_derivative(int bank, int axis, int function, int degree, int shift,
                       const std::array<std::uint32_t, 4>& words) override {
    banks_[bank].load_derivative(axis, function, degree, shift, words);
    if constexpr (kLaned) lanes_[bank].bank().load_derivative(axis, function, degree, shift, words);
  }

  ResultWords evaluate(int bank, const VertexWords& vertex) const override {
    const VectorSum<F> sum = sum_of(bank, vertex);
    ResultWords result;
    for (int c = 0; c < 3; ++c) put(result, c, F::out(sum[c], vertex.exponent));
    return result;
  }

  void evaluate(int bank, const ResidentPoints& points, const std::vector<ResidentVertex>& vertices,
                int derivative, std::vector<ResultWords>& results) const override {
    if constexpr (kLaned) {
      lanes_[bank].evaluate(points, vertices, derivative, results);
    } else {
      results.clear();
      for (const ResidentVertex& vertex : vertices) {
        VertexWords words = with_support(points, vertex);
        words.derivative = derivative;
        results.push_back(evaluate(bank, words));
      }
    }
  }

  std::unique_ptr<GridWalker> walker(int bank, const ResidentPoints& points,
                                     const std::array<std::vector<AxisPlace>, 3>& places,
                                     int derivative) const override {
    if constexpr (kContracts<Organization<F>>) {
      return MakeWalker<F>::of(points,
                               walked_axes<F, Organization<F>>(banks_[bank], places, derivative));
    } else {
      return nullptr;
    }
  }

  ResultWords determinant(int bank, const VertexWords& vertex) const override {
    std::array<VectorSum<F>, 3> columns;
    VertexWords along = vertex;
    for (int axis = 0; axis < 3; ++axis) {
      along.derivative = axis;
      columns[axis] = sum_of(bank, along);
    }
    ResultWords result;
    put(result, 0, model::determinant<F>(columns, vertex.exponent));
    return result;
  }

  std::uint32_t blank_word() const override { return F::kBlankWord; }
  std::uint32_t one_word() const override { return F::kOneWord; }
  CoordinateRange range(std::uint32_t word) const override { return F::range(word); }

 private:
  VectorSum<F> sum_of(int bank, const VertexWords& vertex) const {
    LocalVertex<F> local;
    local.cell = vertex.cell;
    local.derivative = vertex.derivative;
    for (int axis = 0; axis < 3; ++axis) local.local[axis] = F::coordinate(vertex.local[axis]);
    Support<F> support;
    for (int p = 0; p < 64; ++p) {
      for (int c = 0; c < 3; ++c)
        support[p][c] = F::point(vertex.points[3 * p + c], vertex.exponent);
    }
    return organization_.evaluate(local, support, banks_[bank]);
  }

  static void put(ResultWords& result, int component, const OutWord& out) {
    result.words[component] = out.word;
    result.saturated |= out.saturated;
    result.nan |= out.nan;
  }

  Organization<F> organization_;
  std::array<CoefficientBank<F>, 2> banks_{};
  std::array<Eight, 2> lanes_;  // by bank
};

/// The model of a row of the table of configurations.
std::unique_ptr<EvaluatorModel> make_evaluator_model(const Configuration& configuration);

}  // namespace hwffd::model
