#include "hwffd/device/device.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "device/reference_device.hpp"
#include "device/scatter_device.hpp"
#include "device/serial_stream.hpp"
#include "device/spread_device.hpp"
#include "device/stream_device.hpp"
#include "device/uio_stream.hpp"
#include "hwffd/cores/scatter_core_factory.hpp"
#include "hwffd/cores/stream_core_factory.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"

namespace hwffd {
namespace {

const char* const kNoHardware =
    "device rtl: this library has no simulated hardware (hwffd_rtl) beside it; take device model, "
    "which has the same bits";

bool is_there(const std::string& kind, const Configuration& row) {
  if (!overlaps(row)) return false;
  return kind == "model" || kind == "serial" || kind == "uio" || kind == "socket" ||
         (kind == "rtl" && cores::has_stream_core(row));
}

void check(const Device::Blending& blending) {
  for (const Oracle::Coefficients& axis : blending) {
    if (!axis.allFinite()) throw Error("a coefficient of blending functions is not finite");
  }
}

/// @throws UsageError unless the kind is among these
void check_kind(const std::string& kind, const std::vector<std::string>& kinds) {
  if (std::find(kinds.begin(), kinds.end(), kind) != kinds.end()) return;
  throw UsageError(
      fmt::format("device '{}' is unknown; one of {}", excerpt(kind), fmt::join(kinds, ", ")));
}

/// All of them, a board's as "serial:PATH".
std::vector<std::string> every_kind() {
  std::vector<std::string> kinds = device_kinds();
  kinds.insert(kinds.end(), board_kinds().begin(), board_kinds().end());
  return kinds;
}

/// What follows the start of a board's name; none where a device is another.
std::optional<std::string> behind(const std::string& device, std::string_view start) {
  if (device.compare(0, start.size(), start) != 0) return {};
  return device.substr(start.size());
}

/// Whether a name begins as a board's: "serial:", "uio:" or "socket:".
bool names_board(const std::string& device) {
  return std::any_of(board_kinds().begin(), board_kinds().end(), [&](const std::string& kind) {
    return behind(device, kind.substr(0, kind.find(':') + 1)).has_value();
  });
}

/// @throws Error for gradients that are not of so many vertices, or not finite
void check_gradient(const Points& gradient, std::size_t vertices) {
  if (static_cast<std::size_t>(gradient.rows()) != vertices) {
    throw Error(fmt::format("gradient of {} positions for {} vertices; give a row for each",
                            gradient.rows(), vertices));
  }
  for (Eigen::Index row = 0; row < gradient.rows(); ++row) {
    if (!gradient.row(row).allFinite()) throw Error(fmt::format("gradient {} is not finite", row));
  }
}

std::string no_pull_back(const std::string& device) {
  return fmt::format(
      "{}: its core evaluates, and adds no gradients up; name device rtl, model or reference where "
      "they are pulled back",
      device);
}

/// @throws Error for a grid that the lattice has no places for
void check_grid(const Grid& grid, const Index3& dims) {
  if (grid_fits(grid, dims)) return;
  throw Error(fmt::format(
      "a grid of {} x {} x {} vertices is not within the {} x {} x {} cells of the "
      "lattice; give places from 0 to these numbers",
      grid.count[0], grid.count[1], grid.count[2], dims[0] - 3, dims[1] - 3, dims[2] - 3));
}

/// @throws Error for a vertex that a lattice of so many points an axis has no place for
void check(const Index3& dims, const std::vector<Embedded>& vertices) {
  Lattice::check_dims(dims);
  const Index3 cells{dims[0] - 3, dims[1] - 3, dims[2] - 3};
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!vertices[v].local.allFinite()) {
      throw Error(fmt::format("vertex {}: a local coordinate is not finite; embed it first", v));
    }
    check_cell(vertices[v].cell, cells, v);
  }
}

[[noreturn]] void throw_not_finite(std::size_t vertex, const std::string& device) {
  throw Error(
      fmt::format("vertex {}: the result is not finite; the control points are too large for "
                  "device {}: scale them, or take device reference",
                  vertex, device));
}

/// The first part of a row's name, "factored3" of factored3-fx18-overlapped.
std::string organization_in_name(const Configuration& row) {
  const std::string name = row.name;
  return name.substr(0, name.find('-'));
}

