#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace hwffd::gltf {

/// An object of a JSON file, read with checks. Every failure is an Error that begins with its name,
/// such as "accessor 3: ".
class JsonItem {
 public:
  /// @param json  must live as long
  JsonItem(const nlohmann::json& json, std::string name);

  const std::string& name() const { return name_; }
  const nlohmann::json& json() const { return *json_; }
  bool has(const char* key) const;
  /// What is there; null where nothing is.
  const nlohmann::json& value(const char* key) const;

  /// A whole number that is not negative; the fallback where there is none.
  std::size_t whole(const char* key, std::optional<std::size_t> fallback = {}) const;
  /// Likewise, the number of one of `count` things.
  std::optional<std::size_t> index(const char* key, std::size_t count) const;
  double number(const char* key, double fallback) const;
  bool truth(const char* key) const;
  std::string text(const char* key, const std::string& fallback) const;
  /// So many numbers, or the fallback.
  std::vector<double> numbers(const char* key, const std::vector<double>& fallback) const;
  /// Texts of an array; none where it is missing.
  std::vector<std::string> texts(const char* key) const;
  /// Numbers of things of an array; none where it is missing.
  std::vector<std::size_t> indices(const char* key, std::size_t count) const;
  /// An object in it; an empty one where it is missing.
  JsonItem object(const char* key) const;
  /// The objects of an array, named "what 0", "what 1"; none where it is missing.
  std::vector<JsonItem> list(const char* key, const std::string& what) const;

  /// @throws Error always: the name, what is wrong with it, and the cure
  [[noreturn]] void fail(const std::string& what) const;

 private:
  const nlohmann::json& array(const char* key) const;

  const nlohmann::json* json_;
  std::string name_;
};

}  // namespace hwffd::gltf
