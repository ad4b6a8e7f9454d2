#include "hwffd/lattice/lattice_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <nlohmann/json.hpp>
#include <set>
#include <utility>

#include "hwffd/atomic_file.hpp"
#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"
#include "hwffd/lattice/few_points.hpp"
#include "hwffd/lattice/shape.hpp"
#include "read_file.hpp"

namespace hwffd {
namespace {

// Not ordered_json, which copies values while it grows, by a call for each level of nesting.
using Json = nlohmann::json;

constexpr int kVersion = 1;
// 64 x 64 x 64 points and as many at rest take 80 bytes each at most.
constexpr std::size_t kMostBytes = std::size_t{48} << 20;
constexpr const char* kOrder = "point (i, j, k) is number (i*n_t + j)*n_u + k";

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

/// Reads text that is one JSON object and nothing after it.
/// @throws Error with line and column, from 1 and in bytes, of what is no JSON or a number beyond
///   double precision; for a name that the object has twice, and for another value than an object
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

/// An entry that must be there.
const Json& entry(const Json& object, const char* name, const char* cure) {
  const auto it = object.find(name);
  if (it != object.end()) return *it;
  throw Error(fmt::format("lattice file: no '{}'; give {}", name, cure));
}

/// Refuses entries that would be ignored: a misspelt name is an error, not a default.
void check_names(const Json& object, std::initializer_list<const char*> known) {
  for (const auto& item : object.items()) {
    const bool is_known = std::any_of(known.begin(), known.end(),
                                      [&](const char* name) { return item.key() == name; });
    if (is_known) continue;
    throw Error(fmt::format("lattice file: unknown '{}'; known here are {}", excerpt(item.key()),
                            fmt::join(known, ", ")));
  }
}

Index3 read_dims(const Json& object) {
  const char* const cure = "three integers from 2 to 64, points along s, t and u";
  const Json& value = entry(object, "dims", cure);
  Index3 dims{};
  bool good = value.is_array() && value.size() == 3;
  for (std::size_t a = 0; good && a < 3; ++a) {
    good = value[a].is_number_integer() && value[a] >= -99 && value[a] <= 99;
    if (good) dims[a] = value[a].get<int>();
  }
  if (!good) throw Error(fmt::format("lattice file: 'dims' is not {}", cure));
  Lattice::check_dims(dims, Lattice::kFewestPoints);
  return dims;
}

/// Three numbers; JSON has no infinities, but too many digits make one: Lattice refuses those.
Point read_point(const Json& value, const std::string& name) {
  const bool good = value.is_array() && value.size() == 3 && value[0].is_number() &&
                    value[1].is_number() && value[2].is_number();
  if (good) return {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()};
  throw Error(fmt::format("lattice file: {} is not a point; give [x, y, z]", name));
}

/// @param list  "points" or "rest"
/// @param where  those of it are, for messages
Points read_points(const Json& value, const char* list, const char* where = "") {
  if (!value.is_array()) {
    throw Error(fmt::format("lattice file: '{}' is not a list; give [[x, y, z], ...]", list));
  }
  Points points(static_cast<Eigen::Index>(value.size()), 3);
  for (std::size_t i = 0; i < value.size(); ++i) {
    points.row(static_cast<Eigen::Index>(i)) =
        read_point(value[i], fmt::format("point {}{}", i, where));
  }
  return points;
}

double read_inner(const Json& object) {
  const auto it = object.find("inner");
  if (it == object.end()) return 0.0;
  if (it->is_number()) return it->get<double>();
  throw Error("lattice file: 'inner' is not a number; give 0 (solid) or more, and less than 1");
}

std::optional<Family> read_family(const Json& object) {
  const auto it = object.find("family");
  if (it == object.end()) return std::nullopt;
  try {
    if (it->is_string()) return Family::parse(it->get<std::string>());
  } catch (const UsageError&) {
    // No family has that name.
  }
  throw Error(fmt::format("lattice file: unknown 'family'; give one of {}",
                          fmt::join(Family::names(), ", ")));
}

std::optional<Lattice> read_rest(const Json& object, const Index3& dims) {
  const auto it = object.find("rest");
  if (it == object.end()) return std::nullopt;
  Points points = read_points(*it, "rest", " at rest");
  try {
    return Lattice(dims, std::move(points));
  } catch (const Error& error) {
    throw Error(fmt::format("lattice file: 'rest': {}", error.what()));
  }
}

Lattice read_shape(const Json& object, const Index3& dims) {
  const Json& shape = object["shape"];
  const Shape* const kind = shape.is_string() ? find_shape(shape.get<std::string>()) : nullptr;
  if (kind == nullptr) {
    throw Error(fmt::format("lattice file: unknown 'shape'; give {}, or 'points' instead",
                            shape_list(" or ")));
  }
  Placement placement;
  placement.origin = read_point(entry(object, "origin", "[x, y, z]"), "'origin'");
  const Json& columns = entry(object, "edges", "three vectors, along s, t and u of the shape");
  if (!columns.is_array() || columns.size() != 3) {
    throw Error("lattice file: 'edges' is not a list of three; give [[x, y, z], ...]");
  }
  for (int a = 0; a < 3; ++a) {
    placement.edges.col(a) =
        read_point(columns[static_cast<std::size_t>(a)], fmt::format("edge {}", a));
  }
  placement.inner = read_inner(object);
  if (!kind->has_inner && object.contains("inner")) {
    throw Error(fmt::format("lattice file: a {} has no 'inner'; leave it out", kind->name));
  }
  return kind->placed(placement, dims);
}

Json parse_json(const std::string& text) {
  try {
    return parse_object(text);
  } catch (const Error& error) {
    throw Error(fmt::format("lattice file: {}", error.what()));
  }
}

std::string points_text(const Lattice& lattice) {
  std::string text = "[";
  const Points& points = lattice.points();
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    text += fmt::format("{}\n[{}, {}, {}]", i == 0 ? "" : ",", points(i, 0), points(i, 1),
                        points(i, 2));
  }
  return text + "\n]";
}

}  // namespace

