#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace hwffd {

/// Reads text that is one JSON object and nothing after it.
/// @throws Error with line and column, from 1 and in bytes, of what is no JSON or a number beyond
///   double precision; for a name that the object has twice, and for another value than an object
nlohmann::json parse_object(const std::string& text);

}  // namespace hwffd
