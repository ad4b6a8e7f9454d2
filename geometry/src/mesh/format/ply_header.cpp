#include "mesh/format/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "hwffd/error.hpp"
#include "mesh/format/text.hpp"
#include "mesh/read_scene.hpp"

namespace hwffd {
namespace {

PlyType type_of(const std::string& name) {
  using Kind = PlyType::Kind;
  struct Row {
    Kind kind;
    std::size_t size;
  };
  static const std::map<std::string, Row> kTypes = {
      {"char", {Kind::kSigned, 1}},     {"int8", {Kind::kSigned, 1}},
      {"uchar", {Kind::kUnsigned, 1}},  {"uint8", {Kind::kUnsigned, 1}},
      {"short", {Kind::kSigned, 2}},    {"int16", {Kind::kSigned, 2}},
      {"ushort", {Kind::kUnsigned, 2}}, {"uint16", {Kind::kUnsigned, 2}},
      {"int", {Kind::kSigned, 4}},      {"int32", {Kind::kSigned, 4}},
      {"uint", {Kind::kUnsigned, 4}},   {"uint32", {Kind::kUnsigned, 4}},
      {"float", {Kind::kFloat, 4}},     {"float32", {Kind::kFloat, 4}},
      {"double", {Kind::kFloat, 8}},    {"float64", {Kind::kFloat, 8}}};
  const auto it = kTypes.find(name);
  if (it == kTypes.end()) throw not_a_mesh("unknown type " + in_quotes(name) + " in the header");
  return {it->second.kind, it->second.size, name};
}

std::uint64_t count_in(std::string_view word) {
  std::uint64_t count = 0;
  if (!read_whole(word, count)) {
    throw not_a_mesh(in_quotes(word) + " is not a number of rows or corners");
  }
  return count;
}

using Words = std::vector<std::string>;

Words words_of(std::string_view line) {
  Words words;
  for (std::size_t at = 0; at < line.size();) {
    at = std::min(line.find_first_not_of(" \t", at), line.size());
    const std::size_t end = std::min(line.find_first_of(" \t", at), line.size());
    if (end > at) words.emplace_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

const std::string& word(const Words& words, std::size_t number) {
  static const std::string kNone;
  return number < words.size() ? words[number] : kNone;
}

PlyProperty property_in(const Words& words) {
  PlyProperty property;
  property.is_list = word(words, 1) == "list";
  const std::size_t type = property.is_list ? 3 : 1;
  if (property.is_list) {
    property.count = type_of(word(words, 2));
    if (!property.count.is_integer()) {
      throw not_a_mesh("a list counted in '" + property.count.name + "'");
    }
  }
  property.value = type_of(word(words, type));
  property.name = word(words, type + 1);
  return property;
}

PlyHeader::Format format_in(const std::string& name) {
  if (name == "ascii") return PlyHeader::Format::kText;
  if (name == "binary_little_endian") return PlyHeader::Format::kLittle;
  if (name == "binary_big_endian") return PlyHeader::Format::kBig;
  throw not_a_mesh("unknown format " + in_quotes(name));
}

/// Takes a line of the header; comments and what is unknown are passed over.
/// @param begin  of the line
void take(const std::string& line, std::size_t begin, PlyHeader& header, bool& has_format) {
  const Words words = words_of(line);
  const std::string& keyword = word(words, 0);
  if (keyword == "format") {
    header.format = format_in(word(words, 1));
    has_format = true;
  }
  if (keyword == "comment" && word(words, 1) == "TextureFile") {
    constexpr std::string_view kKeyword = "TextureFile";
    const std::size_t name = line.find_first_not_of(" \t", line.find(kKeyword) + kKeyword.size());
    if (name != line.npos) header.textures.push_back({line.substr(name), begin + name});
  }
  if (keyword == "element") {
    header.elements.push_back({word(words, 1), count_in(word(words, 2)), {}});
  }
  if (keyword == "property") {
    if (header.elements.empty()) throw not_a_mesh("a property before the first element");
    header.elements.back().properties.push_back(property_in(words));
  }
}

template <typename T>
double read(std::string_view value, bool is_big) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, value.data(), sizeof(T));
  if (is_big) std::reverse(bytes, bytes + sizeof(T));
  T number;
  std::memcpy(&number, bytes, sizeof(T));
  return static_cast<double>(number);
}

template <typename T>
std::string written(double number, bool is_big) {
  const T value = static_cast<T>(number);
  std::string bytes(sizeof(T), '\0');
  std::memcpy(bytes.data(), &value, sizeof(T));
  if (is_big) std::reverse(bytes.begin(), bytes.end());
  return bytes;
}

/// Whether a type of integers has the number.
bool holds(const PlyType& type, double number) {
  const bool is_signed = type.kind == PlyType::Kind::kSigned;
  const double values = std::ldexp(1.0, static_cast<int>(8 * type.size));
  const double low = is_signed ? -values / 2 : 0;
  return number == std::nearbyint(number) && number >= low && number < low + values;
}

}  // namespace

PlyHeader ply_header(const std::string& bytes) {
  PlyHeader header;
  std::size_t at = text_begin(bytes);
  if (bytes.compare(at, 3, "ply") != 0) throw not_a_mesh("it does not begin with 'ply'");
  const std::size_t first = bytes.find_first_of("\r\n", at);
  // As the first line ends all do: a byte of the data may be one that ends lines elsewhere.
  const bool is_double = first != bytes.npos && bytes.compare(first, 2, "\r\n") == 0;
  const std::string ending = is_double             ? "\r\n"
                             : first == bytes.npos ? "\n"
                                                   : bytes.substr(first, 1);
  bool has_format = false;
  for (bool is_first = true; at < bytes.size(); is_first = false) {
    const std::size_t end = std::min(bytes.find(ending, at), bytes.size());
    const std::size_t begin = at;
    const std::string line = bytes.substr(begin, end - begin);
    at = std::min(bytes.size(), end + ending.size());
    const Words words = words_of(line);
    if (is_first && (words.size() != 1 || words[0] != "ply")) {
      throw not_a_mesh("it does not begin with 'ply'");
    }
    if (word(words, 0) == "end_header") {
      header.end = at;
      if (!has_format) throw not_a_mesh("unknown format ''");
      return header;
    }
    take(line, begin, header, has_format);
  }
  throw not_a_mesh("no end_header");
}

PlyCursor::PlyCursor(const std::string& bytes, const PlyHeader& header)
    : rest_(std::string_view(bytes).substr(header.end)), format_(header.format) {}

std::string_view PlyCursor::take(const PlyType& type) {
  std::size_t size = type.size;
  if (is_text()) {
    const auto is_blank = [](char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; };
    std::size_t start = 0;
    while (start < rest_.size() && is_blank(rest_[start])) ++start;
    rest_.remove_prefix(start);
    size = 0;
    while (size < rest_.size() && !is_blank(rest_[size])) ++size;
  }
  if (size == 0 || size > rest_.size()) throw not_a_mesh("the file ends before its data");
  const std::string_view value = rest_.substr(0, size);
  rest_.remove_prefix(size);
  return value;
}

std::uint64_t PlyCursor::take_count(const PlyProperty& list) {
  const std::string_view value = take(list.count);
  std::uint64_t count = 0;
  if (is_text()) {
    count = count_in(value);
  } else {
    const double number = this->number(value, list.count);
    if (number < 0) throw not_a_mesh(fmt::format("a list of {} values", number));
    count = static_cast<std::uint64_t>(number);
  }
  // A value has at least one byte: more would never end.
  if (count > rest_.size()) throw not_a_mesh("the file ends in a list");
  return count;
}

void PlyCursor::skip(const PlyProperty& property) {
  const std::uint64_t values = property.is_list ? take_count(property) : 1;
  for (std::uint64_t n = 0; n < values; ++n) take(property.value);
}

double PlyCursor::number(std::string_view value, const PlyType& type) const {
  if (is_text()) {
    const TextNumber number = number_in(value);
    const bool is_single = !type.is_integer() && type.size == sizeof(float);
    return is_single ? static_cast<float>(number.value) : number.value;
  }
  const bool is_big = format_ == PlyHeader::Format::kBig;
  const bool is_signed = type.kind == PlyType::Kind::kSigned;
  if (!type.is_integer()) {
    return type.size == sizeof(float) ? read<float>(value, is_big) : read<double>(value, is_big);
  }
  switch (type.size) {
    case 1:
      return is_signed ? read<std::int8_t>(value, is_big) : read<std::uint8_t>(value, is_big);
    case 2:
      return is_signed ? read<std::int16_t>(value, is_big) : read<std::uint16_t>(value, is_big);
    default:
      return is_signed ? read<std::int32_t>(value, is_big) : read<std::uint32_t>(value, is_big);
  }
}

std::string PlyCursor::bytes_of(double number, const PlyType& type) const {
  if (type.is_integer() && !holds(type, number)) {
    throw Error(fmt::format(
        "a coordinate becomes {}, which its type, {}, does not hold; write another format", number,
        type.name));
  }
  if (is_text()) {
    std::string text;
    append_number(text, number, !type.is_integer() && type.size == sizeof(float));
    return text;
  }
  const bool is_big = format_ == PlyHeader::Format::kBig;
  const bool is_signed = type.kind == PlyType::Kind::kSigned;
  if (!type.is_integer()) {
    return type.size == sizeof(float) ? written<float>(number, is_big)
                                      : written<double>(number, is_big);
  }
  switch (type.size) {
    case 1:
      return is_signed ? written<std::int8_t>(number, is_big)
                       : written<std::uint8_t>(number, is_big);
    case 2:
      return is_signed ? written<std::int16_t>(number, is_big)
                       : written<std::uint16_t>(number, is_big);
    default:
      return is_signed ? written<std::int32_t>(number, is_big)
                       : written<std::uint32_t>(number, is_big);
  }
}

}  // namespace hwffd
