#include "hwffd/registration/l_bfgs.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <limits>
#include <utility>

#include "hwffd/error.hpp"
#include "lane_sum.hpp"

namespace hwffd {
namespace {

using Vector = std::vector<double>;

// Of L-BFGS-B 3.0.
constexpr double kDecrease = 1e-3;
constexpr double kCurvature = 0.9;
constexpr double kInterval = 0.1;
constexpr double kMostStep = 1e10;
constexpr int kMostTries = 20;  // of a line search

double dot(const Vector& a, const Vector& b) {
  return lane_sum(a.size(), [&](std::size_t i) { return a[i] * b[i]; });
}

double largest(const Vector& a) {
  double result = 0.0;
  for (const double x : a) result = std::max(result, std::abs(x));
  return result;
}

/// A step of a line search, with the value and its derivative along the line.
struct Sample {
  double step, value, slope;
};

/// The step of More and Thuente (1994): minimizes along a line by cubics and parabolas, in an
/// interval once there is one. Their names: st* the trial, stx the best, sty the other end.
class MoreThuente {
 public:
  /// @param most  steps from which on none is tried
  MoreThuente(double value, double slope, double step, double most)
      : start_{0.0, value, slope},
        best_(start_),
        other_(start_),
        step_(step),
        most_(most),
        high_(5 * step),
        width_(most),
        width_before_(2 * most) {}

  double step() const { return step_; }
  const Sample& best() const { return best_; }

  enum class Next { kTry, kConverged, kFailed };

  /// After the value at step().
  Next take(double value, double slope) {
    const double wanted = kDecrease * start_.slope;
    const double limit = start_.value + step_ * wanted;
    if (first_stage_ && value <= limit && slope >= 0.0) first_stage_ = false;
    if (value <= limit && std::abs(slope) <= kCurvature * -start_.slope) return Next::kConverged;
    if (bracketed_ && (step_ <= low_ || step_ >= high_ || high_ - low_ <= kInterval * high_)) {
      return Next::kFailed;
    }
    if (step_ >= most_) return Next::kFailed;
    Sample trial{step_, value, slope};
    if (first_stage_ && value <= best_.value && value > limit) {
      // Of the function less the line that a sufficient decrease is measured by.
      trial = tilted(trial, -wanted);
      best_ = tilted(best_, -wanted);
      other_ = tilted(other_, -wanted);
      choose(trial);
      best_ = tilted(best_, wanted);
      other_ = tilted(other_, wanted);
    } else {
      choose(trial);
    }
    if (bracketed_) {
      if (std::abs(other_.step - best_.step) >= 0.66 * width_before_) {
        step_ = best_.step + 0.5 * (other_.step - best_.step);
      }
      width_before_ = width_;
      width_ = std::abs(other_.step - best_.step);
      low_ = std::min(best_.step, other_.step);
      high_ = std::max(best_.step, other_.step);
    } else {
      low_ = step_ + 1.1 * (step_ - best_.step);
      high_ = step_ + 4.0 * (step_ - best_.step);
    }
    step_ = std::clamp(step_, 0.0, most_);
    if (step_ >= bound_) step_ = best_.step + 0.5 * (bound_ - best_.step);
    if (bracketed_ && (step_ <= low_ || step_ >= high_ || high_ - low_ <= kInterval * high_)) {
      step_ = best_.step;
    }
    return Next::kTry;
  }

  /// Where step() is out of bounds: no larger one is tried.
  Next refuse() {
    bound_ = step_;
    step_ = best_.step + 0.5 * (bound_ - best_.step);
    high_ = std::min(high_, bound_);
    return step_ > best_.step && step_ < bound_ ? Next::kTry : Next::kFailed;
  }

 private:
  static Sample tilted(const Sample& at, double slope) {
    return {at.step, at.value + at.step * slope, at.slope + slope};
  }

  /// The cubic's minimum, from `a` in parts of the way to `b`; sign: which of its roots.
  static double cubic(const Sample& a, const Sample& b, double sign, bool guarded) {
    const double theta = 3 * (a.value - b.value) / (b.step - a.step) + a.slope + b.slope;
    const double s = std::max({std::abs(theta), std::abs(a.slope), std::abs(b.slope)});
    double root = (theta / s) * (theta / s) - (a.slope / s) * (b.slope / s);
    if (guarded) root = std::max(root, 0.0);
    const double gamma = sign * s * std::sqrt(root);
    return ((gamma - a.slope) + theta) / (((gamma - a.slope) + gamma) + b.slope);
  }

