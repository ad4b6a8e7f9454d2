#include "mesh/gltf/json_text.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "mesh/format/text.hpp"

namespace hwffd::gltf {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

}  // namespace

std::size_t JsonText::skip_blanks(std::size_t at) const {
  while (at < text_.size() && is_blank(text_[at])) ++at;
  return at;
}

std::size_t JsonText::end_of_value(std::size_t at) const {
  bool in_string = false;
  for (int depth = 0; at < text_.size(); ++at) {
    const char c = text_[at];
    if (in_string) {
      if (c == '\\') ++at;
      if (c == '"') in_string = false;
      if (!in_string && depth == 0) return at + 1;
    } else if (c == '"') {
      in_string = true;
    } else if (c == '{' || c == '[') {
      ++depth;
    } else if (c == '}' || c == ']') {
      if (depth == 0) return at;  // behind a number or a word
      if (--depth == 0) return at + 1;
    } else if (depth == 0 && (c == ',' || is_blank(c))) {
      return at;
    }
  }
  return text_.size();
}

JsonText::Span JsonText::root() const {
  const std::size_t begin = skip_blanks(text_begin(text_));
  return {begin, end_of_value(begin)};
}

std::size_t JsonText::depth() const {
  std::size_t depth = 0;
  std::size_t most = 0;
  for (std::size_t at = 0; at < text_.size(); ++at) {
    const char c = text_[at];
    if (c == '"') at = end_of_value(at) - 1;
    if (c == '{' || c == '[') most = std::max(most, ++depth);
    if (c == '}' || c == ']') --depth;
  }
  return most;
}

JsonText::Members JsonText::members(Span object) const {
  Members members;
  if (object.end - object.begin < 2 || text_[object.begin] != '{') return members;
  std::size_t at = skip_blanks(object.begin + 1);
  while (at < object.end && text_[at] == '"') {
    const Span name{at, end_of_value(at)};
    at = skip_blanks(skip_blanks(name.end) + 1);  // the colon
    const Span value{at, end_of_value(at)};
    members[unquoted(name)] = value;
    at = skip_blanks(value.end);
    if (at < object.end && text_[at] == ',') at = skip_blanks(at + 1);
  }
  return members;
}

std::vector<JsonText::Span> JsonText::items(Span array) const {
  std::vector<Span> items;
  if (array.end - array.begin < 2 || text_[array.begin] != '[') return items;
  std::size_t at = skip_blanks(array.begin + 1);
  while (at < array.end && text_[at] != ']') {
    items.push_back({at, end_of_value(at)});
    at = skip_blanks(items.back().end);
    if (at < array.end && text_[at] == ',') at = skip_blanks(at + 1);
  }
  return items;
}

std::string JsonText::unquoted(Span text) const {
  return nlohmann::json::parse(at(text)).get<std::string>();
}

std::vector<JsonText::Span> JsonText::texts(std::string_view name, std::string_view except) const {
  std::vector<Span> spans;
  const std::size_t end = text_.size();
  for (std::size_t at = root().begin; at < end;) {
    if (text_[at] != '"') {
      ++at;
      continue;
    }
    const Span quoted{at, end_of_value(at)};
    at = skip_blanks(quoted.end);
    if (at >= end || text_[at] != ':') continue;  // a value, not a name
    at = skip_blanks(at + 1);
    const std::string member = unquoted(quoted);
    if (member == except) {
      at = end_of_value(at);
    } else if (member == name && at < end && text_[at] == '"') {
      spans.push_back({at, end_of_value(at)});
      at = spans.back().end;
    }
  }
  return spans;
}

void JsonText::replace(Span span, std::string characters) {
  changes_.insert({span.begin, {span.end, std::move(characters)}});
}

void JsonText::add(Span brackets, const std::string& items) {
  std::size_t last = brackets.end - 1;  // behind the last item, or the opening bracket
  while (is_blank(text_[last - 1])) --last;
  const bool is_first = last == brackets.begin + 1;
  const auto [from, to] = changes_.equal_range(last);
  bool has_added = false;
  for (auto change = from; change != to; ++change) has_added |= change->second.end == last;
  changes_.insert({last, {last, is_first && !has_added ? items : "," + items}});
}

void JsonText::add_member(Span object, const std::string& name, const std::string& value) {
  add(object, nlohmann::json(name).dump() + ":" + value);
}

void JsonText::add_items(Span array, const std::vector<std::string>& values) {
  for (const std::string& value : values) add(array, value);
}

std::string JsonText::edited() const {
  std::string result;
  std::size_t done = 0;
  for (const auto& [begin, change] : changes_) {
    result += text_.substr(done, begin - done);
    result += change.characters;
    done = change.end;
  }
  result += text_.substr(done);
  return result;
}

}  // namespace hwffd::gltf
