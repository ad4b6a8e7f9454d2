#include "row.hpp"

#include <utility>

#include "hwffd/bounds/bound.hpp"
#include "hwffd/model/organization.hpp"
#include "hwffd/numerics/binary32.hpp"

namespace hwffd::words {
namespace {

constexpr int kNarrowest = 12;
constexpr int kWidest = 32;
/// Up to here every coordinate is looked at: 2^26 of them take seconds.
constexpr int kWidestExhaustive = 28;

template <int W>
bounds::AxisError fixed_axis_error() {
  if constexpr (W <= kWidestExhaustive) {
    return bounds::exhaustive_axis_error<W>();
  } else {
    return bounds::propagated_axis_error(W);
  }
}

/// The form ((B_l B_m) B_n) P, summed. A further form has these members too.
struct Product {
  static constexpr const char* kName = "product";

  template <class F>
  static model::VectorSum<F> evaluate(const model::LocalVertex<F>& vertex,
                                      const model::Support<F>& support,
                                      const model::CoefficientBank<F>& bank, int n) {
    return model::summation<F>(model::factors_of<F>(vertex, support, bank), n);
  }
  template <int W>
  static double fixed_bound() {
    return bounds::fixed_product_bound(W, fixed_axis_error<W>());
  }
  static double binary32_bound(int n, bool fused) {
    return bounds::binary32_product_bound(n, fused);
  }
};

template <class Form, class F>
model::VectorSum<F> evaluate_words(const model::VertexWords& words,
                                   const model::CoefficientBank<F>& bank, int n) {
  model::LocalVertex<F> vertex;
  vertex.cell = words.cell;
  for (int axis = 0; axis < 3; ++axis) vertex.local[axis] = F::coordinate(words.local[axis]);
  model::Support<F> support;
  for (int i = 0; i < 192; ++i) support[i / 3][i % 3] = F::point(words.points[i]);
  return Form::template evaluate<F>(vertex, support, bank, n);
}

template <class F>
Point decode(const model::VectorSum<F>& sum, const WordCodec& codec) {
  Point point;
  for (int c = 0; c < 3; ++c) point[c] = codec.decode_point(F::out(sum[c]).word);
  return point;
}

template <class Form, int W>
class FixedRow final : public Row {
 public:
  FixedRow() : Row(Form::kName, bounds::fixed_name(W), W), codec_(format()) {}

  Point evaluate(const Sample& sample) const override {
    return decode<Fixed<W>>(evaluate_words<Form, Fixed<W>>(sample.fixed, bank_, 1), codec_);
  }
  double bound() const override { return Form::template fixed_bound<W>(); }

 private:
  WordCodec codec_;
  model::CoefficientBank<Fixed<W>> bank_ =
      bounds::bspline_bank<Fixed<W>>(bounds::fixed_name(W).c_str());
};

template <class Form, class F>
class BinaryRow final : public Row {
 public:
  BinaryRow(const std::string& format, int n, bool fused)
      : Row(Form::kName, format, 32), codec_("fp32"), n_(n), fused_(fused) {}

  Point evaluate(const Sample& sample) const override {
    return decode<F>(evaluate_words<Form, F>(sample.binary, bank_, n_), codec_);
  }
  double bound() const override { return Form::binary32_bound(n_, fused_); }

 private:
  WordCodec codec_;
  int n_;
  bool fused_;
  model::CoefficientBank<F> bank_ = bounds::bspline_bank<F>("fp32");
};

template <class Form, int... Offset>
void add_fixed(Rows& rows, std::integer_sequence<int, Offset...> /*offsets*/) {
  (rows.push_back(std::make_unique<FixedRow<Form, kNarrowest + Offset>>()), ...);
}

template <class Form>
void add_form(Rows& rows) {
  add_fixed<Form>(rows, std::make_integer_sequence<int, kWidest - kNarrowest + 1>());
  using Separate = BinaryRow<Form, Binary32>;
  using Fused = BinaryRow<Form, Binary32Fused>;
  rows.push_back(std::make_unique<Separate>("fp32-sequential", 1, false));
  rows.push_back(std::make_unique<Separate>("fp32-tree", 64, false));
  rows.push_back(std::make_unique<Fused>("fp32-fused-sequential", 1, true));
  rows.push_back(std::make_unique<Fused>("fp32-fused-tree", 64, true));
}

}  // namespace

Rows all_rows() {
  Rows rows;
  add_form<Product>(rows);
  return rows;
}

}  // namespace hwffd::words
