#include "fixed_facts.hpp"

#include "boxes.hpp"
#include "coordinates.hpp"
#include "enumeration.hpp"
#include "hwffd/model/org_affine.hpp"
#include "hwffd/model/org_cg.hpp"
#include "pairs.hpp"
#include "scatter_climb.hpp"

namespace hwffd::certified {
namespace {

constexpr double kTolerance = 0.02;  // of branch and bound

std::mt19937_64 seeded(const std::string& text) {
  std::seed_seq seed(text.begin(), text.end());
  return std::mt19937_64(seed);
}

template <class F>
int width_of() {
  if constexpr (std::is_same_v<F, Block32>) {
    return Block32::kWidth;
  } else {
    return F::kWeightFraction + 2;
  }
}

template <class F, class Weights>
Candidate candidate_of(const Weights& weights, std::uint32_t word, int left) {
  // Bank 3, which is left over, has function `left` in this cell.
  const int cell = left == kNone ? 0 : 3 - left;
  Candidate candidate{variant(axis_point<F>(weights, word), left, Weights::kSum), cell, {}};
  for (int l = 0; l < 4; ++l) {
    candidate.units[l] = std::llround(candidate.point.weight[l] / Coordinates<F>::kUnit);
  }
  return candidate;
}

/// Coordinates to try: all where they are few; else those of large errors, some around fractions
/// whose weights have many zeros, and random ones.
template <class F, class Weights>
std::vector<Candidate> candidates(const Weights& weights, const std::vector<AxisPoint>& extreme,
                                  int left, std::mt19937_64& engine) {
  using C = Coordinates<F>;
  std::vector<Candidate> result;
  const auto add = [&](std::uint32_t word) {
    result.push_back(candidate_of<F>(weights, word, left));
  };
  const auto both_ends = [&](std::int64_t k) {
    for (int end = 0; end < C::kEnds; ++end) add(C::word(k, end));
  };
  if (C::kLast - C::kFirst < 1 << 17) {
    for (std::int64_t k = C::kFirst; k <= C::kLast; ++k) both_ends(k);
    return result;
  }
  for (const AxisPoint& point : extreme) add(point.word);
  const WordCodec codec(C::kEnds == 2 ? "fx32" : "fp32");
  for (int part = 1; part < 64; ++part) {
    for (int off = -64; off <= 64; ++off) {
      add(codec.coordinate(part / 64.0 + std::ldexp(off, C::kEnds == 2 ? -30 : -24)));
    }
  }
  for (int i = 0; i < 20000; ++i) {
    const double x = static_cast<double>(engine() >> 11) * 0x1p-53;
    add(codec.coordinate(x));
  }
  return result;
}

/// A family's functions in the bank of a core, on all axes.
void load(model::EvaluatorModel& core, const std::string& format) {
  const WordCodec codec(format);
  const AxisWords axis = encode(watertight_bspline(codec), codec);
  for (int a = 0; a < 3; ++a) {
    for (int l = 0; l < 4; ++l) core.load(0, a, l, axis.degree, axis.shift, axis.word[l]);
  }
}

/// Turns points until the result is above 1/2, where its own rounding is largest: first those that
/// cost the least of the weights' error, which are those of large weights.
void keep_large(const Four (&exact)[3], model::VertexWords& vertex) {
  std::array<std::pair<double, int>, 64> order;
  for (int p = 0; p < 64; ++p) {
    order[p] = {exact[0][p >> 4] * exact[1][p >> 2 & 3] * exact[2][p & 3], p};
  }
  std::sort(order.rbegin(), order.rend());
  for (int c = 0; c < 3; ++c) {
    const std::uint32_t sign = c == 1 ? 0x80000000 : 0;
    double sum = 0;
    for (const auto& [weight, p] : order) {
      sum += (vertex.points[3 * p + c] & 0x80000000) == sign ? weight : -weight;
    }
    for (const auto& [weight, p] : order) {
      std::uint32_t& word = vertex.points[3 * p + c];
      if (sum > 0.51) break;
      if ((word & 0x80000000) == sign) continue;
      word ^= 0x80000000;
      sum += 2 * weight;
    }
  }
}

/// From coordinates to a vertex: points as large as they may be, each with the sign of the error
/// of its weight; the second component has the opposite ones.
template <class F, template <class> class Organization, class Weight>
Witness climb(const std::string& format, const Triple& triple, const Weight& weight_of,
              std::int64_t steps, std::mt19937_64& engine) {
  model::EvaluatorModelOf<F, Organization> core{Configuration{}};
  load(core, format);
  model::VertexWords vertex;
  Four exact[3];
  for (int axis = 0; axis < 3; ++axis) {
    vertex.local[axis] = triple[axis].point.word;
    vertex.cell[axis] = triple[axis].cell;
    exact[axis] = triple[axis].point.exact;
  }
  for (int p = 0; p < 64; ++p) {
    const int l = p >> 4;
    const int m = p >> 2 & 3;
    const int n = p & 3;
    const double error = weight_of(triple, l, m, n) - exact[0][l] * exact[1][m] * exact[2][n];
    for (int c = 0; c < 3; ++c) {
      const double sign = (c == 1) == (error > 0) ? -1 : 1;
      vertex.points[3 * p + c] = PointsOf<F>::top(sign, width_of<F>());
    }
  }
  if constexpr (std::is_same_v<F, Block32>) keep_large(exact, vertex);
  Climb<F, Organization> climbing(core, format, exact, vertex);
  climbing.run(static_cast<int>(steps), engine);
  return climbing.best();
}

template <class F>
class FixedFacts {
 public:
  using C = Coordinates<F>;
  static constexpr bool kFew = Coordinates<F>::kLast - Coordinates<F>::kFirst < 1 << 17;
  using Wide = std::conditional_t<(F::kWeightFraction > 30), Int128, std::int64_t>;

