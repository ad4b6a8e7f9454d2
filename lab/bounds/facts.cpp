#include "facts.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "fixed_facts.hpp"

namespace hwffd::certified {

Facts find_facts(const Effort& effort) {
  Facts facts;
  find_fixed_facts(effort, facts);
  find_float_facts(effort, facts);
  return facts;
}

std::string json_facts(const Facts& facts) {
  using nlohmann::ordered_json;
  ordered_json weights = ordered_json::array();
  for (const WeightsFact& f : facts.weights) {
    weights.push_back({{"weights", f.weights},
                       {"format", f.format},
                       {"weight", f.weight},
                       {"word", f.word},
                       {"error", f.error},
                       {"distance", f.distance},
                       {"reached", f.reached},
                       {"pair", f.pair},
                       {"bend", f.bend},
                       {"coordinates", f.coordinates},
                       {"all", f.all}});
  }
  ordered_json forms = ordered_json::array();
  for (const FormFact& f : facts.forms) {
    const Witness& w = f.witness;
    std::vector<std::uint32_t> points;
    for (int p = 0; p < 64; ++p) points.push_back(w.vertex.points[3 * p + w.component]);
    forms.push_back({{"form", f.form},
                     {"format", f.format},
                     {"error", w.error},
                     {"result", w.result},
                     {"local", w.vertex.local},
                     {"cell", w.vertex.cell},
                     {"points", points}});
  }
  return ordered_json{{"weights", weights}, {"forms", forms}}.dump(1) + "\n";
}

}  // namespace hwffd::certified
