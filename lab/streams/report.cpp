#include "report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

namespace hwffd::streams {
namespace {

nlohmann::ordered_json json_of(const std::vector<PagesRow>& pages) {
  auto list = nlohmann::ordered_json::array();
  for (const PagesRow& row : pages) {
    list.push_back({{"mesh", row.mesh},
                    {"vertices", row.vertices},
                    {"lattice", fmt::format("{0}x{0}x{0}", row.points)},
                    {"pages", row.pages},
                    {"batch", row.batch},
                    {"words_per_vertex", row.words_per_vertex()},
                    {"beats_predicted", row.predicted},
                    {"beats_counted", row.counted},
                    {"mismatches", row.mismatches}});
  }
  return list;
}

/// A line if results differ from what they should be, and one if other beats came than predicted.
std::string fault(const std::string& name, std::uint64_t mismatches, std::uint64_t predicted,
                  std::uint64_t counted) {
  std::string text;
  if (mismatches > 0) text += fmt::format("{}: {} results differ\n", name, mismatches);
  if (predicted != counted) {
    text += fmt::format("{}: {} beats predicted, {} counted\n", name, predicted, counted);
  }
  return text;
}

}  // namespace

std::string json_report(const std::vector<Row>& rows, const std::vector<PagesRow>& pages) {
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
  return Json{{"rows", std::move(list)}, {"pages", json_of(pages)}}.dump(2) + "\n";
}

std::string faults(const std::vector<Row>& rows, const std::vector<PagesRow>& pages) {
  std::string text;
  for (const Row& row : rows) {
    const std::string name = fmt::format("{}, {} points an axis, {}, order {}", row.mesh,
                                         row.points, row.arrangement, row.order);
    text += fault(name, row.mismatches, row.predicted, row.counted.value_or(row.predicted));
  }
  for (const PagesRow& row : pages) {
    text += fault(fmt::format("{}, {} points an axis, {} pages, batches of {}", row.mesh,
                              row.points, row.pages, row.batch),
                  row.mismatches, row.predicted, row.counted);
  }
  return text;
}

}  // namespace hwffd::streams