/// An organization as rows' names have it: tables write factored/3 and tree 8.
std::string as_in_names(std::string organization) {
  const auto mark = [](char c) { return c == '/' || c == ' '; };
  organization.erase(std::remove_if(organization.begin(), organization.end(), mark),
                     organization.end());
  return organization;
}

/// Names in short: of more than two one behind the other that differ only in what follows their
/// letters the first and the last, "tree1 to tree32".
std::vector<std::string> in_short(const std::vector<std::string>& names) {
  const auto letters = [](const std::string& name) {
    return name.substr(0, name.find_first_of("0123456789"));
  };
  std::vector<std::string> shortened;
  for (std::size_t first = 0; first < names.size();) {
    std::size_t end = first;
    while (end < names.size() && letters(names[end]) == letters(names[first])) ++end;
    if (end - first > 2) {
      shortened.push_back(fmt::format("{} to {}", names[first], names[end - 1]));
    } else {
      shortened.insert(shortened.end(), names.begin() + static_cast<std::ptrdiff_t>(first),
                       names.begin() + static_cast<std::ptrdiff_t>(end));
    }
    first = end;
  }
  return shortened;
}

/// The words, each once, in their order.
std::vector<std::string> distinct(const std::vector<std::string>& words) {
  std::vector<std::string> once;
  for (const std::string& word : words) {
    if (std::find(once.begin(), once.end(), word) == once.end()) once.push_back(word);
  }
  return once;
}

/// The name of the row that an organization and a format mean; a row's own name stays.
std::string name_of_row(const DeviceChoice& choice) {
  return fmt::format("{}-{}-overlapped", as_in_names(choice.org),
                     choice.format.empty() ? "fp32" : choice.format);
}

/// @throws UsageError for a row that could be simulated, but is not in this build
void refuse_not_built(const DeviceChoice& choice) {
  if (choice.device != "rtl") return;
  const std::string name = name_of_row(choice);
  for (const Configuration& row : configurations()) {
    if (!overlaps(row) || (row.name != name && row.name != choice.org)) continue;
    if (row.stream_tier == std::string("none")) continue;  // no build has it
    throw UsageError(fmt::format(
        "row {} is not among the simulated cores here: make hwffd TIER={} builds it, or take "
        "device model",
        row.name, row.stream_tier));
  }
}

[[noreturn]] void refuse(const DeviceChoice& choice) {
  refuse_not_built(choice);
  constexpr std::size_t kQuoted = 30;
  const std::string start = fmt::format("device {}: no", choice.device);
  const std::string org = excerpt(choice.org, kQuoted);
  const std::string gone = gone_text(choice.org);
  if (!gone.empty()) throw UsageError(fmt::format("device {}: {}", choice.device, gone));
  if (choice.org.find('-') != std::string::npos) {
    throw UsageError(fmt::format("{} row '{}' here; hwffd info lists them", start, org));
  }
  std::vector<std::string> organizations;
  std::vector<std::string> formats;
  for (const Configuration& row : configurations()) {
    if (!is_there(choice.device, row)) continue;
    organizations.push_back(organization_in_name(row));
    if (organizations.back() == as_in_names(choice.org)) formats.emplace_back(row.format);
  }
  if (formats.empty()) {
    throw UsageError(fmt::format("{} organization '{}' here; one of {}", start, org,
                                 fmt::join(in_short(distinct(organizations)), ", ")));
  }
  throw UsageError(fmt::format("{} '{}' in format '{}' here; it has {}", start, org,
                               excerpt(choice.format, kQuoted),
                               fmt::join(distinct(formats), ", ")));
}

/// The row of a model or of the RTL that is meant.
const Configuration& row_of(const DeviceChoice& choice) {
  const std::string name = name_of_row(choice);
  for (const Configuration& row : configurations()) {
    if (!is_there(choice.device, row)) continue;
    if (row.name == name) return row;
    if (row.name != choice.org) continue;
    if (choice.format.empty() || choice.format == row.format) return row;
    throw UsageError(fmt::format("row {} is in format {}, not '{}'; leave the format out", row.name,
                                 row.format, excerpt(choice.format)));
  }
  refuse(choice);
}

