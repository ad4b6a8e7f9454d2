#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hwffd::streams {
namespace {

/// Whether the RTL took as many beats as predicted, where it has the arrangement.
bool is_as_predicted(const Row& row) { return !row.counted || *row.counted == row.predicted; }

}  // namespace

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