  void choose(const Sample& trial) {
    const double opposite = trial.slope * (best_.slope / std::abs(best_.slope));
    const double back = best_.step - trial.step;
    double chosen = 0.0;
    const auto parabola = [&] {
      return trial.step + trial.slope / (trial.slope - best_.slope) * back;
    };
    if (trial.value > best_.value) {
      const double ahead = trial.step - best_.step;
      const double r = cubic(best_, trial, trial.step < best_.step ? -1 : 1, false);
      const double by_cubic = best_.step + r * ahead;
      const double by_parabola =
          best_.step +
          best_.slope / ((best_.value - trial.value) / ahead + best_.slope) / 2 * ahead;
      chosen = std::abs(by_cubic - best_.step) < std::abs(by_parabola - best_.step)
                   ? by_cubic
                   : by_cubic + (by_parabola - by_cubic) / 2;
      bracketed_ = true;
    } else if (opposite < 0.0) {
      const double r = cubic(trial, best_, trial.step > best_.step ? -1 : 1, false);
      const double by_cubic = trial.step + r * back;
      chosen = std::abs(by_cubic - trial.step) > std::abs(parabola() - trial.step) ? by_cubic
                                                                                   : parabola();
      bracketed_ = true;
    } else if (std::abs(trial.slope) < std::abs(best_.slope)) {
      chosen = beyond(trial, parabola());
    } else if (bracketed_) {
      const double r = cubic(trial, other_, trial.step > other_.step ? -1 : 1, false);
      chosen = trial.step + r * (other_.step - trial.step);
    } else {
      chosen = trial.step > best_.step ? high_ : low_;
    }
    if (trial.value > best_.value) {
      other_ = trial;
    } else {
      if (opposite < 0.0) other_ = best_;
      best_ = trial;
    }
    step_ = chosen;
  }

  /// Where the slope gets less, and the minimum may lie further on.
  double beyond(const Sample& trial, double by_parabola) const {
    const double sign = trial.step > best_.step ? -1 : 1;
    const double theta =
        3 * (best_.value - trial.value) / (trial.step - best_.step) + best_.slope + trial.slope;
    const double s = std::max({std::abs(theta), std::abs(best_.slope), std::abs(trial.slope)});
    const double root = (theta / s) * (theta / s) - (best_.slope / s) * (trial.slope / s);
    const double gamma = sign * s * std::sqrt(std::max(root, 0.0));
    const double r =
        ((gamma - trial.slope) + theta) / ((gamma + (best_.slope - trial.slope)) + gamma);
    double by_cubic = trial.step > best_.step ? high_ : low_;
    if (r < 0.0 && gamma != 0.0) by_cubic = trial.step + r * (best_.step - trial.step);
    const bool cubic_is_nearer =
        std::abs(by_cubic - trial.step) < std::abs(by_parabola - trial.step);
    if (!bracketed_) {
      const bool cubic_is_farther =
          std::abs(by_cubic - trial.step) > std::abs(by_parabola - trial.step);
      return std::clamp(cubic_is_farther ? by_cubic : by_parabola, low_, high_);
    }
    const double chosen = cubic_is_nearer ? by_cubic : by_parabola;
    const double most = trial.step + 0.66 * (other_.step - trial.step);
    return trial.step > best_.step ? std::min(most, chosen) : std::max(most, chosen);
  }

  Sample start_, best_, other_;
  double step_;
  double most_;
  double low_ = 0.0;
  double high_;
  double bound_ = std::numeric_limits<double>::infinity();
  double width_;
  double width_before_;
  bool bracketed_ = false;
  bool first_stage_ = true;
};

/// Differences of places and gradients.
struct Difference {
  Vector place, gradient;
  double curvature;  ///< their product
};

class Minimizer {
 public:
  Minimizer(const LbfgsObjective& objective, Vector x, const LbfgsOptions& options,
            const std::function<bool(const Vector&)>& accepts)
      : objective_(objective), options_(options), accepts_(accepts), x_(std::move(x)) {}

  LbfgsResult run(const std::function<bool(const LbfgsState&)>& visit) {
    gradient_.resize(x_.size());
    value_ = evaluate(x_, gradient_);
    if (!std::isfinite(value_)) {
      throw Error("minimize: the value at the start is not finite; start elsewhere");
    }
    std::deque<double> values{value_};
    LbfgsEnd end = LbfgsEnd::kIterations;
    int iteration = 0;
    if (largest(gradient_) <= options_.gradient) end = LbfgsEnd::kConverged;
    while (end == LbfgsEnd::kIterations && iteration < options_.iterations &&
           evaluations_ < options_.evaluations) {
      double step = 0.0;
      bool decreased = iterate(step);
      if (!decreased && !memory_.empty()) {
        memory_.clear();
        decreased = iterate(step);
      }
      if (!decreased) {
        if (evaluations_ < options_.evaluations) end = LbfgsEnd::kLineSearch;
        break;
      }
      ++iteration;
      values.push_back(value_);
      if (static_cast<int>(values.size()) > options_.window + 1) values.pop_front();
      const bool enough = static_cast<int>(values.size()) == options_.window + 1;
      const bool little = values.front() - value_ <= options_.tolerance * std::abs(value_);
      const double slope = largest(gradient_);
      if (visit && !visit({iteration, evaluations_, value_, slope, step, &x_})) {
        end = LbfgsEnd::kStopped;
      } else if ((enough && little) || slope <= options_.gradient) {
        end = LbfgsEnd::kConverged;
      }
    }
    return {std::move(x_), value_, iteration, evaluations_, end};
  }