  FixedFacts(std::string name, const Effort& effort, Facts& facts)
      : name_(std::move(name)), effort_(effort), facts_(facts), horner_("bspline", name_) {}

  void run() {
    if (!wanted("format", name_)) return;
    if constexpr (F::kWeightFraction + 2 < kLeastComposed) {
      if (!wanted("form", "scatter")) return;
      axis("affine", horner_, kAnyLeft);
      scatter_affine();
      axis("powers", Powers<F>(), {kNone});
      scatter_powers();
    } else {
      run_composed();
    }
  }

 private:
  /// Forms but scatter are of rows from here on; narrower words have scatter alone.
  static constexpr int kLeastComposed = 16;
  /// Of `affine`, in cells of all kinds.
  static inline const std::vector<int> kAnyLeft{0, 1, 2, 3};

  void run_composed() {
    const bool contracts = wanted("form", "factored");
    if (contracts || wanted("form", "product")) {
      axis("bspline", horner_, {kNone});
      if (contracts) add<model::OrgFactored>("factored");
      if (wanted("form", "product")) {
        if (kFew) facts_.weights.back().pair = largest_pair(candidates_, F::kWeightFraction);
        product();
      }
    }
    if constexpr (!std::is_same_v<F, Block32>) {
      constexpr bool kScatters = F::kWeightFraction + 2 <= model::kScatterMostWidth;
      const bool scatters = kScatters && wanted("form", "scatter");
      if (wanted("form", "affine") || scatters) {
        axis("affine", horner_, kAnyLeft);
        if (wanted("form", "affine")) add<model::OrgAffine>("affine");
        if constexpr (kScatters) {
          if (scatters) scatter_affine();
        }
      }
      const bool powers = wanted("form", "powers") && name_ != "fx16";
      if (powers || scatters) {
        axis("powers", Powers<F>(), {kNone});
        if (powers) add<model::OrgPowers>("powers");
        if constexpr (kScatters) {
          if (scatters) scatter_powers();
        }
      }
    }
    families();
  }

  bool wanted(const char* what, const std::string& name) const {
    const std::string& only = what == std::string("form") ? effort_.form : effort_.format;
    return only.empty() || only == name;
  }

  std::int64_t stride() const { return effort_.all || kFew ? 1 : 4099; }

  /// Every coordinate, all triples of them, and which of them to try.
  template <class Weights>
  void axis(const std::string& what, const Weights& weights, const std::vector<int>& lefts) {
    Looked looked = look(what, weights, lefts, stride() == 1 && !std::is_same_v<F, Block32>);
    candidates_ = std::move(looked.candidates);
    if (!looked.boxes.empty()) {
      put(looked.fact, bound_triples(std::move(looked.boxes), kTolerance));
    }
    facts_.weights.push_back(looked.fact);
  }

