#include "enumeration.hpp"
#include "fixed_facts.hpp"
#include "float_climb.hpp"
#include "hwffd/model/org_cg.hpp"
#include "hwffd/model/org_tree.hpp"

namespace hwffd::certified {
namespace {

template <class F>
class FloatFacts {
 public:
  FloatFacts(std::string name, const Effort& effort, Facts& facts)
      : name_(std::move(name)), effort_(effort), facts_(facts), horner_("bspline", "fp32") {}

  void run() {
    if (!effort_.format.empty() && effort_.format != name_) return;
    for (const std::string& family : family_names()) {
      const bool bspline = family == "bspline";
      if (!bspline && !effort_.form.empty() && effort_.form != "weights") continue;
      weights(family, bspline && effort_.all ? 1 : 1021);
    }
    if (effort_.form.empty() || effort_.form == "sequence") product<model::OrgCg>("sequence", 1);
    if (effort_.form.empty() || effort_.form == "tree") product<model::OrgTree>("tree", 64);
  }

 private:
  void weights(const std::string& family, std::int64_t stride) {
    const AxisFacts facts = axis_facts<F>(Horner<F>(family, "fp32"), stride, {kNone},
                                          [](const AxisPoint& /*point*/) {});
    WeightsFact fact{family, name_};
    fact.weight = facts.weight;
    fact.word = facts.word;
    fact.error = facts.error;
    fact.bend = Coordinates<F>::kBend;
    fact.coordinates = facts.coordinates;
    fact.all = stride == 1;
    facts_.weights.push_back(fact);
  }

  /// Random coordinates, the best of which is then moved.
  template <template <class> class Organization>
  void product(const std::string& form, int n) {
    Configuration row{};
    row.n = n;
    model::EvaluatorModelOf<F, Organization> core(row);
    const WordCodec codec("fp32");
    const AxisWords axis = encode(watertight_bspline(codec), codec);
    for (int a = 0; a < 3; ++a) {
      for (int l = 0; l < 4; ++l) core.load(0, a, l, axis.degree, axis.shift, axis.word[l]);
    }
    std::seed_seq seed(form.begin(), form.end());
    std::mt19937_64 engine(seed);
    model::VertexWords best;
    double most = 0;
    const std::int64_t trials = effort_.starts * 64;
    for (std::int64_t trial = 0; trial < trials; ++trial) {
      model::VertexWords vertex;
      for (int a = 0; a < 3; ++a) {
        const double random = static_cast<double>(engine() >> 11) * 0x1p-53;
        const bool near = trial > trials / 2;
        const double x =
            near ? codec.decode_coordinate(best.local[a]) + (random - 0.5) / 64 : random;
        vertex.local[a] = codec.coordinate(std::clamp(x, 0.0, 1.0));
        vertex.cell[a] = near ? best.cell[a] : static_cast<int>(engine() % 4);
      }
      const double error = float_points<F>(horner_.bank(), horner_, vertex, n == 64, engine).error;
      if (error > most) {
        most = error;
        best = vertex;
      }
    }
    Four exact[3];
    for (int a = 0; a < 3; ++a) exact[a] = horner_.exact(float_of_bits(best.local[a]));
    Climb<F, Organization> climb(core, "fp32", exact, best);
    climb.run(static_cast<int>(effort_.steps / 10), engine);
    facts_.forms.push_back({form, name_, climb.best()});
  }

  std::string name_;
  const Effort& effort_;
  Facts& facts_;
  Horner<F> horner_;
};

}  // namespace

void find_float_facts(const Effort& effort, Facts& facts) {
  FloatFacts<Binary32>("fp32", effort, facts).run();
  FloatFacts<Binary32Fused>("fp32-fused", effort, facts).run();
}

}  // namespace hwffd::certified
