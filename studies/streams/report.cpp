#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

namespace hwffd::streams {
namespace {

/// Whether the RTL took as many beats as predicted, where it has the arrangement.
bool is_as_predicted(const Row& row) { return !row.counted || *row.counted == row.predicted; }

/// Whether rows differ in the lattice only.
bool share_a_line(const Row& a, const Row& b) {
  return a.mesh == b.mesh && a.arrangement == b.arrangement && a.order == b.order;
}

}  // namespace

std::string table(const std::vector<Row>& rows) {
  std::set<int> lattices;
  for (const Row& row : rows) lattices.insert(row.points);
  std::string text = fmt::format("{:<14} {:>8} {:<15} {:<6} {:<10}", "mesh", "vertices",
                                 "arrangement", "order", "RTL");
  for (const int points : lattices)
    text += fmt::format(" {:>9}", fmt::format("{0}x{0}x{0}", points));
  for (const Row& first : rows) {
    if (first.points != *lattices.begin()) continue;
    bool equal = true;
    std::string words;
    for (const Row& row : rows) {
      if (!share_a_line(row, first)) continue;
      equal = equal && is_as_predicted(row);
      words += fmt::format(" {:>9.2f}", row.words_per_vertex());
    }
    text += fmt::format("\n{:<14} {:>8} {:<15} {:<6} {:<10}", first.mesh, first.vertices,
                        first.arrangement, first.order,
                        !first.counted ? "not built"
                        : equal        ? "equal"
                                       : "NOT EQUAL") +
            words;
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
    if (!is_as_predicted(row)) {
      text +=
          fmt::format("{}: {} beats predicted, {} counted\n", name, row.predicted, *row.counted);
    }
  }
  return text;
}

}  // namespace hwffd::streams
