#include "hwffd/tb/random.hpp"

#include <cerrno>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace hwffd::tb {

std::uint64_t Random::below(std::uint64_t n) {
  if (n == 0) throw std::invalid_argument("Random: no number below 0, or an empty list");
  // 2^64 mod n: below this many draws are rejected, so that every remainder is equally likely.
  const std::uint64_t surplus = (0 - n) % n;
  std::uint64_t draw = bits();
  while (draw < surplus) draw = bits();
  return draw % n;
}

std::uint64_t Random::between(std::uint64_t low, std::uint64_t high) {
  if (high < low) throw std::invalid_argument("Random: empty range");
  const std::uint64_t span = high - low;
  return span == ~std::uint64_t{0} ? bits() : low + below(span + 1);
}

std::uint64_t derive_seed(std::uint64_t seed, std::uint64_t index) {
  std::uint64_t z = seed + (index + 1) * 0x9e3779b97f4a7c15u;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

std::uint64_t seed_from_environment(std::uint64_t fallback, const char* variable) {
  const char* text = std::getenv(variable);
  if (text == nullptr || *text == '\0') return fallback;
  const bool hexadecimal = text[0] == '0' && (text[1] == 'x' || text[1] == 'X');
  char* end = nullptr;
  errno = 0;
  const unsigned long long value = std::strtoull(text, &end, hexadecimal ? 16 : 10);
  const bool starts_with_digit = *text >= '0' && *text <= '9';
  if (!starts_with_digit || *end != '\0' || errno == ERANGE) {
    throw std::invalid_argument(std::string(variable) + ": \"" + text +
                                "\" is not a 64-bit number");
  }
  return value;
}

}  // namespace hwffd::tb
