#include "mesh/utf8.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace hwffd {
namespace {

bool is_utf8(std::string_view text) {
  try {
    static_cast<void>(nlohmann::json(text).dump());
  } catch (const nlohmann::json::type_error&) {
    return false;
  }
  return true;
}

}  // namespace

std::string utf8_of(std::string_view name) {
  std::string result(name);
  if (!is_utf8(name)) {
    result.clear();
    for (const char c : name) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x80) {
        result += c;
      } else {
        result += static_cast<char>(0xc0 | byte >> 6);
        result += static_cast<char>(0x80 | (byte & 0x3f));
      }
    }
  }
  std::replace_if(
      result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
  return result;
}

}  // namespace hwffd
