#pragma once

#include <random>

#include "axis.hpp"
#include "hwffd/model/evaluator.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::certified {

/// A vertex whose result is far off: its words, what the model makes of one component, and eq. (1).
struct Witness {
  model::VertexWords vertex;
  int component = 0;
  std::uint32_t result = 0;
  double error = 0;  ///< |result - eq. (1) of the words|
};

/// Words of points of a kind of format.
struct FixedPoints {
  /// Nearly 1, so that sums do not saturate where weights sum to more, and half a unit below a
  /// number: rounded upwards.
  static std::uint32_t top(double sign, int width) {
    const std::int64_t unit = std::int64_t{1} << (32 - width);
    const std::int64_t number = (std::int64_t{1} << (width - 1)) - 24;
    const std::int64_t word = sign > 0 ? number * unit - unit / 2 : -number * unit - unit / 2;
    return static_cast<std::uint32_t>(word);
  }
  static std::uint32_t moved(std::uint32_t word, std::mt19937_64& engine) {
    const std::int64_t step = std::int64_t{1} << (engine() % 24);
    const auto by = static_cast<std::int64_t>(engine() % static_cast<std::uint64_t>(2 * step + 1));
    const std::int64_t to = static_cast<std::int32_t>(word) + by - step;
    return static_cast<std::uint32_t>(std::clamp<std::int64_t>(to, -0x7FFFFFFF, 0x7FFFFFFF));
  }
};

struct FloatPoints {
  static std::uint32_t top(double sign, int /*width*/) {
    return bits_of_float(sign > 0 ? 0x1.ffffp-1F : -0x1.ffffp-1F);
  }
  static std::uint32_t moved(std::uint32_t word, std::mt19937_64& engine) {
    const std::uint64_t step = std::uint64_t{1} << (engine() % 20);
    const float to =
        float_of_bits(static_cast<std::uint32_t>(word + engine() % (2 * step + 1) - step));
    return bits_of_float(std::abs(to) < 1 ? to : float_of_bits(word));
  }
};

template <class F>
using PointsOf =
    std::conditional_t<std::is_same_v<typename F::Weight, float> || std::is_same_v<F, Block32>,
                       FloatPoints, FixedPoints>;

/// Hill climbing over the control points of a vertex, each component by itself, with the model
/// itself as judge: whatever it rounds is in it. Results that are flagged do not count.
template <class F, template <class> class Organization>
class Climb {
 public:
  Climb(model::EvaluatorModelOf<F, Organization>& core, const std::string& format,
        const Four (&exact)[3], const model::VertexWords& vertex)
      : core_(core), codec_(format), vertex_(vertex) {
    for (int p = 0; p < 64; ++p) {
      products_[p] =
          static_cast<long double>(exact[0][p >> 4]) * exact[1][p >> 2 & 3] * exact[2][p & 3];
    }
    for (int c = 0; c < 3; ++c) sum_[c] = error_[c] = 0;
    for (int p = 0; p < 64; ++p) {
      for (int c = 0; c < 3; ++c) sum_[c] += products_[p] * value(vertex_.points[3 * p + c]);
    }
    judge(error_);
  }

  void run(int steps, std::mt19937_64& engine) {
    for (int step = 0; step < steps; ++step) {
      const int p = static_cast<int>(engine() % 64);
      std::array<std::uint32_t, 3> before{};
      const std::array<long double, 3> sum = sum_;
      for (int c = 0; c < 3; ++c) {
        std::uint32_t& word = vertex_.points[3 * p + c];
        before[c] = word;
        word = PointsOf<F>::moved(word, engine);
        sum_[c] += products_[p] * (value(word) - value(before[c]));
      }
      std::array<double, 3> error{};
      const bool counts = judge(error);
      for (int c = 0; c < 3; ++c) {
        if (counts && std::abs(error[c]) >= std::abs(error_[c])) {
          error_[c] = error[c];
        } else {
          vertex_.points[3 * p + c] = before[c];
          sum_[c] = sum[c];
        }
      }
    }
  }

  /// The largest of the three, evaluated anew.
  Witness best() {
    Witness witness;
    witness.vertex = vertex_;
    const model::ResultWords result = core_.evaluate(0, vertex_);
    for (int c = 0; c < 3; ++c) {
      long double exact = 0;
      for (int p = 0; p < 64; ++p) exact += products_[p] * value(vertex_.points[3 * p + c]);
      const auto error = static_cast<double>(std::abs(value(result.words[c]) - exact));
      if (!result.saturated && error > witness.error) {
        witness.error = error;
        witness.component = c;
        witness.result = result.words[c];
      }
    }
    return witness;
  }

 private:
  long double value(std::uint32_t word) const { return codec_.decode_point(word); }

  bool judge(std::array<double, 3>& error) {
    const model::ResultWords result = core_.evaluate(0, vertex_);
    for (int c = 0; c < 3; ++c) {
      error[c] = static_cast<double>(value(result.words[c]) - sum_[c]);
    }
    return !result.saturated && !result.nan;
  }

  model::EvaluatorModelOf<F, Organization>& core_;
  WordCodec codec_;
  model::VertexWords vertex_;
  std::array<long double, 64> products_{};
  std::array<long double, 3> sum_{};
  std::array<double, 3> error_{};
};

}  // namespace hwffd::certified
