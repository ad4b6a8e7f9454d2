#pragma once

#include <array>
#include <cstdint>

namespace hwffd::model {

/// One bank of the polynomial coefficient register file (paper, section 3.3.3) in format `F`.
///
/// `entry[axis][function]`: axes s, t, u; functions B_0 to B_3; coefficients of 1, x, x^2, x^3.
/// `derivative`: the same for the functions' derivatives.
/// Mirrors ffd_eval_coefficient_file.
template <class F>
struct CoefficientBank {
  struct Entry {
    std::array<typename F::Weight, 4> coefficient{};
    int shift = 0;
  };
  using Functions = std::array<Entry, 4>;  ///< of an axis
  using Entries = std::array<Functions, 3>;
  Entries entry{};
  Entries derivative{};

  /// Loads one blending function from the stream's words; powers above the degree become 0.
  void load(int axis, int function, int degree, int shift,
            const std::array<std::uint32_t, 4>& words) {
    load(entry[axis][function], degree, shift, words);
  }
  /// Loads its derivative.
  void load_derivative(int axis, int function, int degree, int shift,
                       const std::array<std::uint32_t, 4>& words) {
    load(derivative[axis][function], degree, shift, words);
  }

 private:
  static void load(Entry& e, int degree, int shift, const std::array<std::uint32_t, 4>& words) {
    for (int power = 0; power < 4; ++power) {
      e.coefficient[power] = power <= degree ? F::coefficient(words[power]) : F::zero_weight();
    }
    e.shift = shift;
  }
};

/// The weight B_function(x) of an axis, or its derivative, by Horner's rule: three steps, then the
/// shift back. Mirrors ffd_eval_poly_pipelined and ffd_eval_poly_iterative, which give the same
/// bits.
template <class F>
typename F::Weight polynomial(const CoefficientBank<F>& bank, int axis, int function,
                              typename F::Weight x, bool derivative = false) {
  const auto& e = (derivative ? bank.derivative : bank.entry)[axis][function];
  typename F::Weight weight = e.coefficient[3];
  for (int power = 2; power >= 0; --power) weight = F::step(e.coefficient[power], x, weight);
  return F::scale(weight, e.shift);
}

}  // namespace hwffd::model
