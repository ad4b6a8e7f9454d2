#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace hwffd::model {

/// A blending function, or a derivative of one, as a packet brings it.
struct FunctionWords {
  int degree = 0;
  int shift = 0;
  std::array<std::uint32_t, 4> words{};
};

/// The four functions of an axis and their derivatives.
struct AxisFunctions {
  std::array<FunctionWords, 4> function{};
  std::array<FunctionWords, 4> derivative{};
};

/// The functions of each span: those in use, and those that came of a set which is not yet whole.
/// Mirrors what ffd_stream_functions does, not how: it keeps two copies of everything.
class SpanTable {
 public:
  explicit SpanTable(int spans) : axes_(3, std::vector<Span>(spans)) {}

  int spans() const { return static_cast<int>(axes_[0].size()); }

  /// As at the start.
  void reset() { *this = SpanTable(spans()); }

  /// A function of a packet of coefficients, for all spans of an axis.
  void set_common(int axis, int number, bool derivative, const FunctionWords& words) {
    put(common_[axis], number, derivative, words);
  }
  /// Takes the functions of that packet into use, and drops what came of a set.
  void take_common() {
    for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
      std::fill(axes_[axis].begin(), axes_[axis].end(), Span{common_[axis], {}, false});
    }
    derivatives_ = true;
  }

  /// A function of a span; until the last of them the span is not part of the set.
  void receive(int axis, int span, int number, bool derivative, const FunctionWords& words) {
    axes_[axis][span].came = false;
    put(axes_[axis][span].next, number, derivative, words);
  }
  /// All functions of a span have come.
  void complete(int axis, int span, bool derivatives) {
    axes_[axis][span].came = true;
    derivatives_ = derivatives_ && derivatives;
  }
  /// Whether all spans that came of this set have derivatives.
  bool set_has_derivatives() const { return derivatives_; }
  /// Takes the set into use.
  void take_set() {
    for (auto& axis : axes_) {
      for (Span& span : axis) {
        if (span.came) span.used = span.next;
        span.came = false;
      }
    }
    derivatives_ = true;
  }

  /// What a vertex of that cell uses.
  const AxisFunctions& of_cell(int axis, int cell) const {
    return axes_[axis][std::min(cell, spans() - 1)].used;
  }

 private:
  struct Span {
    AxisFunctions used;
    AxisFunctions next;
    bool came = false;
  };

  static void put(AxisFunctions& functions, int number, bool derivative,
                  const FunctionWords& words) {
    (derivative ? functions.derivative : functions.function)[number] = words;
  }

  std::vector<std::vector<Span>> axes_;
  std::array<AxisFunctions, 3> common_{};
  bool derivatives_ = true;  // of the set so far
};

}  // namespace hwffd::model
