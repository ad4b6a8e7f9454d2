#include "glu/knots.hpp"

#include "glu/error.hpp"

namespace hwffd::glu {
namespace {

using Polynomial = Eigen::RowVector4d;  // of 1, x, x^2, x^3

/// p times (a + b x); the degree stays below 4.
Polynomial times_linear(const Polynomial& p, double a, double b) {
  Polynomial product = a * p;
  product.tail<3>() += b * p.head<3>();
  return product;
}

}  // namespace

Knots::Knots(int order, int count, const float* knots) : order_(order) {
  if (order < 1 || order > gl::AxisBlending::kMaxDegree + 1) throw GluError{GLU_FFD_INVALID_ORDER};
  if (count < 2 * order) throw GluError{GLU_FFD_TOO_FEW_KNOTS};
  // Uniform knots may be more than memory holds, and have no other mistake.
  if (knots == nullptr && count - 2 * order >= gl::AxisBlending::kMaxCells) {
    throw GluError{GLU_FFD_TOO_MANY_CELLS};
  }
  for (int i = 0; i < count; ++i) knots_.push_back(knots == nullptr ? i : knots[i]);
  check();
  if (cells() > gl::AxisBlending::kMaxCells) throw GluError{GLU_FFD_TOO_MANY_CELLS};
}

void Knots::check() const {
  // So written, knots that are not numbers fail too.
  if (!(knots_[points()] > knots_[order_ - 1])) throw GluError{GLU_FFD_EMPTY_KNOT_RANGE};
  int repeated = 1;
  bool too_often = false;
  for (std::size_t i = 1; i < knots_.size(); ++i) {
    if (!(knots_[i] >= knots_[i - 1])) throw GluError{GLU_FFD_DECREASING_KNOTS};
    repeated = knots_[i] == knots_[i - 1] ? repeated + 1 : 1;
    too_often |= repeated > order_;
  }
  if (too_often) throw GluError{GLU_FFD_KNOT_MULTIPLICITY};
}

bool Knots::is_empty(int cell) const { return knots_[cell + order_] == knots_[cell + order_ - 1]; }

gl::AxisBlending Knots::blending(int cell) const {
  const int span = cell + order_ - 1;
  const double begin = knots_[span];
  const double length = knots_[span + 1] - begin;
  // Before step p, row l is the B-spline of degree p - 1 that begins at knot span - p + 1 + l.
  Oracle::Coefficients functions = Oracle::Coefficients::Zero();
  functions(0, 0) = 1;
  for (int p = 1; p < order_; ++p) {
    Oracle::Coefficients raised = Oracle::Coefficients::Zero();
    for (int l = 0; l < p; ++l) {
      const double first = knots_[span - p + 1 + l];
      const double last = knots_[span + 1 + l];
      const double width = last - first;
      const Polynomial part = functions.row(l);
      raised.row(l) += times_linear(part, (last - begin) / width, -length / width);
      raised.row(l + 1) += times_linear(part, (begin - first) / width, length / width);
    }
    functions = raised;
  }
  return gl::AxisBlending(order_ - 1, functions);
}

}  // namespace hwffd::glu