/// @throws UsageError where it is said what a board keeps
void refuse_store(const char* device, const DeviceChoice& choice) {
  if (choice.pages == 0 && choice.axis_points == kAxisPoints) return;
  throw UsageError(fmt::format(
      "device {}: its core has the pages and points an axis that it has; leave both out", device));
}

/// A core behind registers and DMA, which says which row it is.
/// @param reach  what `where` of that kind names
template <class Reach>
std::unique_ptr<Device> register_device(const std::string& kind, const std::string& where,
                                        const DeviceChoice& choice, const Reach& reach) {
  refuse_store(kind.c_str(), choice);
  const Configuration* wanted = nullptr;
  if (!choice.org.empty() || !choice.format.empty()) {
    DeviceChoice row_choice = choice;
    row_choice.device = kind;
    if (choice.org.empty()) row_choice.org = "basic";
    wanted = &row_of(row_choice);
  }
  const std::string name = kind + ":" + where;
  UioCore core = uio_core(name, reach(where), wanted);
  return std::make_unique<StreamDevice>(name, *core.row, std::move(core.stream));
}

std::unique_ptr<Device> uio_device(const std::string& number, const DeviceChoice& choice) {
  if (number.empty() || number.find_first_not_of("0123456789") != std::string::npos) {
    throw UsageError("device uio: needs the number of its file, such as uio:0 for /dev/uio0");
  }
  return register_device("uio", number, choice,
                         [](const std::string& where) { return uio_access(where); });
}

std::unique_ptr<Device> socket_device(const std::string& path, const DeviceChoice& choice) {
  if (path.empty()) {
    throw UsageError("device socket: needs the path of a socket, such as socket:/tmp/core");
  }
  return register_device("socket", path, choice, socket_access);
}

/// A board behind a serial line. Any row may be in its bitstream; what is not said is the ULX3S's.
std::unique_ptr<Device> serial_device(const std::string& path, const DeviceChoice& choice) {
  if (path.empty()) {
    throw UsageError("device serial: needs the path of its line, such as serial:/dev/ttyUSB0");
  }
  refuse_store("serial", choice);
  DeviceChoice row_choice = choice;
  row_choice.device = "serial";
  if (choice.org.empty()) {
    const std::string row = kSerialRow;
    row_choice.org = choice.format.empty() ? row : row.substr(0, row.find('-'));
  }
  const Configuration& row = row_of(row_choice);
  return std::make_unique<StreamDevice>("serial:" + path, row, serial_stream(path, row));
}

/// @throws UsageError for numbers that no core has, or none of this kind
PointStore store_of(const DeviceChoice& choice) {
  constexpr int kMostPages = 256, kFewestPoints = 7;
  if (choice.pages < 0 || choice.pages > kMostPages) {
    throw UsageError(fmt::format("{} pages: a core has 1 to {}, or 0 for one without pages",
                                 choice.pages, kMostPages));
  }
  const int most = choice.pages > 0 ? kLargeAxisPoints : kSmallAxisPoints;
  if (choice.axis_points < kFewestPoints || choice.axis_points > most) {
    throw UsageError(fmt::format("{} points an axis: a core {} keeps {} to {}", choice.axis_points,
                                 choice.pages > 0 ? "with pages" : "without pages", kFewestPoints,
                                 most));
  }
  if (choice.device == "rtl" && (choice.pages != 0 || choice.axis_points != kAxisPoints)) {
    throw UsageError(fmt::format(
        "device rtl: its cores have no pages, and {} points an axis; leave both out, or take "
        "device model",
        kAxisPoints));
  }
  return {choice.axis_points, choice.pages, false};
}

/// Places of a lattice of a family in the one that devices evaluate for it.
std::vector<Embedded> there(const std::vector<Embedded>& places, const Lattice& lattice,
                            const Family& family, const Family::Evaluable& evaluable) {
  const Index3 cells = family.cells(lattice.dims());
  std::vector<Embedded> result;
  result.reserve(places.size());
  for (const Embedded& place : places) {
    check_cell(place.cell, cells, result.size());
    result.push_back(evaluable.at(place));
  }
  return result;
}

Device::Blending all_bspline() {
  const Oracle::Coefficients bspline = Oracle::uniform_bspline();
  return {bspline, bspline, bspline};
}

}  // namespace

