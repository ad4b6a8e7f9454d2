#include "hwffd/stream/spans.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "hwffd/error.hpp"

namespace hwffd {
namespace {

using Real = long double;
using Four = std::array<Real, 4>;
/// Of a cell: `[function][power]`, unrounded.
using Exact = std::array<Four, 4>;

constexpr std::size_t kOrder = 4;

void check(const std::vector<double>& knots) {
  if (knots.size() < 2 * kOrder) {
    throw UsageError(
        fmt::format("{} knots: a cubic axis wants 8 or more, 4 more than points", knots.size()));
  }
  std::size_t repeated = 0;
  for (std::size_t i = 0; i < knots.size(); ++i) {
    if (!std::isfinite(knots[i])) {
      throw UsageError(fmt::format("knot {} is {}: finite numbers are wanted", i, knots[i]));
    }
    if (i > 0 && knots[i] < knots[i - 1]) {
      throw UsageError(fmt::format("knot {} is {} after {}: knots must not decrease", i, knots[i],
                                   knots[i - 1]));
    }
    repeated = i > 0 && knots[i] == knots[i - 1] ? repeated + 1 : 1;
    if (repeated > kOrder) {
      throw UsageError(fmt::format("knot {} comes {} times: 4 times at most", knots[i], repeated));
    }
  }
  const double first = knots[kOrder - 1];
  if (!(knots[knots.size() - kOrder] > first)) {
    throw UsageError(fmt::format("no cell between knots that are all {}", first));
  }
}

std::size_t cells_of(const std::vector<double>& knots) { return knots.size() - 2 * kOrder + 1; }

bool is_empty(const std::vector<double>& knots, std::size_t cell) {
  return knots[cell + kOrder] == knots[cell + kOrder - 1];
}

/// What the points of a cell that is not empty weigh in the blossom of its cubic at three
/// arguments: de Boor's triangle with an argument of its own in each level.
Four blossom(const std::vector<double>& knots, std::size_t cell, const std::array<Real, 3>& at) {
  std::array<Four, 4> weights{};
  for (std::size_t l = 0; l < 4; ++l) weights[l][l] = 1;
  for (std::size_t level = 1; level < kOrder; ++level) {
    for (std::size_t j = kOrder - 1; j >= level; --j) {
      const Real low = knots[cell + j];
      const Real high = knots[cell + j + kOrder - level];
      const Real share = (at[level - 1] - low) / (high - low);
      for (std::size_t l = 0; l < 4; ++l) {
        weights[j][l] = (1 - share) * weights[j - 1][l] + share * weights[j][l];
      }
    }
  }
  return weights[kOrder - 1];
}

/// The functions of a cell that is not empty: its Bezier points, then powers of x.
Exact functions_of(const std::vector<double>& knots, std::size_t cell) {
  const Real begin = knots[cell + kOrder - 1];
  const Real end = knots[cell + kOrder];
  const Four b0 = blossom(knots, cell, {begin, begin, begin});
  const Four b1 = blossom(knots, cell, {begin, begin, end});
  const Four b2 = blossom(knots, cell, {begin, end, end});
  const Four b3 = blossom(knots, cell, {end, end, end});
  Exact functions{};
  for (std::size_t l = 0; l < 4; ++l) {
    functions[l] = {b0[l], 3 * (b1[l] - b0[l]), 3 * (b2[l] - 2 * b1[l] + b0[l]),
                    b3[l] - 3 * b2[l] + 3 * b1[l] - b0[l]};
  }
  return functions;
}

/// A cell that is not empty, on the way to rounded coefficients.
struct Cell {
  std::size_t index = 0;
  Exact exact{};
  Blending::Matrix rounded{};
  std::array<double, 4> at_end{};  ///< weights at x = 1
  double unit = 0;                 ///< of partial sums at x = 1
};

/// The nearest doubles of a cell's exact functions.
void start(Cell& cell) {
  for (std::size_t l = 0; l < 4; ++l) {
    Real sum = 0;
    for (std::size_t power = 0; power < 4; ++power) {
      const Real c = cell.exact[l][power];
      cell.rounded[l][power] = static_cast<double>(c);
      sum += c;
    }
    cell.at_end[l] = static_cast<double>(sum);
  }
}

std::vector<Cell> cells_with_length(const std::vector<double>& knots) {
  std::vector<Cell> cells;
  for (std::size_t i = 0; i < cells_of(knots); ++i) {
    if (is_empty(knots, i)) continue;
    cells.push_back({i, functions_of(knots, i), {}, {}, 0});
    start(cells.back());
  }
  return cells;
}

/// Every cell's functions, those without length included.
std::vector<Blending> spans_of(const std::vector<double>& knots, const std::vector<Cell>& cells) {
  std::vector<Blending> spans(cells_of(knots));
  std::size_t next = 0;
  for (std::size_t i = 0; i < spans.size(); ++i) {
    if (next < cells.size() && cells[next].index == i) {
      const Cell& cell = cells[next++];
      Blending::Matrix exact{};
      for (std::size_t l = 0; l < 4; ++l) {
        for (std::size_t p = 0; p < 4; ++p) exact[l][p] = static_cast<double>(cell.exact[l][p]);
      }
      spans[i] = {cell.rounded, 3, differentiated(exact)};
      continue;
    }
    // The weights of its knot, from the next cell's beginning or else the last one's end.
    const bool after = next < cells.size();
    const Cell& cell = after ? cells[next] : cells.back();
    for (std::size_t l = 0; l < 4; ++l) {
      const double weight = after ? cell.rounded[l][0] : cell.at_end[l];
      if (weight != 0) spans[i].coefficient[cell.index + l - i][0] = weight;
    }
  }
  return spans;
}

/// The unit in which numbers up to so much have 24 bits.
double unit_of_24_bits(double magnitude) {
  int exponent = 0;
  const double fraction = std::frexp(magnitude, &exponent);
  return std::ldexp(1.0, (fraction == 0.5 ? exponent - 1 : exponent) - 24);
}

/// Rounds four numbers to a unit; the largest takes up what their sum is then off.
std::array<double, 4> rounded_together(const std::array<double, 4>& values, double sum,
                                       double unit) {
  std::array<double, 4> rounded{};
  std::size_t largest = 0;
  for (std::size_t l = 0; l < 4; ++l) {
    rounded[l] = std::nearbyint(values[l] / unit) * unit;
    if (std::abs(values[l]) > std::abs(values[largest])) largest = l;
    sum -= rounded[l];
  }
  rounded[largest] += sum;
  return rounded;
}

/// The functions' coefficients of one power.
std::array<double, 4> column(const Blending::Matrix& matrix, std::size_t power) {
  return {matrix[0][power], matrix[1][power], matrix[2][power], matrix[3][power]};
}

void set_column(Blending::Matrix& matrix, std::size_t power, const std::array<double, 4>& values) {
  for (std::size_t l = 0; l < 4; ++l) matrix[l][power] = values[l];
}

double largest_of(const std::array<double, 4>& values) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  return largest;
}

/// The largest partial sum of Horner's rule at x = 1.
double largest_sum_at_end(const Blending::Matrix& matrix) {
  double largest = 0;
  for (const auto& c : matrix) {
    double sum = 0;
    for (std::size_t power = 4; power-- > 0;) {
      sum += c[power];
      largest = std::max(largest, std::abs(sum));
    }
  }
  return largest;
}

/// A cell's unit, such that every partial sum at x = 1 is exact.
double unit_of(const Blending::Matrix& matrix, const WordCodec& codec) {
  if (!codec.has_fixed_weights()) return unit_of_24_bits(largest_sum_at_end(matrix));
  int shift = 0;
  while (std::ldexp(horner_magnitude(Blending{matrix, 3, {}}), -shift) >= 2 && shift < 3) ++shift;
  return std::ldexp(1.0, shift - codec.weight_fraction());
}

/// Whether the sums are still exact where rounding has made numbers larger.
bool fits(const Cell& cell, const WordCodec& codec) {
  return unit_of(cell.rounded, codec) <= cell.unit;
}

/// That of a column: binary32 has no more bits for larger coefficients.
double column_unit(const std::array<double, 4>& values, double unit, const WordCodec& codec) {
  if (codec.has_fixed_weights() || largest_of(values) == 0) return unit;
  return std::max(unit, unit_of_24_bits(largest_of(values)));
}

/// Whether the weights of one cell at x = 1 are those of the next at x = 0: they are, unless the
/// knot between them comes four times.
bool joins(const Cell& lower, const Cell& upper) { return upper.index - lower.index < kOrder; }

/// Rounds the coefficients of 1, x and x^2, each by itself but for their sums.
void round_beginning(Cell& cell, double unit, const WordCodec& codec) {
  set_column(cell.rounded, 0, rounded_together(column(cell.rounded, 0), 1, unit));
  for (std::size_t power = 1; power < 3; ++power) {
    const auto values = column(cell.rounded, power);
    set_column(cell.rounded, power,
               rounded_together(values, 0, column_unit(values, cell.unit, codec)));
  }
}

/// Gives the coefficients of x^3 what is left to the weights at x = 1.
void round_end(Cell& cell, const Cell* next) {
  if (next == nullptr) {
    cell.at_end = rounded_together(cell.at_end, 1, cell.unit);
  } else {
    const std::size_t stride = next->index - cell.index;
    cell.at_end = {};
    for (std::size_t l = stride; l < 4; ++l) cell.at_end[l] = next->rounded[l - stride][0];
  }
  for (std::size_t l = 0; l < 4; ++l) {
    auto& c = cell.rounded[l];
    c[3] = cell.at_end[l] - (c[0] + c[1] + c[2]);
  }
}

void round_cells(std::vector<Cell>& cells, const WordCodec& codec) {
  for (Cell& cell : cells) cell.unit = unit_of(cell.rounded, codec);
  for (bool again = true; again;) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
      start(cells[i]);
      const bool joined = i > 0 && joins(cells[i - 1], cells[i]);
      const double unit = cells[i].unit;
      round_beginning(cells[i], joined ? std::max(cells[i - 1].unit, unit) : unit, codec);
    }
    again = false;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool joined = i + 1 < cells.size() && joins(cells[i], cells[i + 1]);
      round_end(cells[i], joined ? &cells[i + 1] : nullptr);
      if (fits(cells[i], codec)) continue;
      cells[i].unit *= 2;
      again = true;
    }
  }
}

std::vector<double> whole_knots(int cells, bool clamped) {
  if (cells < 1) throw UsageError(fmt::format("{} cells of an axis: 1 or more are wanted", cells));
  std::vector<double> knots;
  for (int i = -3; i <= cells + 3; ++i) {
    knots.push_back(clamped ? std::clamp(i, 0, cells) : i);
  }
  return knots;
}

}  // namespace

std::vector<double> uniform_knots(int cells) { return whole_knots(cells, false); }

std::vector<double> clamped_knots(int cells) { return whole_knots(cells, true); }

std::vector<Blending> knot_spans(const std::vector<double>& knots) {
  check(knots);
  return spans_of(knots, cells_with_length(knots));
}

std::vector<Blending> watertight_spans(const std::vector<double>& knots, const WordCodec& codec) {
  check(knots);
  std::vector<Cell> cells = cells_with_length(knots);
  round_cells(cells, codec);
  return spans_of(knots, cells);
}

}  // namespace hwffd
