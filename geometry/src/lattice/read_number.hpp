#pragma once

#include <charconv>
#include <cmath>
#include <string_view>
#include <type_traits>

namespace hwffd {

/// Reads all of text as one number, if floating then finite. Leaves value alone if it is not one.
template <typename T>
bool read_number(std::string_view text, T& value) {
  T read{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), read);
  if (error != std::errc() || end != text.data() + text.size()) return false;
  if constexpr (std::is_floating_point_v<T>) {
    if (!std::isfinite(read)) return false;
  }
  value = read;
  return true;
}

}  // namespace hwffd