std::vector<Embedded> places_of(const Grid& grid, const Index3& cells) {
  const Index3 dims = {cells[0] + 3, cells[1] + 3, cells[2] + 3};
  check_grid(grid, dims);
  std::vector<Embedded> places;
  places.reserve(vertex_count(grid));
  for_each_vertex(grid, [&](const std::array<std::uint32_t, 3>& number) {
    const GridPlace at = grid_place(grid, dims, number);
    places.push_back({at.cell, {at.local[0], at.local[1], at.local[2]}});
  });
  return places;
}

void check_cell(const Index3& cell, const Index3& cells, std::size_t vertex) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (cell[axis] >= 0 && cell[axis] < cells[axis]) continue;
    throw Error(
        fmt::format("vertex {}: cell ({}, {}, {}) of a lattice of {} x {} x {} cells; "
                    "embed it in this lattice",
                    vertex, cell[0], cell[1], cell[2], cells[0], cells[1], cells[2]));
  }
}

Points Device::evaluate(const Lattice& lattice, const std::vector<Embedded>& vertices,
                        const Blending& blending) {
  check(blending);
  check(lattice.dims(), vertices);
  count(vertices.size());
  if (vertices.empty()) return Points(0, 3);
  return finite(run(lattice, vertices, blending));
}

Points Device::evaluate(const Lattice& lattice, const std::vector<Embedded>& places,
                        const Family& family) {
  if (family.kind() == Family::Kind::kBspline) return evaluate(lattice, places, all_bspline());
  const Family::Evaluable evaluable = family.evaluable(lattice);
  return evaluate(evaluable.lattice, there(places, lattice, family, evaluable), evaluable.blending);
}

Device::Tangents Device::tangents(const Lattice& lattice, const std::vector<Embedded>& vertices,
                                  const Blending& blending) {
  check(blending);
  check(lattice.dims(), vertices);
  count(vertices.size());
  if (vertices.empty()) return {Points(0, 3), {}};
  Tangents tangents = run_tangents(lattice, vertices, blending);
  tangents.positions = finite(std::move(tangents.positions));
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!tangents.jacobians[v].allFinite()) throw_not_finite(v, name());
  }
  return tangents;
}

Device::Tangents Device::tangents(const Lattice& lattice, const std::vector<Embedded>& places,
                                  const Family& family) {
  if (family.kind() == Family::Kind::kBspline) return tangents(lattice, places, all_bspline());
  const Family::Evaluable evaluable = family.evaluable(lattice);
  return tangents(evaluable.lattice, there(places, lattice, family, evaluable), evaluable.blending);
}

Points Device::evaluate_grid(const Lattice& lattice, const Grid& grid, const Blending& blending) {
  check(blending);
  check_grid(grid, lattice.dims());
  count(vertex_count(grid));
  return finite(run_grid(lattice, grid, blending));
}

Points Device::evaluate_grid(const Lattice& lattice, const Grid& grid, const Family& family) {
  if (family.kind() == Family::Kind::kBspline) return evaluate_grid(lattice, grid, all_bspline());
  return evaluate(lattice, places_of(grid, family.cells(lattice.dims())), family);
}

Points Device::run_grid(const Lattice& lattice, const Grid& grid, const Blending& blending) {
  return run(lattice, places_of(grid, lattice.cells()), blending);
}

Points Device::evaluate(const std::vector<SupportedVertex>& vertices, const Blending& blending) {
  check(blending);
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (vertices[v].local.allFinite() && vertices[v].support.allFinite()) continue;
    throw Error(
        fmt::format("vertex {}: a coordinate or control point is not finite; leave it out", v));
  }
  count(vertices.size());
  if (vertices.empty()) return Points(0, 3);
  return finite(run(vertices, blending));
}

Points Device::pull_back(const Index3& dims, const std::vector<Embedded>& vertices,
                         const Points& gradient, const Blending& blending) {
  check(blending);
  check(dims, vertices);
  check_gradient(gradient, vertices.size());
  return counted(run_pull_back(dims, vertices, gradient, blending), vertices.size());
}

Points Device::counted(Points pulled, std::size_t vertices) {
  count(vertices);
  if (!pulled.allFinite()) {
    throw Error("a sum of gradients is beyond what double holds; scale them");
  }
  return pulled;
}

