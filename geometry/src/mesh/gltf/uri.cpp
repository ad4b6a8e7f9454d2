#include "mesh/gltf/uri.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "mesh/relocated.hpp"

namespace hwffd::gltf {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDigits =
    "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr std::string_view kBase64 = ";base64";

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  const int lower = std::tolower(static_cast<unsigned char>(c));
  return lower >= 'a' && lower <= 'f' ? lower - 'a' + 10 : -1;
}

/// Value of each character; 64: none.
std::array<std::uint8_t, 256> make_values() {
  std::array<std::uint8_t, 256> values{};
  values.fill(64);
  for (std::size_t v = 0; v < kDigits.size(); ++v) {
    values[static_cast<unsigned char>(kDigits[v])] = static_cast<std::uint8_t>(v);
  }
  values['-'] = 62;  // of the alphabet for URIs
  values['_'] = 63;
  return values;
}

std::optional<std::string> base64_decoded(std::string_view text) {
  static const std::array<std::uint8_t, 256> kValues = make_values();
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  std::uint32_t word = 0;
  int bits = 0;
  for (const char c : text) {
    if (c == '\n' || c == '\r' || c == ' ' || c == '\t') continue;
    const std::uint32_t value = kValues[static_cast<unsigned char>(c)];
    if (value == 64) return std::nullopt;
    word = word << 6 | value;
    bits += 6;
    if (bits < 8) continue;
    bits -= 8;
    bytes += static_cast<char>(word >> bits & 0xff);
  }
  return bytes;
}

std::string base64_encoded(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t at = 0; at < bytes.size(); at += 3) {
    std::uint32_t word = 0;
    for (std::size_t i = at; i < at + 3; ++i) {
      word = word << 8 | (i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u);
    }
    const std::size_t digits = std::min<std::size_t>(bytes.size() - at, 3) + 1;
    for (std::size_t d = 0; d < 4; ++d) {
      text += d < digits ? kDigits[word >> (18 - 6 * d) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

std::string percent_decoded(std::string_view uri) {
  std::string bytes;
  for (std::size_t at = 0; at < uri.size(); ++at) {
    const bool is_code = uri[at] == '%' && at + 2 < uri.size() && hex_digit(uri[at + 1]) >= 0 &&
                         hex_digit(uri[at + 2]) >= 0;
    if (!is_code) {
      bytes += uri[at];
      continue;
    }
    bytes += static_cast<char>(hex_digit(uri[at + 1]) << 4 | hex_digit(uri[at + 2]));
    at += 2;
  }
  return bytes;
}

std::string percent_encoded(std::string_view path) {
  constexpr std::string_view kStay = "-._~!$&'()*+,;=@/";
  constexpr std::string_view kHex = "0123456789ABCDEF";
  std::string uri;
  for (const char c : path) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x80 || std::isalnum(byte) != 0 || kStay.find(c) != kStay.npos) {
      uri += c;
    } else {
      uri += '%';
      uri += kHex[byte >> 4];
      uri += kHex[byte & 15];
    }
  }
  return uri;
}

bool is_absolute_uri(std::string_view uri) {
  if (uri.empty() || uri[0] == '/') return true;
  const std::size_t colon = uri.find(':');
  if (colon == uri.npos || std::isalpha(static_cast<unsigned char>(uri[0])) == 0) return false;
  for (const char c : uri.substr(0, colon)) {
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '+' && c != '-' && c != '.') {
      return false;
    }
  }
  return true;
}

std::string relocated_uri(const std::string& uri, const fs::path& folder, const fs::path& output) {
  if (is_absolute_uri(uri)) return uri;
  const std::string name = percent_decoded(uri);
  const std::string moved = relocated(name, folder, output);
  return moved == name ? uri : percent_encoded(moved);
}

std::optional<std::string> data_of(std::string_view uri) {
  const std::size_t comma = uri.find(',');
  if (uri.substr(0, 5) != "data:" || comma == uri.npos) return std::nullopt;
  const std::string_view type = uri.substr(0, comma);
  if (type.size() < kBase64.size() || type.substr(type.size() - kBase64.size()) != kBase64) {
    return std::nullopt;
  }
  return base64_decoded(uri.substr(comma + 1));
}

std::string with_data(std::string_view uri, std::string_view bytes) {
  return std::string(uri.substr(0, uri.find(',') + 1)) + base64_encoded(bytes);
}

}  // namespace hwffd::gltf
