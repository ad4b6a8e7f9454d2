#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "geometry.hpp"
#include "hwffd/device/device.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/closure.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/lattice_file.hpp"
#include "hwffd/mesh/extension.hpp"
#include "hwffd/version.h"
#include "outputs.hpp"
#include "report.hpp"

namespace hwffd::command {
namespace {

constexpr const char* kInfoExamples = R"(Examples:
  hwffd info               (devices, organizations and formats of this build)
  hwffd info horse.3ds
  hwffd info rest.json)";

struct InfoOptions {
  std::string file;
  std::string report;
};

Json extent(const Points& points) {
  const Point low = points.colwise().minCoeff();
  const Point high = points.colwise().maxCoeff();
  return {{"low", {low[0], low[1], low[2]}}, {"high", {high[0], high[1], high[2]}}};
}

Json build_info() {
  Json devices = Json::object();
  for (const std::vector<std::string>& kinds : {device_kinds(), board_kinds()}) {
    for (const std::string& kind : kinds) devices[kind] = device_rows(kind);
  }
  return {{"version", HWFFD_VERSION}, {"devices", std::move(devices)}};
}

Json lattice_info(const std::string& file) {
  const LatticeFile read = read_lattice_file(file, std::nullopt);
  const Lattice& lattice = read.lattice;
  const Closure closure(lattice, *read.family);
  Json closed = Json::array();
  for (int axis = 0; axis < 3; ++axis) {
    if (closure.closed(axis)) closed.push_back(std::string(1, "stu"[axis]));
  }
  Json info{{"lattice", file},
            {"dims", lattice.dims()},
            {"family", read.family->name()},
            {"cells", read.family->cells(whole_dims(lattice.dims(), *read.family))},
            {"closed_axes", std::move(closed)},
            {"collapsed_faces", closure.collapsed().size()}};
  info.update(extent(lattice.points()));
  return info;
}

Json geometry_info(const std::string& name) {
  const Geometry geometry = Geometry::read(name);
  Json info{{geometry.is_mesh() ? "mesh" : "points", geometry.name()},
            {"vertices", geometry.positions().rows()}};
  if (geometry.is_mesh()) {
    const Mesh& mesh = geometry.mesh();
    info["vertices_before_welding"] = mesh.vertex_count_read();
    info["triangles"] = mesh.triangles().size();
    if (!mesh.dropped().empty()) info["dropped"] = mesh.dropped();
  }
  info.update(extent(geometry.positions()));
  return info;
}

/// "name  value" a line, names as in the JSON.
std::string text_of(const Json& info) {
  std::string text;
  for (const auto& [name, value] : info.items()) {
    if (value.is_object()) {
      for (const auto& [device, rows] : value.items()) {
        text +=
            fmt::format("{:<24} {}\n", fmt::format("{}.{}", name, device), rows.empty() ? "-" : "");
        for (const Json& row : rows) text += fmt::format("  {}\n", row.get<std::string>());
      }
    } else {
      text += fmt::format("{:<24} {}\n", name,
                          one_line(value.is_string() ? value.get<std::string>() : value.dump()));
    }
  }
  return text;
}

int run(const InfoOptions& options) {
  check_outputs({{"--json", options.report}}, {options.file});
  const bool lattice = extension_of(options.file) == ".json";
  const Json info = options.file.empty() ? build_info()
                    : lattice            ? lattice_info(options.file)
                                         : geometry_info(options.file);
  if (!options.report.empty()) write_report(options.report, info);
  if (options.report != "-") fmt::print("{}", text_of(info));
  return 0;
}

}  // namespace

Action add_info(CLI::App& app) {
  const auto options = std::make_shared<InfoOptions>();
  app.add_option("file", options->file, "mesh, lattice file (.json), or points (.xyz, -)");
  app.add_option("--json", options->report, "report to write; - for standard output");
  app.footer(kInfoExamples);
  return [=] { return run(*options); };
}

}  // namespace hwffd::command
