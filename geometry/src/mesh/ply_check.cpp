#include "mesh/ply_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <map>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "hwffd/excerpt.hpp"

namespace hwffd {
namespace {

constexpr std::size_t kQuoted = 30;  // characters of the file in a message, which is one line

struct Type {
  std::size_t size;  ///< bytes of the binary form; 0: no such type
  bool is_integer;
};

struct Property {
  std::string name;
  Type count{0, false};  ///< of a list; size 0 otherwise
  Type value{0, false};
};

struct Element {
  std::string name;
  std::uint64_t rows = 0;
  std::vector<Property> properties;
};

struct Header {
  std::string format;
  std::vector<Element> elements;
  std::size_t end = 0;  ///< where the data begin
};

/// A fault on the way; does not leave this file.
struct Fault {
  std::string text;
};

Type type_of(const std::string& name) {
  static const std::map<std::string, Type> kTypes = {
      {"char", {1, true}},    {"uchar", {1, true}},    {"int8", {1, true}},
      {"uint8", {1, true}},   {"short", {2, true}},    {"ushort", {2, true}},
      {"int16", {2, true}},   {"uint16", {2, true}},   {"int", {4, true}},
      {"uint", {4, true}},    {"int32", {4, true}},    {"uint32", {4, true}},
      {"float", {4, false}},  {"float32", {4, false}}, {"double", {8, false}},
      {"float64", {8, false}}};
  const auto found = kTypes.find(name);
  if (found == kTypes.end())
    throw Fault{"unknown type '" + excerpt(name, kQuoted) + "' in the header"};
  return found->second;
}

template <typename T>
T number_in(std::string_view text) {
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size()) return value;
  throw Fault{"'" + excerpt(text, kQuoted) + "' is not a number of rows or corners"};
}

Property property_in(std::istringstream& words) {
  Property property;
  std::string word;
  words >> word;
  if (word == "list") {
    words >> word;
    property.count = type_of(word);
    if (!property.count.is_integer) throw Fault{"a list counted in '" + word + "'"};
    words >> word;
  }
  property.value = type_of(word);
  words >> property.name;
  return property;
}

/// Takes the header's lines; other lines than these are comments.
Header header_of(const std::string& bytes) {
  Header header;
  while (header.end < bytes.size()) {
    const std::size_t end = std::min(bytes.find_first_of("\r\n", header.end), bytes.size());
    std::istringstream words(bytes.substr(header.end, end - header.end));
    header.end = std::min(bytes.size(), end + (bytes.compare(end, 2, "\r\n") == 0 ? 2 : 1));
    std::string word;
    words >> word;
    if (word == "end_header") return header;
    if (word == "format") words >> header.format;
    if (word == "element") {
      Element& element = header.elements.emplace_back();
      std::string rows;
      words >> element.name >> rows;
      element.rows = number_in<std::uint64_t>(rows);
    }
    if (word == "property") {
      if (header.elements.empty()) throw Fault{"a property before the first element"};
      header.elements.back().properties.push_back(property_in(words));
    }
  }
  throw Fault{"no end_header"};
}

/// Goes over the data, value by value.
class Data {
 public:
  Data(const std::string& bytes, const Header& header)
      : rest_(std::string_view(bytes).substr(header.end)),
        is_text_(header.format == "ascii"),
        is_little_(header.format == "binary_little_endian") {
    if (!is_text_ && !is_little_ && header.format != "binary_big_endian") {
      throw Fault{"unknown format '" + excerpt(header.format, kQuoted) + "'"};
    }
  }

  void skip(const Property& property) {
    if (property.count.size == 0) {
      take(property.value);
      return;
    }
    const std::uint64_t values = count_in(take(property.count));
    // A value has at least one byte: more would never end.
    if (values > rest_.size()) throw Fault{"the file ends in a list"};
    for (std::uint64_t n = 0; n < values; ++n) take(property.value);
  }

 private:
  std::string_view take(const Type& type) {
    std::size_t size = type.size;
    if (is_text_) {
      const std::size_t start = rest_.find_first_not_of(" \t\r\n");
      rest_.remove_prefix(std::min(start, rest_.size()));
      size = std::min(rest_.find_first_of(" \t\r\n"), rest_.size());
    }
    if (size == 0 || size > rest_.size()) throw Fault{"the file ends before its data"};
    const std::string_view value = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return value;
  }

  std::uint64_t count_in(std::string_view value) const {
    if (is_text_) return number_in<std::uint64_t>(value);
    std::uint64_t count = 0;
    for (std::size_t b = 0; b < value.size(); ++b) {
      const char byte = value[is_little_ ? value.size() - 1 - b : b];
      count = count << 8 | static_cast<unsigned char>(byte);
    }
    return count;
  }

  std::string_view rest_;
  bool is_text_;
  bool is_little_;
};

}  // namespace

std::string fault_of_ply(const std::string& bytes) {
  try {
    const Header header = header_of(bytes);
    Data data(bytes, header);
    for (const Element& element : header.elements) {
      if (element.properties.empty() && element.rows > 0) {
        throw Fault{"element '" + excerpt(element.name, kQuoted) + "' has no properties"};
      }
      for (std::uint64_t row = 0; row < element.rows; ++row) {
        for (const Property& property : element.properties) data.skip(property);
      }
    }
  } catch (const Fault& fault) {
    return fault.text;
  }
  return "";
}

std::vector<std::string> unread_of_ply(const std::string& bytes) {
  static const std::map<std::string, std::set<std::string>> kRead = {
      {"vertex",
       {"x",
        "y",
        "z",
        "nx",
        "ny",
        "nz",
        "red",
        "green",
        "blue",
        "alpha",
        "r",
        "g",
        "b",
        "diffuse_red",
        "diffuse_green",
        "diffuse_blue",
        "diffuse_alpha",
        "s",
        "t",
        "u",
        "v",
        "tx",
        "ty",
        "texture_u",
        "texture_v"}},
      {"face", {"vertex_index", "vertex_indices", "texcoord", "material_index"}},
      {"tristrips", {"vertex_index", "vertex_indices"}}};
  std::vector<std::string> unread;
  for (const Element& element : header_of(bytes).elements) {
    const auto known = kRead.find(element.name);
    if (known == kRead.end() && element.name != "material") {
      unread.push_back(fmt::format("element {}", excerpt(element.name, kQuoted)));
    }
    if (known == kRead.end()) continue;
    for (const Property& property : element.properties) {
      if (known->second.count(property.name) != 0) continue;
      unread.push_back(
          fmt::format("property {} of {}", excerpt(property.name, kQuoted), element.name));
    }
  }
  return unread;
}

}  // namespace hwffd
