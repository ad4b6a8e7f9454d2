#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

namespace hwffd::streams {

std::string table(const std::vector<Row>& rows) {
  std::set<int> lattices;
  for (const Row& row : rows) lattices.insert(row.points);
  std::string text = fmt::format("{:<14} {:>8} {:<15} {:<6} {:<10}", "mesh", "vertices",
                                 "arrangement", "order", "RTL");
  for (const int points : lattices)
    text += fmt::format(" {:>9}", fmt::format("{0}x{0}x{0}", points));
  for (const Row& first : rows) {
    if (first.points != *lattices.begin()) continue;
    text += fmt::format("\n{:<14} {:>8} {:<15} {:<6} {:<10}", first.mesh, first.vertices,
                        first.arrangement, first.order, first.counted ? "equal" : "not built");
    for (const Row& row : rows) {
      const bool same = row.mesh == first.mesh && row.arrangement == first.arrangement &&
                        row.order == first.order;
      if (same) text += fmt::format(" {:>9.2f}", row.words_per_vertex());
    }
  }
  return text + "\n";
}

std::string json_report(const std::vector<Row>& rows) {
  using Json = nlohmann::ordered_json;
  Json list = Json::array();
  for (const Row& row : rows) {
    list.push_back({{"mesh", row.mesh},
                    {"vertices", row.vertices},
                    {"lattice", fmt::format("{0}x{0}x{0}", row.points)},
                    {"arrangement", row.arrangement},
                    {"order", row.order},
                    {"words_per_vertex", row.words_per_vertex()},
                    {"beats_predicted", row.predicted},
                    {"beats_counted", row.counted ? Json(*row.counted) : Json()},
                    {"mismatches", row.mismatches}});
  }
  return Json{{"rows", std::move(list)}}.dump(2) + "\n";
}

std::string faults(const std::vector<Row>& rows) {
  std::string text;
  for (const Row& row : rows) {
    const std::string name = fmt::format("{}, {} points an axis, {}, order {}", row.mesh,
                                         row.points, row.arrangement, row.order);
    if (row.mismatches > 0)
      text += fmt::format("{}: {} results differ from the model\n", name, row.mismatches);
    if (row.counted && *row.counted != row.predicted) {
      text +=
          fmt::format("{}: {} beats predicted, {} counted\n", name, row.predicted, *row.counted);
    }
  }
  return text;
}

}  // namespace hwffd::streams
