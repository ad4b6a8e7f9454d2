#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "hwffd/model/evaluator.hpp"
#include "hwffd/stream/blending.hpp"

namespace hwffd::model {

/// An evaluator with the watertight B-spline and its derivative wired in: whatever is loaded, it is
/// that.
/// Mirrors ffd_eval_poly_bspline.
class HardWiredBspline final : public EvaluatorModel {
 public:
  HardWiredBspline(std::unique_ptr<EvaluatorModel> general, const std::string& format)
      : general_(std::move(general)),
        axis_(encode(watertight_bspline(WordCodec(format)), WordCodec(format))) {}

  void load(int bank, int axis, int function, int /*degree*/, int /*shift*/,
            const std::array<std::uint32_t, 4>& /*words*/) override {
    general_->load(bank, axis, function, axis_.degree, axis_.shift, axis_.word[function]);
  }

  void load_derivative(int bank, int axis, int function, int /*degree*/, int /*shift*/,
                       const std::array<std::uint32_t, 4>& /*words*/) override {
    const DerivativeWords& own = axis_.derivative;
    general_->load_derivative(bank, axis, function, axis_.degree, own.shift, own.word[function]);
  }

  ResultWords evaluate(int bank, const VertexWords& vertex) const override {
    return general_->evaluate(bank, vertex);
  }

  void evaluate(int bank, const ResidentPoints& points, const std::vector<ResidentVertex>& vertices,
                int derivative, std::vector<ResultWords>& results) const override {
    general_->evaluate(bank, points, vertices, derivative, results);
  }

  ResultWords determinant(int bank, const VertexWords& vertex) const override {
    return general_->determinant(bank, vertex);
  }

  std::uint32_t blank_word() const override { return general_->blank_word(); }
  std::uint32_t one_word() const override { return general_->one_word(); }
  CoordinateRange range(std::uint32_t word) const override { return general_->range(word); }

 private:
  std::unique_ptr<EvaluatorModel> general_;
  AxisWords axis_;
};

}  // namespace hwffd::model
