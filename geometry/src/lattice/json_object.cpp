#include "json_object.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"

namespace hwffd {
namespace {

// Not ordered_json, which copies values while it grows, by a call for each level of nesting.
using Json = nlohmann::json;

constexpr int kNumberOverflow = 406;  // the library's number of that error

[[noreturn]] void fail_at(const std::string& text, std::size_t byte, const char* what) {
  const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(byte, text.size()));
  const auto line = std::find(std::make_reverse_iterator(end), text.rend(), '\n').base();
  throw Error(fmt::format("line {}, column {}: {}", 1 + std::count(text.begin(), end, '\n'),
                          1 + (end - line), what));
}

/// Takes notice of what the library's parser passes over: where it fails, and names given twice.
class Syntax : public nlohmann::json_sax<Json> {
 public:
  explicit Syntax(const std::string& text) : text_(text) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }

  bool start_object(std::size_t) override {
    ++depth_;
    return true;
  }
  bool end_object() override {
    --depth_;
    return true;
  }
  bool key(string_t& name) override {
    if (depth_ > 1 || names_.insert(name).second) return true;
    throw Error(fmt::format("'{}' stands there twice; keep one", excerpt(name)));
  }

  bool parse_error(std::size_t bytes_read, const std::string&,
                   const nlohmann::detail::exception& error) override {
    fail_at(text_, bytes_read > 0 ? bytes_read - 1 : 0,
            error.id == kNumberOverflow ? "a number too large for double precision"
                                        : "no JSON; docs/lattice.md shows the format");
  }

 private:
  const std::string& text_;
  int depth_ = 0;
  std::set<std::string> names_;  ///< of the outermost object
};

}  // namespace

Json parse_object(const std::string& text) {
  // The library takes a zero byte for the end, whatever follows it.
  const std::size_t zero = text.find('\0');
  if (zero != std::string::npos) fail_at(text, zero, "a zero byte; is this the right file?");
  Syntax syntax(text);
  Json::sax_parse(text, &syntax);
  Json object = Json::parse(text);
  if (!object.is_object()) throw Error("not a JSON object; docs/lattice.md shows the format");
  return object;
}

}  // namespace hwffd
