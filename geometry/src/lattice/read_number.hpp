#pragma once

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <string_view>
#include <type_traits>

namespace hwffd {

/// Reads all of text as one number; whether it is one.
template <typename T>
bool read_all(std::string_view text, T& read) {
#ifndef __cpp_lib_to_chars
  if constexpr (std::is_floating_point_v<T>) {  // which from_chars does not read everywhere
    const bool plain = text.find_first_not_of("0123456789.eE+-") == std::string_view::npos;
    if (!plain || text.empty() || text.front() == '+') return false;
    const std::string copy(text);
    char* end = nullptr;
    read = static_cast<T>(std::strtod(copy.c_str(), &end));
    return end == copy.c_str() + copy.size();
  } else
#endif
  {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
    return error == std::errc() && end == text.data() + text.size();
  }
}

/// Reads all of text as one number, if floating then finite. Leaves value alone if it is not one.
template <typename T>
bool read_number(std::string_view text, T& value) {
  T read{};
  if (!read_all(text, read)) return false;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(read)) return false;
  }
  value = read;
  return true;
}

}  // namespace hwffd
