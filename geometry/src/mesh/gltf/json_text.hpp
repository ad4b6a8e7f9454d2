#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace hwffd::gltf {

/// A JSON text that is changed in places: where its values stand, and what is to stand there. All
/// other characters stay. The text must be valid JSON; of names given twice the last one counts, as
/// for nlohmann's parser.
class JsonText {
 public:
  /// The characters of a value, from its first to behind its last.
  struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;
  };
  using Members = std::map<std::string, Span>;

  /// @param text  must live as long
  explicit JsonText(std::string_view text) : text_(text) {}

  std::string_view at(Span span) const { return text_.substr(span.begin, span.end - span.begin); }
  Span root() const;
  /// How many objects and arrays stand within each other.
  std::size_t depth() const;
  /// Of an object, by name; none of anything else.
  Members members(Span object) const;
  /// Of an array; none of anything else.
  std::vector<Span> items(Span array) const;
  /// All texts that are members of this name, at any depth, but not within members of the other.
  std::vector<Span> texts(std::string_view name, std::string_view except) const;
  /// What a text says.
  std::string unquoted(Span text) const;

  /// Puts other characters in the place of a value, once for each.
  void replace(Span span, std::string characters);
  /// Adds a member to an object that has none of that name.
  void add_member(Span object, const std::string& name, const std::string& value);
  /// Adds values at the end of an array.
  void add_items(Span array, const std::vector<std::string>& values);

  /// The text with all that was changed.
  std::string edited() const;

 private:
  std::size_t skip_blanks(std::size_t at) const;
  std::size_t end_of_value(std::size_t at) const;
  /// Adds items to what stands between two brackets.
  void add(Span brackets, const std::string& items);

  struct Change {
    std::size_t end;
    std::string characters;
  };
  std::string_view text_;
  std::multimap<std::size_t, Change> changes_;  ///< by where they begin
};

}  // namespace hwffd::gltf