  /// What is found of the weights of an axis by itself.
  struct Looked {
    WeightsFact fact;
    std::vector<ErrorBox> boxes;  ///< of all coordinates, where they are wanted
    std::vector<Candidate> candidates;
  };

  template <class Weights>
  Looked look(const std::string& what, const Weights& weights, const std::vector<int>& lefts,
              bool boxed) const {
    Boxes<F> boxes(boxed);
    const AxisFacts facts = axis_facts<F>(weights, stride(), lefts,
                                          [&](const AxisPoint& point) { boxes.visit(point); });
    Looked looked{fact_of(what, facts), boxes.take(), {}};
    looked.fact.all = stride() == 1;
    auto engine = seeded(name_ + what);
    for (const int left : lefts) {
      for (const Candidate& candidate : candidates<F>(weights, facts.extreme, left, engine)) {
        looked.candidates.push_back(candidate);
      }
    }
    return looked;
  }

  static void put(WeightsFact& fact, const TripleBound& bound) {
    fact.distance = bound.bound;
    fact.reached = bound.reached;
  }

  WeightsFact fact_of(const std::string& what, const AxisFacts& facts) const {
    WeightsFact fact;
    fact.weights = what;
    fact.format = name_;
    fact.weight = facts.weight;
    fact.word = facts.word;
    fact.error = facts.error;
    fact.bend = C::kBend;
    fact.coordinates = facts.coordinates;
    return fact;
  }

  template <template <class> class Organization>
  void add(const std::string& form) {
    auto engine = seeded(name_ + form);
    const Triple triple = farthest(alike(candidates_), engine);
    const auto weight = [](const Triple& t, int l, int m, int n) {
      return t[0].point.weight[l] * t[1].point.weight[m] * t[2].point.weight[n];
    };
    const Witness witness = climb<F, Organization>(name_, triple, weight, effort_.steps, engine);
    facts_.forms.push_back({form, name_, witness});
  }

  /// The transpose of `affine`, of positions at the coordinates of the weights that were looked at
  /// last, and of derivatives.
  void scatter_affine() {
    scatter("scatter", false);
    const Slopes<F> slopes(name_);
    alone("slopes", slopes, stride());
    derivatives("scatter", "affine", horner_, slopes, kAnyLeft);
  }
  void scatter_powers() {
    scatter("scatter powers", true);
    derivatives("scatter powers", "powers", Powers<F>(), PowersSlopes<F>(), {kNone});
  }

  void scatter(const std::string& form, bool powers) {
    auto engine = seeded(name_ + form);
    const Choices choices = alike(candidates_);
    climb_scatter(form, ScatterClimb<F>(powers, -1), farthest(choices, engine), choices, engine);
  }

  /// Gradients of the derivative along each axis, whose weights are `slopes`.
  template <class Weights, class OfSlopes>
  void derivatives(const std::string& form, const std::string& what, const Weights& weights,
                   const OfSlopes& slopes, const std::vector<int>& lefts) {
    Looked looked = look(what + " slopes", slopes, lefts, stride() == 1);
    if (!looked.boxes.empty()) {
      put(looked.fact,
          bound_triples_with_slopes(std::move(looked.boxes), look(what, weights, lefts, true).boxes,
                                    kTolerance));
    }
    facts_.weights.push_back(looked.fact);
    auto engine = seeded(name_ + form + " slopes");
    const Triple triple = farthest({&looked.candidates, &candidates_, &candidates_}, engine);
    for (int axis = 0; axis < 3; ++axis) {
      // The products are the same whichever axis has the slopes.
      Triple start = triple;
      Choices choices = alike(candidates_);
      std::swap(start[0], start[static_cast<std::size_t>(axis)]);
      choices[static_cast<std::size_t>(axis)] = &looked.candidates;
      climb_scatter(form + " along " + "stu"[axis], ScatterClimb<F>(what == "powers", axis), start,
                    choices, engine);
    }
  }

