#include "mutator.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace hwffd {
namespace {

constexpr std::size_t kLongest = 1 << 20;  // of an input

/// Numbers at and beyond the ends of integers, of binary32 and binary64, and what is not a number.
constexpr std::array<const char*, 24> kNumbers{{"0",
                                                "-0",
                                                "-1",
                                                "3",
                                                "16",
                                                "17",
                                                "255",
                                                "2147483648",
                                                "-2147483649",
                                                "4294967295",
                                                "1e9",
                                                "4294967300",
                                                "1e-320",
                                                "1e38",
                                                "3.5e38",
                                                "1e308",
                                                "-1e308",
                                                "1e999",
                                                "nan",
                                                "-inf",
                                                "0x7f",
                                                "1e",
                                                "9223372036854775808",
                                                "18446744073709551616"}};

/// Bytes that mean something to a reader of text.
constexpr std::array<char, 20> kSpecial{{'\0', '\n', '\r', '\t', ' ',    '"',   '\'',
                                         '\\', '[',  ']',  '{',  '}',    ':',   ',',
                                         '.',  '-',  '/',  '#',  '\x7f', '\xff'}};

bool is_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e' || c == 'E';
}

bool is_word(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// Position and length of every run of characters of a kind.
std::vector<std::pair<std::size_t, std::size_t>> runs(const std::string& text, bool (*kind)(char)) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && kind(text[end])) ++end;
    if (end > at) found.emplace_back(at, end - at);
    at = end + 1;
  }
  return found;
}

}  // namespace

std::string Mutator::next() {
  std::string text = random_.pick(corpus_);
  if (random_.below(64) == 0) return text;
  for (std::uint64_t changes = random_.between(1, 4); changes > 0; --changes) change(text);
  if (text.size() > kLongest) text.resize(kLongest);
  return text;
}

void Mutator::change(std::string& text) {
  if (text.empty()) text = random_.pick(corpus_);
  using Change = void (Mutator::*)(std::string&);
  // Numbers count double; deep and long texts, which take long to read, are rare.
  constexpr std::array<Change, 6> kCommon{{&Mutator::change_byte, &Mutator::cut, &Mutator::copy,
                                           &Mutator::change_number, &Mutator::change_number,
                                           &Mutator::swap_words}};
  const std::uint64_t rare = random_.below(50);
  const Change chosen = rare == 0   ? &Mutator::nest
                        : rare == 1 ? &Mutator::repeat
                                    : random_.pick(kCommon);
  (this->*chosen)(text);
}

Mutator::Range Mutator::range(const std::string& text, std::size_t longest) {
  const std::size_t start = random_.below(text.size());
  return {start, random_.between(1, std::min(longest, text.size() - start))};
}

void Mutator::change_byte(std::string& text) {
  char& byte = text[random_.below(text.size())];
  switch (random_.below(3)) {
    case 0:
      byte = static_cast<char>(byte ^ (1 << random_.below(8)));
      break;
    case 1:
      byte = static_cast<char>(random_.below(256));
      break;
    default:
      byte = random_.pick(kSpecial);
  }
}

void Mutator::cut(std::string& text) {
  const Range part = range(text, random_.below(8) == 0 ? text.size() : 20);
  text.erase(part.start, part.length);
}

/// A part of this input or of another valid one, inserted or written over what is there.
void Mutator::copy(std::string& text) {
  const std::string source = random_.below(2) == 0 ? text : random_.pick(corpus_);
  const Range part = range(source, random_.below(8) == 0 ? source.size() : 40);
  const std::size_t at = random_.below(text.size() + 1);
  const std::size_t over = random_.below(2) == 0 ? 0 : part.length;
  text.replace(at, over, source, part.start, part.length);
}

void Mutator::change_number(std::string& text) {
  const auto numbers = runs(text, is_number);
  if (numbers.empty()) return change_byte(text);
  const auto [start, length] = random_.pick(numbers);
  text.replace(start, length, random_.pick(kNumbers));
}

void Mutator::swap_words(std::string& text) {
  const auto words = runs(text, is_word);
  if (words.empty()) return change_byte(text);
  const auto [start, length] = random_.pick(words);
  const auto [from, size] = random_.pick(words);
  const std::string word = text.substr(from, size);
  if (random_.below(2) == 0) text.replace(from, size, text.substr(start, length));
  if (start < text.size()) text.replace(start, std::min(length, text.size() - start), word);
}

void Mutator::nest(std::string& text) {
  const auto depth = static_cast<std::size_t>(1) << random_.below(17);
  const Range part = range(text, 20);
  const bool object = random_.below(3) == 0;
  std::string open;
  std::string close;
  for (std::size_t n = 0; n < depth; ++n) {
    open += object ? "{\"a\":" : "[";
    close += object ? '}' : ']';
  }
  if (random_.below(2) == 0) text.insert(part.start + part.length, close);
  text.insert(part.start, open);
}

void Mutator::repeat(std::string& text) {
  const Range part = range(text, 8);
  const std::string piece = text.substr(part.start, part.length);
  std::string many;
  for (std::uint64_t n = std::uint64_t{1} << random_.below(16); n > 0; --n) many += piece;
  text.insert(part.start, many);
}

}  // namespace hwffd
