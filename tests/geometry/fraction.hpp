#pragma once

#include <cstdint>
#include <ostream>
#include <stdexcept>

namespace hwffd {

/// An exact fraction of 64-bit integers in lowest terms, its denominator above 0.
/// @throws std::overflow_error where a result does not fit
class Fraction {
 public:
  Fraction(std::int64_t numerator = 0, std::int64_t denominator = 1) {
    reduce(numerator, denominator);
  }

  friend Fraction operator+(const Fraction& a, const Fraction& b) {
    Fraction sum;
    sum.reduce(Wide(a.numerator_) * b.denominator_ + Wide(b.numerator_) * a.denominator_,
               Wide(a.denominator_) * b.denominator_);
    return sum;
  }
  friend Fraction operator*(const Fraction& a, const Fraction& b) {
    Fraction product;
    product.reduce(Wide(a.numerator_) * b.numerator_, Wide(a.denominator_) * b.denominator_);
    return product;
  }
  friend bool operator==(const Fraction& a, const Fraction& b) {
    return a.numerator_ == b.numerator_ && a.denominator_ == b.denominator_;
  }
  friend bool operator!=(const Fraction& a, const Fraction& b) { return !(a == b); }
  friend std::ostream& operator<<(std::ostream& out, const Fraction& x) {
    return out << x.numerator_ << '/' << x.denominator_;
  }

 private:
  using Wide = __int128;

  void reduce(Wide numerator, Wide denominator) {
    Wide a = numerator < 0 ? -numerator : numerator;
    Wide b = denominator;
    while (b != 0) {
      const Wide rest = a % b;
      a = b;
      b = rest;
    }
    numerator /= a;
    denominator /= a;
    numerator_ = static_cast<std::int64_t>(numerator);
    denominator_ = static_cast<std::int64_t>(denominator);
    if (numerator_ != numerator || denominator_ != denominator || denominator_ <= 0) {
      throw std::overflow_error("fraction out of range");
    }
  }

  std::int64_t numerator_ = 0;
  std::int64_t denominator_ = 1;
};

}  // namespace hwffd
