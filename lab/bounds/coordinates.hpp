#pragma once

#include <functional>
#include <random>

#include "axis.hpp"

namespace hwffd::certified {

/// An axis at one coordinate with its weights in units.
struct Candidate {
  AxisPoint point;
  int cell = 0;  ///< where these weights depend on it
  std::array<std::int64_t, 4> units{};
};

using Triple = std::array<Candidate, 3>;

/// What may be tried of each axis.
using Choices = std::array<const std::vector<Candidate>*, 3>;

/// The same of all three.
inline Choices alike(const std::vector<Candidate>& candidates) {
  return {&candidates, &candidates, &candidates};
}

/// The sum of 64 errors of products of weights, none of which is rounded: what `factored` has.
inline double exact_distance(const Candidate& s, const Candidate& t, const Candidate& u) {
  double sum = 0;
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      const double computed = s.point.weight[l] * t.point.weight[m];
      const double exact = s.point.exact[l] * t.point.exact[m];
      for (int n = 0; n < 4; ++n) {
        sum += std::abs(computed * u.point.weight[n] - exact * u.point.exact[n]);
      }
    }
  }
  return sum;
}

/// The product of two weights of `fraction` digits, rounded half up.
template <class Wide>
std::int64_t rounded_product(std::int64_t a, std::int64_t b, int fraction) {
  return static_cast<std::int64_t>((static_cast<Wide>(a) * b + (Wide{1} << (fraction - 1))) >>
                                   fraction);
}

/// The same of products that are rounded twice: the product form.
template <class Wide>
double rounded_distance(const Candidate& s, const Candidate& t, const Candidate& u, int fraction) {
  const double unit = std::ldexp(1, -fraction);
  double sum = 0;
  for (int l = 0; l < 4; ++l) {
    for (int m = 0; m < 4; ++m) {
      const std::int64_t pair = rounded_product<Wide>(s.units[l], t.units[m], fraction);
      const double exact = s.point.exact[l] * t.point.exact[m];
      for (int n = 0; n < 4; ++n) {
        const std::int64_t all = rounded_product<Wide>(pair, u.units[n], fraction);
        sum += std::abs(static_cast<double>(all) * unit - exact * u.point.exact[n]);
      }
    }
  }
  return sum;
}

/// Those within two units of a sixteenth: many products of their weights lie half-way between
/// numbers.
inline std::vector<Candidate> near_sixteenths(const std::vector<Candidate>& candidates,
                                              double unit) {
  std::vector<Candidate> result;
  for (const Candidate& candidate : candidates) {
    const double sixteenths = candidate.point.x * 16;
    if (std::abs(sixteenths - std::round(sixteenths)) <= 40 * unit) result.push_back(candidate);
  }
  return result;
}

/// One axis after the other takes its best candidate, until none improves; from so many random
/// starts, in two of three of them from those preferred.
template <class Objective>
Triple best_triple(const Choices& choices, const std::vector<Candidate>& preferred, int starts,
                   std::mt19937_64& engine, const Objective& objective) {
  Triple best;
  double most = -1;
  for (int start = 0; start < starts; ++start) {
    Triple triple;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto& from = preferred.empty() || engine() % 3 == 0 ? *choices[axis] : preferred;
      triple[axis] = from[engine() % from.size()];
    }
    double here = -1;
    for (std::size_t axis = 0, idle = 0; idle < 3; axis = (axis + 1) % 3) {
      const double before = here;
      Triple probe = triple;
      for (const Candidate& candidate : *choices[axis]) {
        probe[axis] = candidate;
        const double reached = objective(probe);
        if (reached > here) {
          here = reached;
          triple[axis] = candidate;
        }
      }
      idle = here > before * (1 + 1e-12) ? 0 : idle + 1;
    }
    if (here > most) {
      most = here;
      best = triple;
    }
  }
  return best;
}

}  // namespace hwffd::certified
