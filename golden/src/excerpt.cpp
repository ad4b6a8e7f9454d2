#include "hwffd/excerpt.hpp"

namespace hwffd {
namespace {

std::string hexadecimal(unsigned char byte) {
  constexpr const char* kDigits = "0123456789abcdef";
  return {'\\', 'x', kDigits[byte >> 4], kDigits[byte & 15]};
}

}  // namespace

std::string excerpt(std::string_view text, std::size_t limit) {
  constexpr std::string_view kCut = "...";
  std::string result;
  std::size_t fits = 0;  // length of the part that leaves room for kCut
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool printable = byte >= 0x20 && byte < 0x7f;
    result += printable ? std::string(1, c) : hexadecimal(byte);
    if (result.size() > limit) return result.substr(0, fits).append(kCut);
    if (result.size() + kCut.size() <= limit) fits = result.size();
  }
  return result;
}

std::string one_line(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_control = byte < 0x20 || byte == 0x7f;
    result += is_control ? hexadecimal(byte) : std::string(1, c);
  }
  return result;
}

}  // namespace hwffd