LatticeFile parse_lattice_file(const std::string& text) {
  const Json object = parse_json(text);
  if (entry(object, "hwffd_lattice", "the version of the format, 1") != kVersion) {
    throw Error("lattice file: 'hwffd_lattice' is not 1, the version that this program reads");
  }
  const bool shaped = object.contains("shape");
  if (shaped) {
    check_names(object, {"hwffd_lattice", "dims", "shape", "origin", "edges", "inner", "family"});
    return {read_shape(object, read_dims(object)), std::nullopt, read_family(object)};
  }
  check_names(object, {"hwffd_lattice", "order", "dims", "points", "rest", "family"});
  if (object.contains("order") && object["order"] != kOrder) {
    throw Error(
        fmt::format("lattice file: another 'order' of the points; sort them so that {}", kOrder));
  }
  const Index3 dims = read_dims(object);
  Lattice lattice(dims,
                  read_points(entry(object, "points", "[[x, y, z], ...], or a 'shape'"), "points"));
  return {std::move(lattice), read_rest(object, dims), read_family(object)};
}

Lattice parse_lattice(const std::string& text) { return parse_lattice_file(text).lattice; }

LatticeFile read_lattice_file(const std::filesystem::path& path) {
  const std::string text = read_file(path, kMostBytes);
  try {
    return parse_lattice_file(text);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
}

LatticeFile read_lattice_file(const std::filesystem::path& path,
                              const std::optional<Family>& wanted) {
  LatticeFile file = read_lattice_file(path);
  file.family = wanted ? *wanted : file.family.value_or(Family());
  try {
    whole_dims(file.lattice.dims(), *file.family);
  } catch (const Error& error) {
    throw Error(fmt::format("{}: {}", path.string(), error.what()));
  }
  return file;
}

std::string lattice_text(const LatticeFile& file) {
  const Index3& dims = file.lattice.dims();
  std::string text =
      fmt::format("{{\n\"hwffd_lattice\": {},\n\"order\": \"{}\",\n\"dims\": [{}, {}, {}],\n",
                  kVersion, kOrder, dims[0], dims[1], dims[2]);
  if (file.family && file.family->kind() != Family().kind()) {
    text += fmt::format("\"family\": \"{}\",\n", file.family->name());
  }
  if (file.rest && file.rest->points() != file.lattice.points()) {
    text += fmt::format("\"rest\": {},\n", points_text(*file.rest));
  }
  return text + fmt::format("\"points\": {}\n}}\n", points_text(file.lattice));
}

std::string lattice_text(const Lattice& lattice) {
  return lattice_text(LatticeFile{lattice, std::nullopt, std::nullopt});
}

void write_lattice(const std::filesystem::path& path, const LatticeFile& file) {
  write_files({{path, lattice_text(file)}});
}

void write_lattice(const std::filesystem::path& path, const Lattice& lattice) {
  write_lattice(path, LatticeFile{lattice, std::nullopt, std::nullopt});
}

}  // namespace hwffd
