#include "mesh/gltf/accessors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>

#include "hwffd/error.hpp"
#include "hwffd/excerpt.hpp"

namespace hwffd::gltf {
namespace {

struct Shape {
  std::size_t rows;
  std::size_t columns;
};

/// Data whose numbers are in little-endian order, as those of glTF are; so is this machine.
template <typename T>
T number_at(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof(T));
  return value;
}

/// Calls f with a zero of the type.
template <typename F>
auto with_type(ComponentType type, F f) {
  switch (type) {
    case ComponentType::kByte:
      return f(std::int8_t{0});
    case ComponentType::kUnsignedByte:
      return f(std::uint8_t{0});
    case ComponentType::kShort:
      return f(std::int16_t{0});
    case ComponentType::kUnsignedShort:
      return f(std::uint16_t{0});
    case ComponentType::kUnsignedInt:
      return f(std::uint32_t{0});
    case ComponentType::kFloat:
      break;
  }
  return f(0.0f);
}

/// What 1 is stored as; 1 for what is not normalized (section 3.6.2.2, "max(c / 127.0, -1.0)").
template <typename T>
double scale_of(bool is_normalized) {
  if (!is_normalized || std::is_floating_point_v<T>) return 1;
  return static_cast<double>(std::numeric_limits<T>::max());
}

double value_at(const char* bytes, ComponentType type, bool is_normalized) {
  return with_type(type, [&](auto zero) {
    using T = decltype(zero);
    const auto value = static_cast<double>(number_at<T>(bytes));
    return is_normalized ? std::max(value / scale_of<T>(true), -1.0) : value;
  });
}

ComponentType type_of(const JsonItem& item) {
  const std::size_t type = item.whole("componentType");
  for (const ComponentType known :
       {ComponentType::kByte, ComponentType::kUnsignedByte, ComponentType::kShort,
        ComponentType::kUnsignedShort, ComponentType::kUnsignedInt, ComponentType::kFloat}) {
    if (static_cast<std::size_t>(known) == type) return known;
  }
  item.fail(fmt::format("has a componentType that glTF does not know, {}", type));
}

Shape shape_of(const JsonItem& item) {
  static const std::map<std::string, Shape> kShapes{
      {"SCALAR", {1, 1}}, {"VEC2", {2, 1}}, {"VEC3", {3, 1}}, {"VEC4", {4, 1}},
      {"MAT2", {2, 2}},   {"MAT3", {3, 3}}, {"MAT4", {4, 4}}};
  const std::string name = item.text("type", "");
  const auto shape = kShapes.find(name);
  if (shape == kShapes.end()) {
    item.fail(fmt::format("has a type that glTF does not know, '{}'", excerpt(name, 20)));
  }
  return shape->second;
}

/// Columns of a matrix begin at multiples of four bytes (section 3.6.2.4).
std::size_t element_size(Shape shape, ComponentType type) {
  const std::size_t column = shape.rows * size_of(type);
  return shape.columns == 1 ? column : shape.columns * ((column + 3) / 4 * 4);
}

class AccessorReader {
 public:
  explicit AccessorReader(const File& file)
      : file_(file), views_(file.root().list("bufferViews", "bufferView")) {}

  Accessor read(const JsonItem& item) const {
    Accessor accessor{};
    accessor.count = item.whole("count");
    accessor.type = type_of(item);
    const Shape shape = shape_of(item);
    accessor.components = shape.rows * shape.columns;
    accessor.size = element_size(shape, accessor.type);
    accessor.is_normalized = item.truth("normalized") && accessor.type != ComponentType::kFloat;
    if (item.has("bufferView")) accessor.place = place_of(item, accessor.count, accessor.size);
    if (item.has("sparse")) {
      const JsonItem sparse = item.object("sparse");
      const JsonItem indices = sparse.object("indices");
      const std::size_t count = sparse.whole("count");
      const ComponentType type = type_of(indices);
      accessor.sparse = {count, type, place_of(indices, count, size_of(type)),
                         place_of(sparse.object("values"), count, accessor.size)};
    }
    return accessor;
  }

