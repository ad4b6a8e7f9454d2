#pragma once

#include "hwffd/hwffd.h"
#include "hwffd/points.hpp"

namespace hwffd::c {

/// The most points that a call takes: their doubles have addresses.
constexpr std::size_t kMostPoints = static_cast<std::size_t>(1) << 56;

/// The points of a view.
/// @param name  of the argument, for messages
/// @throws UsageError for a view that is NULL, has no data, an unknown type or too many points
Points read_view(const hwffd_view* view, const char* name);

/// Throws UsageError unless the view has room for that many points, each in a place of its own.
void check_room(const hwffd_view* view, const char* name, std::size_t count);

/// Writes points, rounded to the type of the view.
/// @throws Error before anything is written, if a number is too large for a float; check_room()'s
///   UsageError
void write_view(const Points& points, const hwffd_view* view, const char* name);

}  // namespace hwffd::c