Points Device::pull_back(const Index3& dims, const std::vector<Embedded>& places,
                         const Points& gradient, const Family& family) {
  if (family.kind() == Family::Kind::kBspline) {
    return pull_back(dims, places, gradient, all_bspline());
  }
  family.check_dims(dims);
  const Eigen::Index points = static_cast<Eigen::Index>(dims[0]) * dims[1] * dims[2];
  const Lattice lattice(dims, Points::Zero(points, 3));
  const Family::Evaluable evaluable = family.evaluable(lattice);
  return family.pull_back(
      dims, pull_back(evaluable.lattice.dims(), there(places, lattice, family, evaluable), gradient,
                      evaluable.blending));
}

Points Device::pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                              const Blending& blending) {
  check(blending);
  Lattice::check_dims(dims);
  check_grid(grid, dims);
  check_gradient(gradient, vertex_count(grid));
  return counted(run_pull_back_grid(dims, grid, gradient, blending), vertex_count(grid));
}

Points Device::pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                              const Family& family) {
  if (family.kind() == Family::Kind::kBspline) {
    return pull_back_grid(dims, grid, gradient, all_bspline());
  }
  return pull_back(dims, places_of(grid, family.cells(dims)), gradient, family);
}

Points Device::run_pull_back(const Index3& /*dims*/, const std::vector<Embedded>& /*vertices*/,
                             const Points& /*gradient*/, const Blending& /*blending*/) {
  throw Error(no_pull_back(name()));
}

Points Device::run_pull_back_grid(const Index3& dims, const Grid& grid, const Points& gradient,
                                  const Blending& blending) {
  return run_pull_back(dims, places_of(grid, {dims[0] - 3, dims[1] - 3, dims[2] - 3}), gradient,
                       blending);
}

Points Device::finite(Points positions) const {
  for (Eigen::Index row = 0; row < positions.rows(); ++row) {
    if (!positions.row(row).allFinite()) throw_not_finite(static_cast<std::size_t>(row), name());
  }
  return positions;
}

void Device::count(std::size_t vertices) {
  const std::lock_guard<std::mutex> lock(counting_);
  counts_.vertices += vertices;
}

const std::vector<std::string>& device_kinds() {
  static const std::vector<std::string> kinds{"model", "rtl", "reference"};
  return kinds;
}

const std::vector<std::string>& board_kinds() {
  static const std::vector<std::string> kinds{"serial:PATH", "uio:N", "socket:PATH"};
  return kinds;
}

std::vector<std::string> device_rows(const std::string& kind) {
  check_kind(kind, every_kind());
  if (kind == "serial:PATH") return {kSerialRow};
  std::vector<std::string> names;
  for (const Configuration& row : configurations()) {
    if (is_there(kind, row)) names.emplace_back(row.name);
  }
  return names;
}

std::unique_ptr<Device> make_device(const DeviceChoice& asked) {
  if (const std::optional<std::string> path = behind(asked.device, "serial:")) {
    return serial_device(*path, asked);
  }
  if (const std::optional<std::string> number = behind(asked.device, "uio:")) {
    return uio_device(*number, asked);
  }
  if (const std::optional<std::string> path = behind(asked.device, "socket:")) {
    return socket_device(*path, asked);
  }
  check_kind(asked.device, every_kind());
  DeviceChoice choice = asked;
  if (choice.org.empty()) choice.org = "basic";
  if (choice.device == "reference") return reference_device();
  if (choice.device == "rtl" && device_rows("rtl").empty()) {
    throw UsageError(kNoHardware);
  }
  const Configuration& row = row_of(choice);
  const PointStore store = store_of(choice);
  if (choice.device == "rtl") {
    return std::make_unique<StreamDevice>(choice.device, row, rtl_stream(row));
  }
  return std::make_unique<SpreadDevice>(
      row,
      [&row, store] {
        return std::make_unique<StreamDevice>("model", row, model_stream(row, store));
      },
      choice.rows);
}

std::unique_ptr<Device> make_pull_back_device(const std::string& kind, bool rows) {
  if (names_board(kind)) throw Error(no_pull_back(kind));
  check_kind(kind, device_kinds());
  if (kind == "rtl") {
    if (!cores::has_scatter_core()) throw UsageError(kNoHardware);
    return scatter_device(rows);
  }
  DeviceChoice choice{kind, "affine", "fx17"};
  choice.rows = rows && kind == "model";
  return make_device(choice);
}

}  // namespace hwffd