 private:
  Place place_of(const JsonItem& item, std::size_t count, std::size_t size) const {
    const std::optional<std::size_t> number = item.index("bufferView", views_.size());
    if (!number) item.fail("has no bufferView");
    const JsonItem& view = views_[*number];
    if (!view.has("buffer")) view.fail("has no buffer");
    const std::size_t buffer = *view.index("buffer", file_.buffers().size());
    const std::size_t begin = view.whole("byteOffset", 0);
    const std::size_t length = view.whole("byteLength");
    const std::size_t all = file_.buffers()[buffer].bytes.size();
    if (begin > all || length > all - begin) {
      view.fail(fmt::format("ends behind the {} bytes of buffer {}", all, buffer));
    }
    const std::size_t offset = item.whole("byteOffset", 0);
    std::size_t stride = view.whole("byteStride", 0);
    if (stride == 0) stride = size;
    if (stride < size && count > 1) {
      view.fail(fmt::format("its byteStride is {}, its elements have {} bytes", stride, size));
    }
    const bool fits =
        count == 0 || (offset <= length && size <= length - offset &&
                       (count - 1) <= (length - offset - size) / std::max<std::size_t>(stride, 1));
    if (!fits) item.fail(fmt::format("ends behind the {} bytes of its bufferView", length));
    return {buffer, begin + offset, stride};
  }

  const File& file_;
  std::vector<JsonItem> views_;
};

}  // namespace

std::size_t size_of(ComponentType type) {
  return with_type(type, [](auto zero) { return sizeof(zero); });
}

std::vector<Accessor> read_accessors(const File& file) {
  const AccessorReader reader(file);
  std::vector<Accessor> accessors;
  for (const JsonItem& item : file.root().list("accessors", "accessor")) {
    accessors.push_back(reader.read(item));
  }
  return accessors;
}

std::vector<double> values_of(const File& file, const Accessor& accessor) {
  std::vector<double> values(accessor.count * accessor.components, 0.0);
  const auto read = [&](const Place& place, std::size_t element, std::size_t to) {
    const char* bytes =
        file.buffers()[place.buffer].bytes.data() + place.offset + element * place.stride;
    for (std::size_t c = 0; c < accessor.components; ++c) {
      values[to * accessor.components + c] =
          value_at(bytes + c * size_of(accessor.type), accessor.type, accessor.is_normalized);
    }
  };
  for (std::size_t i = 0; accessor.place && i < accessor.count; ++i) read(*accessor.place, i, i);
  if (!accessor.sparse) return values;
  const Accessor::Sparse& sparse = *accessor.sparse;
  const std::string_view indices = file.buffers()[sparse.indices.buffer].bytes;
  for (std::size_t i = 0; i < sparse.count; ++i) {
    const char* at = indices.data() + sparse.indices.offset + i * sparse.indices.stride;
    const double index = value_at(at, sparse.type, false);
    if (!(index >= 0 && index < static_cast<double>(accessor.count))) {
      throw Error(fmt::format("a sparse accessor replaces element {} of {}; repair the file", index,
                              accessor.count));
    }
    read(sparse.values, i, static_cast<std::size_t>(index));
  }
  return values;
}

std::vector<std::uint32_t> integers_of(const File& file, const Accessor& accessor) {
  constexpr std::uint32_t kBeyond = std::numeric_limits<std::uint32_t>::max();  // all vertices
  const auto integer_of = [](double value) {
    return value >= 0 && value < kBeyond ? static_cast<std::uint32_t>(value) : kBeyond;
  };
  std::vector<std::uint32_t> integers(accessor.count);
  if (accessor.place && !accessor.sparse) {  // most: without a list of doubles
    const Place& place = *accessor.place;
    const char* const bytes = file.buffers()[place.buffer].bytes.data() + place.offset;
    for (std::size_t i = 0; i < integers.size(); ++i) {
      integers[i] = integer_of(value_at(bytes + i * place.stride, accessor.type, false));
    }
  } else {
    const std::vector<double> values = values_of(file, accessor);
    std::transform(values.begin(), values.end(), integers.begin(), integer_of);
  }
  return integers;
}

double decoded(const char* bytes, const Accessor& accessor) {
  return value_at(bytes, accessor.type, accessor.is_normalized);
}

std::string encoded(double value, const Accessor& accessor) {
  return with_type(accessor.type, [&](auto zero) {
    using T = decltype(zero);
    std::string bytes;
    const double scaled = value * scale_of<T>(accessor.is_normalized);
    const double stored = std::is_floating_point_v<T> ? scaled : std::round(scaled);
    const bool fits = stored >= static_cast<double>(std::numeric_limits<T>::lowest()) &&
                      stored <= static_cast<double>(std::numeric_limits<T>::max());
    if (!fits) return bytes;
    const T number = static_cast<T>(stored);
    bytes.assign(reinterpret_cast<const char*>(&number), sizeof(T));
    return bytes;
  });
}

std::string json_number(const char* bytes, ComponentType type) {
  return with_type(type,
                   [&](auto zero) { return fmt::format("{}", number_at<decltype(zero)>(bytes)); });
}

}  // namespace hwffd::gltf
