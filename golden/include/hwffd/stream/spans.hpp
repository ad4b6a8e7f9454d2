#pragma once

#include <array>
#include <string>
#include <vector>

#include "hwffd/stream/blending.hpp"

namespace hwffd {

/// Knots 0, 1, 2, ... around so many cells: every cell has the uniform B-spline.
std::vector<double> uniform_knots(int cells);

/// The same with the first and the last knot four times: the spline begins and ends in its first
/// and last control point. Only the two cells at either end differ from the uniform B-spline.
std::vector<double> clamped_knots(int cells);

/// The cubic B-splines of a knot vector, a set of four functions for each of its cells
/// (docs/numerics.md section 8). Cell i lies between the knots i + 3 and i + 4, x runs from 0 to 1
/// in it, and its functions belong to the control points i to i + 3: there are 4 knots more than
/// points, and 7 more than cells. A cell without length has the constant functions of its knot.
/// @throws UsageError for fewer than 8 knots, knots that decrease or are not finite, a knot that
///   comes more than 4 times, and knots that enclose no cell
std::vector<Blending> knot_spans(const std::vector<double>& knots);

/// The same with coefficients rounded together, so that the weights of a cell at x = 1 are those of
/// the next at x = 0, to the bit, in the arithmetic of that format, and sum to 1 there. In uniform
/// cells they are `watertight_bspline`. Across a knot of multiplicity 4 nothing joins.
std::vector<Blending> watertight_spans(const std::vector<double>& knots, const WordCodec& codec);

/// The spans of an axis as stream words, each with shifts of its own. The derivatives of all have
/// one exponent r, since a result does not say of which span it is.
std::vector<AxisWords> encode(const std::vector<Blending>& spans, const WordCodec& codec);

/// What a packet of opcode 9 does to the set of functions that it is part of.
enum class SpanSet { kGoesOn, kEnds };

/// The packets that bring spans of one axis, from `first` on: one for each run of equal shifts and
/// degrees, since these stand in the header.
/// @throws std::invalid_argument for no spans, or spans beyond 256
std::vector<Beat> spans_packets(int axis, int first, const std::vector<AxisWords>& spans,
                                Functions functions = Functions::kBlending,
                                SpanSet set = SpanSet::kEnds);

/// Everything that loads spans for s, t and u: opcode 1 with the functions of the middle span of
/// each axis, then only the spans that differ from it. For clamped knots at even distances that is
/// two spans a side.
std::vector<Beat> all_spans_packets(const std::array<std::vector<AxisWords>, 3>& axes,
                                    Functions functions = Functions::kBlending);

/// Whether two neighbouring cells with functions of their own give each control point the same
/// weight on their shared face, as `is_watertight(axis, ...)` has it of equal ones.
/// @param stride  control points from one cell to the other, 1 to 4
bool is_watertight(const AxisWords& lower, const AxisWords& upper, const std::string& format,
                   int stride = 1, bool fused = false);

}  // namespace hwffd