 private:
  double evaluate(const Vector& x, Vector& gradient) {
    ++evaluations_;
    return objective_(x, gradient);
  }

  /// Minus the inverse Hessian times the gradient.
  Vector direction() const {
    Vector d(gradient_.size());
    for (std::size_t i = 0; i < d.size(); ++i) d[i] = -gradient_[i];
    std::vector<double> factors(memory_.size());
    for (std::size_t m = memory_.size(); m-- > 0;) {
      const Difference& pair = memory_[m];
      factors[m] = dot(pair.place, d) / pair.curvature;
      for (std::size_t i = 0; i < d.size(); ++i) d[i] -= factors[m] * pair.gradient[i];
    }
    if (!memory_.empty()) {
      const Difference& last = memory_.back();
      const double scale = last.curvature / dot(last.gradient, last.gradient);
      for (double& x : d) x *= scale;
    }
    for (std::size_t m = 0; m < memory_.size(); ++m) {
      const Difference& pair = memory_[m];
      const double factor = factors[m] - dot(pair.gradient, d) / pair.curvature;
      for (std::size_t i = 0; i < d.size(); ++i) d[i] += factor * pair.place[i];
    }
    return d;
  }

  double first_step(const Vector& d) const {
    if (!memory_.empty()) return 1.0;
    if (options_.first_step > 0.0) return options_.first_step / largest(d);
    return std::min(1 / std::sqrt(dot(d, d)), kMostStep);
  }

  /// One iteration; whether the value decreased.
  bool iterate(double& step) {
    const Vector d = direction();
    const double slope = dot(gradient_, d);
    if (!(slope < 0.0)) return false;
    const double first = first_step(d);
    // A step whose length is told is as long in any unit of x.
    const bool told = memory_.empty() && options_.first_step > 0.0;
    MoreThuente search(value_, slope, first, told ? kMostStep * first : kMostStep);
    Vector x(x_.size());
    Vector gradient(x_.size());
    const double start = value_;
    // The best of the steps with a sufficient decrease, for when none has a small slope.
    Sample best{0.0, start, slope};
    Vector best_gradient;
    auto next = MoreThuente::Next::kTry;
    for (int tries = 0; next == MoreThuente::Next::kTry; ++tries) {
      if (tries == kMostTries || evaluations_ == options_.evaluations) break;
      move(d, search.step(), x);
      const double value = evaluate(x, gradient);
      const double along = std::isfinite(value) ? dot(gradient, d) : value;
      if (!std::isfinite(value) || !std::isfinite(along)) {
        next = search.refuse();
        continue;
      }
      const double tried = search.step();
      next = search.take(value, along);
      const bool allowed = next != MoreThuente::Next::kConverged || !accepts_ || accepts_(x);
      if (next == MoreThuente::Next::kConverged && allowed) {
        step = tried;
        update(x, gradient, value);
        return true;
      }
      if (!allowed) {
        next = search.refuse();
      } else if (value < best.value && value <= start + kDecrease * tried * slope) {
        best = {tried, value, along};
        best_gradient = gradient;
      }
    }
    if (best.step == 0.0) return false;
    move(d, best.step, x);
    if (accepts_ && !accepts_(x)) return false;
    step = best.step;
    update(x, best_gradient, best.value);
    return true;
  }

  void move(const Vector& d, double step, Vector& x) const {
    for (std::size_t i = 0; i < x.size(); ++i) x[i] = x_[i] + step * d[i];
  }

  void update(const Vector& x, const Vector& gradient, double value) {
    Difference pair{Vector(x.size()), Vector(x.size()), 0.0};
    for (std::size_t i = 0; i < x.size(); ++i) {
      pair.place[i] = x[i] - x_[i];
      pair.gradient[i] = gradient[i] - gradient_[i];
    }
    pair.curvature = dot(pair.place, pair.gradient);
    const double slope = -dot(gradient_, pair.place);
    if (pair.curvature > std::numeric_limits<double>::epsilon() * slope) {
      memory_.push_back(std::move(pair));
      if (static_cast<int>(memory_.size()) > options_.memory) memory_.pop_front();
    }
    x_ = x;
    gradient_ = gradient;
    value_ = value;
  }

  const LbfgsObjective& objective_;
  const LbfgsOptions& options_;
  const std::function<bool(const Vector&)>& accepts_;
  Vector x_, gradient_;
  double value_ = 0.0;
  int evaluations_ = 0;
  std::deque<Difference> memory_;
};

}  // namespace

LbfgsResult minimize(const LbfgsObjective& objective, std::vector<double> x,
                     const LbfgsOptions& options,
                     const std::function<bool(const LbfgsState&)>& visit,
                     const std::function<bool(const std::vector<double>& x)>& accepts) {
  return Minimizer(objective, std::move(x), options, accepts).run(visit);
}

}  // namespace hwffd
