#include "mesh/format/text.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>

#include "hwffd/excerpt.hpp"
#include "mesh/read_scene.hpp"

namespace hwffd {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f' || c == '\0'; }

bool is_ending(char c) { return c == '\n' || c == '\r'; }

/// Half the unit of the last digit of a decimal number.
double half_unit(std::string_view word) {
  const std::size_t exponent_at = word.find_first_of("eE");
  const std::string_view digits = word.substr(0, exponent_at);
  int exponent = 0;
  if (exponent_at != word.npos) {
    std::string_view text = word.substr(exponent_at + 1);
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    std::from_chars(text.data(), text.data() + text.size(), exponent);
  }
  const std::size_t point = digits.find('.');
  if (point != digits.npos) exponent -= static_cast<int>(digits.size() - point - 1);
  static constexpr double kTenths[] = {0.5,    0.5e-1, 0.5e-2, 0.5e-3, 0.5e-4, 0.5e-5,
                                       0.5e-6, 0.5e-7, 0.5e-8, 0.5e-9, 0.5e-10};
  if (exponent <= 0 && exponent >= -10) return kTenths[-exponent];
  return 0.5 * std::pow(10.0, exponent);
}

}  // namespace

std::size_t text_begin(std::string_view bytes) {
  return bytes.substr(0, kByteOrderMark.size()) == kByteOrderMark ? kByteOrderMark.size() : 0;
}

bool TextNumber::is_single() const {
  return std::abs(value - static_cast<double>(static_cast<float>(value))) <= half;
}

bool read_number(std::string_view word, TextNumber& number) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [next, error] = std::from_chars(word.data(), end, number.value);
  if (next != end || error == std::errc::invalid_argument) return false;
  if (error == std::errc::result_out_of_range) {
    const std::size_t exponent = word.find_first_of("eE");
    const bool is_small = exponent != word.npos && word.find('-', exponent) != word.npos;
    number.value = is_small ? 0.0 : std::numeric_limits<double>::infinity();
  }
  number.half = half_unit(word);
  return true;
}

template <typename T>
bool read_whole(std::string_view word, T& value) {
  if (!word.empty() && word.front() == '+') word.remove_prefix(1);
  const char* const end = word.data() + word.size();
  const auto [next, error] = std::from_chars(word.data(), end, value);
  return next == end && error == std::errc();
}

template bool read_whole(std::string_view word, std::int64_t& value);
template bool read_whole(std::string_view word, std::uint64_t& value);

std::string in_quotes(std::string_view text) { return "'" + excerpt(text, kQuoted) + "'"; }

TextNumber number_in(std::string_view word) {
  TextNumber number;
  if (!read_number(word, number)) throw not_a_mesh(in_quotes(word) + " is not a number");
  return number;
}

std::string lower_case(std::string_view word) {
  std::string text(word);
  for (char& c : text) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return text;
}

void append_number(std::string& text, double value, bool is_single) {
  if (is_single) {
    fmt::format_to(std::back_inserter(text), "{}", static_cast<float>(value));
  } else {
    fmt::format_to(std::back_inserter(text), "{}", value);
  }
}

LineReader::LineReader(std::string_view text, Continuation continuation)
    : text_(text), continuation_(continuation), at_(text_begin(text)) {}

bool LineReader::at_ending() const { return at_ == text_.size() || is_ending(text_[at_]); }

bool LineReader::at_continuation() const {
  return continuation_ == Continuation::kBackslash && at_ + 1 < text_.size() &&
         text_[at_] == '\\' && is_ending(text_[at_ + 1]);
}

void LineReader::take_ending() {
  const std::size_t size = text_.compare(at_, 2, "\r\n") == 0 ? 2 : at_ < text_.size() ? 1 : 0;
  ending_ = text_.substr(at_, size);
  at_ += size;
  ++endings_;
}

bool LineReader::next() {
  words_.clear();
  if (at_ == text_.size()) return false;
  number_ = endings_ + 1;
  bool is_comment = false;
  while (true) {
    if (at_ending()) break;
    const char c = text_[at_];
    if (at_continuation() && !is_comment) {
      ++at_;
      take_ending();
    } else if (is_comment || is_blank(c)) {
      ++at_;
    } else if (c == '#') {
      is_comment = true;
    } else {
      const std::size_t begin = at_;
      const bool is_number = c == '+' || c == '-' || c == '.' || (c >= '0' && c <= '9');
      while (!at_ending() && !is_blank(text_[at_])) {
        if ((is_number && text_[at_] == '#') || at_continuation()) break;
        ++at_;
      }
      words_.push_back(text_.substr(begin, at_ - begin));
    }
  }
  take_ending();
  return true;
}

std::string_view LineReader::from(std::size_t word) const {
  if (word >= words_.size()) return {};
  const char* const begin = words_[word].data();
  const char* const end = words_.back().data() + words_.back().size();
  return {begin, static_cast<std::size_t>(end - begin)};
}

void Replacement::replace(std::string_view part, std::string_view with) {
  const auto begin = static_cast<std::size_t>(part.data() - text_.data());
  insert(begin, with);
  done_ = begin + part.size();
}

void Replacement::replace_number(std::string_view part, double read, double now, bool is_single) {
  if (read == now || std::isnan(now)) return;
  std::string number;
  append_number(number, now, is_single);
  replace(part, number);
}

void Replacement::insert(std::size_t at, std::string_view with) {
  result_.append(text_, done_, at - done_).append(with);
  done_ = at;
}

std::string Replacement::take() {
  result_.append(text_, done_, text_.size() - done_);
  return std::move(result_);
}

}  // namespace hwffd
