#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "hwffd/model/configuration.hpp"
#include "hwffd/model/determinant.hpp"
#include "hwffd/model/organization.hpp"
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

/// x, y, z as the stream returns them, and whether any of them saturated or is NaN.
struct ResultWords {
  std::array<std::uint32_t, 3> words{};
  bool saturated = false;
  bool nan = false;
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
  /// det J of a vertex, whatever its `derivative` says: the word x, with y and z 0.
  virtual ResultWords determinant(int bank, const VertexWords& vertex) const = 0;
  /// The word of a coordinate that could not be computed.
  virtual std::uint32_t blank_word() const = 0;
  /// The word of the coordinate 1.
  virtual std::uint32_t one_word() const = 0;
  /// Whether a coordinate's word is a number in [0, 1].
  virtual CoordinateRange range(std::uint32_t word) const = 0;
};

/// Number format `F` and organization `Organization<F>` behind the interface of words.
template <class F, template <class> class Organization>
class EvaluatorModelOf final : public EvaluatorModel {
 public:
  explicit EvaluatorModelOf(const Configuration& configuration) : organization_(configuration) {}

  void load(int bank, int axis, int function, int degree, int shift,
            const std::array<std::uint32_t, 4>& words) override {
    banks_[bank].load(axis, function, degree, shift, words);
  }

  void load_derivative(int bank, int axis, int function, int degree, int shift,
                       const std::array<std::uint32_t, 4>& words) override {
    banks_[bank].load_derivative(axis, function, degree, shift, words);
  }

  ResultWords evaluate(int bank, const VertexWords& vertex) const override {
    const VectorSum<F> sum = sum_of(bank, vertex);
    ResultWords result;
    for (int c = 0; c < 3; ++c) put(result, c, F::out(sum[c], vertex.exponent));
    return result;
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
};

/// The model of a row of the table of configurations.
std::unique_ptr<EvaluatorModel> make_evaluator_model(const Configuration& configuration);

}  // namespace hwffd::model
