#include "c_views.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <cstring>
#include <limits>

#include "c_guard.hpp"
#include "hwffd/lattice/coordinates.hpp"

namespace hwffd::c {
namespace {

template <typename Real>
Points read_as(const hwffd_view& view) {
  const auto count = static_cast<Eigen::Index>(view.count);
  Points points(count, 3);
  const auto* bytes = static_cast<const char*>(view.data);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      Real number;
      std::memcpy(&number, bytes + i * view.point_bytes + c * view.coordinate_bytes, sizeof number);
      points(i, c) = static_cast<double>(number);
    }
  }
  return points;
}

template <typename Real>
void write_as(const Points& points, const hwffd_view& view) {
  auto* bytes = static_cast<char*>(view.data);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    for (Eigen::Index c = 0; c < 3; ++c) {
      const auto number = static_cast<Real>(points(i, c));
      std::memcpy(bytes + i * view.point_bytes + c * view.coordinate_bytes, &number, sizeof number);
    }
  }
}

void check(const hwffd_view* view, const char* name) {
  need(view, name);
  if (view->type != HWFFD_FLOAT32 && view->type != HWFFD_FLOAT64) {
    throw UsageError(fmt::format("{}: type {} is unknown; give HWFFD_FLOAT32 or HWFFD_FLOAT64",
                                 name, view->type));
  }
  if (view->count > kMostPoints) {
    throw UsageError(fmt::format("{}: {} points; give at most {}", name, view->count, kMostPoints));
  }
  need(static_cast<const char*>(view->data), fmt::format("{}: data", name).c_str(), view->count);
}

/// Whether a coordinate of a point lies on another one of another point, where points and
/// coordinates are at least `size` bytes apart.
bool points_meet(const hwffd_view& view, std::ptrdiff_t size) {
  constexpr std::ptrdiff_t kFarthest = std::numeric_limits<std::ptrdiff_t>::max() / 4;
  if (std::abs(view.coordinate_bytes) > kFarthest) return false;
  const auto points = static_cast<std::ptrdiff_t>(view.count);
  for (const std::ptrdiff_t bytes : {view.coordinate_bytes, 2 * view.coordinate_bytes}) {
    // Of the two points that are the nearest.
    const std::ptrdiff_t steps = bytes / view.point_bytes;
    const std::ptrdiff_t rest = bytes % view.point_bytes;
    const std::ptrdiff_t more = (rest < 0) == (view.point_bytes < 0) ? 1 : -1;
    if (std::abs(steps) < points && std::abs(rest) < size) return true;
    if (std::abs(steps + more) < points && std::abs(rest - more * view.point_bytes) < size) {
      return true;
    }
  }
  return false;
}

}  // namespace

Points read_view(const hwffd_view* view, const char* name) {
  check(view, name);
  return view->type == HWFFD_FLOAT32 ? read_as<float>(*view) : read_as<double>(*view);
}

void check_room(const hwffd_view* view, const char* name, std::size_t count) {
  check(view, name);
  if (view->count != count) {
    throw UsageError(fmt::format("{}: {} points; give room for {}", name, view->count, count));
  }
  const auto size =
      static_cast<std::ptrdiff_t>(view->type == HWFFD_FLOAT32 ? sizeof(float) : sizeof(double));
  const auto apart = [&](std::ptrdiff_t bytes) { return bytes >= size || bytes <= -size; };
  if (count > 0 && (!apart(view->coordinate_bytes) || (count > 1 && !apart(view->point_bytes)))) {
    throw UsageError(
        fmt::format("{}: numbers {} and {} bytes apart lie on each other; give at least {}", name,
                    view->point_bytes, view->coordinate_bytes, size));
  }
  if (count > 1 && points_meet(*view, size)) {
    throw UsageError(fmt::format(
        "{}: points {} bytes apart with coordinates {} bytes apart lie on each other; give each "
        "number a place of its own",
        name, view->point_bytes, view->coordinate_bytes));
  }
}

void write_view(const Points& points, const hwffd_view* view, const char* name) {
  check_room(view, name, static_cast<std::size_t>(points.rows()));
  if (view->type == HWFFD_FLOAT64) {
    write_as<double>(points, *view);
  } else {
    if (const auto row = beyond_float(points)) {
      throw Error(
          fmt::format("{}: point {} is beyond what float holds; give HWFFD_FLOAT64", name, *row));
    }
    write_as<float>(points, *view);
  }
}

}  // namespace hwffd::c

extern "C" {

hwffd_view hwffd_packed(int type, const void* data, size_t count) {
  return hwffd_packed_out(type, const_cast<void*>(data), count);
}

hwffd_view hwffd_packed_out(int type, void* data, size_t count) {
  const auto size = static_cast<ptrdiff_t>(type == HWFFD_FLOAT32 ? sizeof(float) : sizeof(double));
  return {data, count, type, 3 * size, size};
}

}  // extern "C"