  /// Where the products of three weights are off the most.
  Triple farthest(const Choices& choices, std::mt19937_64& engine) const {
    return best_triple(choices, {}, static_cast<int>(effort_.starts), engine,
                       [](const Triple& t) { return exact_distance(t[0], t[1], t[2]); });
  }

  void climb_scatter(const std::string& form, ScatterClimb<F> climbing, const Triple& start,
                     const Choices& choices, std::mt19937_64& engine) {
    facts_.forms.push_back({form, name_, climbing.run(start, choices, effort_.steps, engine)});
  }

  void product() {
    auto engine = seeded(name_ + "product");
    constexpr int kFraction = F::kWeightFraction;
    // Roundings, not weights, are most of it, so more starts are worth while.
    const Triple triple = best_triple(
        alike(candidates_), near_sixteenths(candidates_, C::kUnit),
        static_cast<int>(8 * effort_.starts), engine,
        [](const Triple& t) { return rounded_distance<Wide>(t[0], t[1], t[2], kFraction); });
    const Triple refined = kFew ? triple : over_random(triple, engine);
    const auto weight = [](const Triple& t, int l, int m, int n) {
      const std::int64_t pair = rounded_product<Wide>(t[0].units[l], t[1].units[m], kFraction);
      return static_cast<double>(rounded_product<Wide>(pair, t[2].units[n], kFraction)) * C::kUnit;
    };
    const Witness witness =
        climb<F, model::OrgCg>(name_, refined, weight, effort_.steps / 4, engine);
    facts_.forms.push_back({"product", name_, witness});
  }

  /// Each axis again, over random coordinates: in wide formats few of them were candidates.
  Triple over_random(Triple best, std::mt19937_64& engine) {
    constexpr int kFraction = F::kWeightFraction;
    const WordCodec codec(name_);
    double most = rounded_distance<Wide>(best[0], best[1], best[2], kFraction);
    for (std::int64_t i = 0; i < effort_.starts * 200'000; ++i) {
      Triple probe = best;
      Candidate& axis = probe[i % 3];
      const double x = static_cast<double>(engine() >> 11) * 0x1p-53;
      const double near = axis.point.x + (x - 0.5) * 1024 * C::kUnit;
      axis = candidate_of<F>(horner_, codec.coordinate(i % 2 == 0 ? x : std::clamp(near, 0.0, 1.0)),
                             kNone);
      const double reached = rounded_distance<Wide>(probe[0], probe[1], probe[2], kFraction);
      if (reached > most) {
        most = reached;
        best = probe;
      }
    }
    return best;
  }

  /// Weights alone, of the families whose functions are not those of the composed forms.
  void families() {
    if (!wanted("form", "weights")) return;
    for (const std::string& family : family_names()) {
      if (family == "bspline" && effort_.form.empty()) continue;  // has been looked at
      alone(family, Horner<F>(family, name_), kFew ? 1 : 1021);
    }
  }

  /// Weights of which no form is composed.
  template <class Weights>
  void alone(const std::string& what, const Weights& weights, std::int64_t step) {
    const AxisFacts facts =
        axis_facts<F>(weights, step, {kNone}, [](const AxisPoint& /*point*/) {});
    facts_.weights.push_back(fact_of(what, facts));
    facts_.weights.back().all = step == 1;
  }

  std::string name_;
  const Effort& effort_;
  Facts& facts_;
  Horner<F> horner_;
  std::vector<Candidate> candidates_;
};

}  // namespace

void find_fixed_facts(const Effort& effort, Facts& facts) {
  FixedFacts<Fixed<12>>("fx12", effort, facts).run();
  FixedFacts<Fixed<13>>("fx13", effort, facts).run();
  FixedFacts<Fixed<14>>("fx14", effort, facts).run();
  FixedFacts<Fixed<15>>("fx15", effort, facts).run();
  FixedFacts<Fixed<16>>("fx16", effort, facts).run();
  FixedFacts<Fixed<17>>("fx17", effort, facts).run();
  FixedFacts<Fixed<18>>("fx18", effort, facts).run();
  FixedFacts<Fixed<32>>("fx32", effort, facts).run();
  FixedFacts<Block32>("bfp32", effort, facts).run();
}

}  // namespace hwffd::certified
