#include "mesh/gltf/json_item.hpp"

#include <fmt/format.h>

#include <cmath>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"

namespace hwffd::gltf {
namespace {

using Json = nlohmann::json;

/// 8 and 8.0 are; -1, 0.5 and what no double counts are not.
std::optional<std::size_t> whole_of(const Json& value) {
  constexpr double kMost = 9007199254740992.0;  // 2^53
  if (value.is_number_unsigned()) return value.get<std::size_t>();
  if (!value.is_number_float()) return std::nullopt;
  const double number = value.get<double>();
  if (!(number >= 0 && number < kMost) || number != std::floor(number)) return std::nullopt;
  return static_cast<std::size_t>(number);
}

}  // namespace

JsonItem::JsonItem(const Json& json, std::string name) : json_(&json), name_(std::move(name)) {
  if (!json.is_object()) fail("is no object");
}

void JsonItem::fail(const std::string& what) const {
  throw Error(fmt::format("{}: {}; repair the file", name_, excerpt(what, 100)));
}

bool JsonItem::has(const char* key) const { return json_->contains(key); }

const Json& JsonItem::value(const char* key) const {
  static const Json kNull;
  const auto it = json_->find(key);
  return it == json_->end() ? kNull : *it;
}

std::size_t JsonItem::whole(const char* key, std::optional<std::size_t> fallback) const {
  if (!has(key) && fallback) return *fallback;
  if (!has(key)) fail(fmt::format("has no {}", key));
  const std::optional<std::size_t> number = whole_of(value(key));
  if (!number) fail(fmt::format("its {} is no whole number", key));
  return *number;
}

std::optional<std::size_t> JsonItem::index(const char* key, std::size_t count) const {
  if (!has(key)) return std::nullopt;
  const std::size_t number = whole(key);
  if (number >= count) fail(fmt::format("its {} is {} of {}", key, number, count));
  return number;
}

double JsonItem::number(const char* key, double fallback) const {
  if (!has(key)) return fallback;
  if (!value(key).is_number()) fail(fmt::format("its {} is no number", key));
  return value(key).get<double>();
}

bool JsonItem::truth(const char* key) const {
  if (!has(key)) return false;
  if (!value(key).is_boolean()) fail(fmt::format("its {} is neither true nor false", key));
  return value(key).get<bool>();
}

std::string JsonItem::text(const char* key, const std::string& fallback) const {
  if (!has(key)) return fallback;
  if (!value(key).is_string()) fail(fmt::format("its {} is no text", key));
  return value(key).get<std::string>();
}

const Json& JsonItem::array(const char* key) const {
  static const Json kNone = Json::array();
  if (!has(key)) return kNone;
  if (!value(key).is_array()) fail(fmt::format("its {} are no array", key));
  return value(key);
}

std::vector<double> JsonItem::numbers(const char* key, const std::vector<double>& fallback) const {
  if (!has(key)) return fallback;
  std::vector<double> numbers;
  for (const Json& number : array(key)) {
    if (!number.is_number()) fail(fmt::format("its {} has an entry that is no number", key));
    numbers.push_back(number.get<double>());
  }
  if (numbers.size() != fallback.size()) {
    fail(fmt::format("its {} has {} numbers, not {}", key, numbers.size(), fallback.size()));
  }
  return numbers;
}

std::vector<std::string> JsonItem::texts(const char* key) const {
  std::vector<std::string> texts;
  for (const Json& text : array(key)) {
    if (!text.is_string()) fail(fmt::format("its {} has an entry that is no text", key));
    texts.push_back(text.get<std::string>());
  }
  return texts;
}

std::vector<std::size_t> JsonItem::indices(const char* key, std::size_t count) const {
  std::vector<std::size_t> numbers;
  for (const Json& entry : array(key)) {
    const std::optional<std::size_t> number = whole_of(entry);
    if (!number || *number >= count) {
      fail(fmt::format("its {} has an entry that is none of {}", key, count));
    }
    numbers.push_back(*number);
  }
  return numbers;
}

JsonItem JsonItem::object(const char* key) const {
  static const Json kEmpty = Json::object();
  return {has(key) ? value(key) : kEmpty, fmt::format("{} of {}", key, name_)};
}

std::vector<JsonItem> JsonItem::list(const char* key, const std::string& what) const {
  std::vector<JsonItem> items;
  for (const Json& item : array(key)) {
    items.emplace_back(item, fmt::format("{} {}", what, items.size()));
  }
  return items;
}

}  // namespace hwffd::gltf
