#include "mesh/gltf/accessor_edit.hpp"

#include <algorithm>

#include "hwffd/error.hpp"

namespace hwffd::gltf {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kAlignment = 4;  // of elements of attributes (section 3.6.2.4)
constexpr int kVertices = 34962;       // target of a view
constexpr int kIndices = 34963;

std::size_t aligned(std::size_t size) { return (size + kAlignment - 1) / kAlignment * kAlignment; }

/// Smallest and largest of each component, as JSON has them.
struct Bounds {
  std::vector<std::string> low;
  std::vector<std::string> high;
};

Bounds bounds_of(const std::string& elements, const Accessor& accessor) {
  Accessor raw = accessor;  // bounds of normalized integers are those integers
  raw.is_normalized = false;
  Bounds bounds;
  for (std::size_t c = 0; c < accessor.components; ++c) {
    const char* low = elements.data() + c * size_of(accessor.type);
    const char* high = low;
    for (std::size_t at = 0; at < elements.size(); at += accessor.size) {
      const char* value = elements.data() + at + c * size_of(accessor.type);
      if (decoded(value, raw) < decoded(low, raw)) low = value;
      if (decoded(value, raw) > decoded(high, raw)) high = value;
    }
    bounds.low.push_back(json_number(low, accessor.type));
    bounds.high.push_back(json_number(high, accessor.type));
  }
  return bounds;
}

Json json_of(const std::vector<std::string>& numbers) {
  Json list = Json::array();
  for (const std::string& number : numbers) list.push_back(Json::parse(number));
  return list;
}

}  // namespace

AccessorEdit::AccessorEdit(const File& file, const std::vector<Accessor>& accessors)
    : file_(file), accessors_(accessors), variants_(accessors.size()) {
  find_ranges();
}

void AccessorEdit::add_range(const Place& place, std::size_t count, std::size_t size) {
  if (count == 0 || size == 0) return;
  const std::size_t end = place.offset + (count - 1) * place.stride + size;
  ranges_[place.buffer].push_back({place.offset, end, place.stride, size, end});
}

void AccessorEdit::find_ranges() {
  for (const Accessor& accessor : accessors_) {
    if (accessor.place) add_range(*accessor.place, accessor.count, accessor.size);
    if (!accessor.sparse) continue;
    const Accessor::Sparse& sparse = *accessor.sparse;
    add_range(sparse.indices, sparse.count, size_of(sparse.type));
    add_range(sparse.values, sparse.count, accessor.size);
  }
  const std::vector<JsonItem> views = file_.root().list("bufferViews", "bufferView");
  for (const JsonItem& image : file_.root().list("images", "image")) {
    const auto number = image.index("bufferView", views.size());
    if (!number) continue;
    const JsonItem& view = views[*number];
    const std::size_t length = view.whole("byteLength");
    add_range({view.whole("buffer"), view.whole("byteOffset", 0), length}, 1, length);
  }
  for (auto& [buffer, ranges] : ranges_) {
    std::sort(ranges.begin(), ranges.end(),
              [](const Range& a, const Range& b) { return a.begin < b.begin; });
    for (std::size_t i = 1; i < ranges.size(); ++i) {
      ranges[i].most_end = std::max(ranges[i].most_end, ranges[i - 1].most_end);
    }
  }
}

/// Whether none of its bytes belongs to another accessor, a sparse one's values or a picture.
bool AccessorEdit::is_alone(const Accessor& accessor) const {
  const Place& place = *accessor.place;
  const std::size_t end = place.offset + (accessor.count - 1) * place.stride + accessor.size;
  const std::vector<Range>& ranges = ranges_.at(place.buffer);
  auto next = std::lower_bound(ranges.begin(), ranges.end(), end,
                               [](const Range& r, std::size_t at) { return r.begin < at; });
  std::size_t same = 0;
  while (next != ranges.begin()) {
    --next;
    if (next->most_end <= place.offset) break;
    if (next->end <= place.offset) continue;
    const std::size_t distance =
        next->begin > place.offset ? next->begin - place.offset : place.offset - next->begin;
    const std::size_t before = next->begin > place.offset ? accessor.size : next->size;
    const std::size_t behind = next->begin > place.offset ? next->size : accessor.size;
    const std::size_t step = distance % place.stride;
    const bool is_between = next->stride == place.stride && step >= before &&
                            place.stride - step >= behind;  // interleaved
    if (!is_between) ++same;
  }
  return same <= 1;  // itself
}

std::string& AccessorEdit::buffer(std::size_t number) {
  return buffers_.emplace(number, file_.buffers()[number].bytes).first->second;
}

std::string AccessorEdit::elements_of(std::size_t number) const {
  const Accessor& accessor = accessors_[number];
  std::string elements;
  elements.reserve(accessor.count * accessor.size);
  if (accessor.place && !accessor.sparse) {
    const Place& place = *accessor.place;
    const std::string_view bytes = file_.buffers()[place.buffer].bytes;
    for (std::size_t i = 0; i < accessor.count; ++i) {
      elements += bytes.substr(place.offset + i * place.stride, accessor.size);
    }
    return elements;
  }
  for (const double value : values_of(file_, accessor)) elements += encoded(value, accessor);
  return elements;
}

void AccessorEdit::hold(std::size_t accessor) {
  if (variants_[accessor].empty()) variants_[accessor].push_back({{}, accessor});
}

std::size_t AccessorEdit::with(std::size_t number, Elements elements) {
  const Accessor& accessor = accessors_[number];
  std::vector<Variant>& variants = variants_[number];
  for (const Variant& variant : variants) {
    if (variant.elements == elements) return variant.number;
  }
  const bool is_first = variants.empty();
  variants.push_back({elements, number});
  if (is_first && !elements) return number;
  if (is_first && accessor.place && !accessor.sparse && is_alone(accessor)) {
    overwrite(number, *elements);
  } else {
    variants.back().number = append(file_.json()["accessors"][number], accessor,
                                    elements ? *elements : elements_of(number), accessor.count,
                                    accessor.components == 1);
  }
  return variants.back().number;
}

void AccessorEdit::overwrite(std::size_t number, const std::string& elements) {
  const Accessor& accessor = accessors_[number];
  const Place& place = *accessor.place;
  std::string& bytes = buffer(place.buffer);
  for (std::size_t i = 0; i < accessor.count; ++i) {
    bytes.replace(place.offset + i * place.stride, accessor.size, elements, i * accessor.size,
                  accessor.size);
  }
  overwritten_.emplace(number, elements);
}

std::size_t AccessorEdit::append(Json object, const Accessor& like, const std::string& elements,
                                 std::size_t count, bool is_index) {
  const std::size_t number = accessors_.size() + new_accessors_.size();
  if (file_.buffers().empty()) {
    throw Error("it has no buffer for what has moved; give its positions a buffer");
  }
  const std::size_t home = like.place    ? like.place->buffer
                           : like.sparse ? like.sparse->values.buffer
                                         : 0;
  std::string& bytes = buffer(home);
  bytes.resize(aligned(bytes.size()));
  const std::size_t stride = is_index ? like.size : aligned(like.size);
  Json view{{"buffer", home},
            {"byteOffset", bytes.size()},
            {"byteLength", stride * count},
            {"target", is_index ? kIndices : kVertices}};
  if (stride != like.size) view["byteStride"] = stride;
  for (std::size_t i = 0; i < count; ++i) {
    bytes.append(elements, i * like.size, like.size);
    bytes.append(stride - like.size, '\0');
  }
  object.erase("sparse");
  object.erase("byteOffset");
  object["bufferView"] =
      file_.json().value("bufferViews", Json::array()).size() + new_views_.size();
  object["count"] = count;
  if (object.contains("min") || object.contains("max")) {
    const Bounds bounds = bounds_of(elements, like);
    object["min"] = json_of(bounds.low);
    object["max"] = json_of(bounds.high);
  }
  new_views_.push_back(view.dump());
  new_accessors_.push_back(object.dump());
  return number;
}

std::size_t AccessorEdit::indices(const std::vector<std::uint32_t>& indices, std::size_t like) {
  Accessor accessor = accessors_[like];
  constexpr std::uint32_t kRestart = 65535;  // would restart a strip (section 3.7.2.1)
  const bool is_short = std::all_of(indices.begin(), indices.end(),
                                    [](std::uint32_t index) { return index < kRestart; });
  accessor.type = is_short ? ComponentType::kUnsignedShort : ComponentType::kUnsignedInt;
  accessor.components = 1;
  accessor.size = size_of(accessor.type);
  accessor.is_normalized = false;
  std::string elements;
  for (const std::uint32_t index : indices) elements += encoded(index, accessor);
  const auto [known, is_new] = lists_.emplace(elements, 0);
  if (is_new) {
    const Json object{{"componentType", static_cast<int>(accessor.type)}, {"type", "SCALAR"}};
    known->second = append(object, accessor, elements, indices.size(), true);
  }
  return known->second;
}

void AccessorEdit::put_bounds(JsonText& json, JsonText::Span accessor, std::size_t number) const {
  const JsonText::Members members = json.members(accessor);
  const Bounds bounds = bounds_of(overwritten_.at(number), accessors_[number]);
  for (const auto& [name, numbers] :
       {std::pair{"min", &bounds.low}, std::pair{"max", &bounds.high}}) {
    const auto member = members.find(name);
    if (member == members.end()) continue;
    const std::vector<JsonText::Span> items = json.items(member->second);
    if (items.size() != numbers->size()) continue;
    for (std::size_t c = 0; c < items.size(); ++c) {
      const Json before = Json::parse(json.at(items[c]));
      if (!before.is_number()) continue;
      const Json after = Json::parse((*numbers)[c]);
      const bool is_same = accessors_[number].type == ComponentType::kFloat
                               ? before.get<float>() == after.get<float>()
                               : before == after;
      if (!is_same) json.replace(items[c], (*numbers)[c]);
    }
  }
}

void AccessorEdit::put_into(JsonText& json) const {
  const JsonText::Members root = json.members(json.root());
  const auto add = [&](const char* name, const std::vector<std::string>& items) {
    if (items.empty()) return;
    if (root.count(name) != 0) {
      json.add_items(root.at(name), items);
      return;
    }
    std::string list;
    for (const std::string& item : items) list += (list.empty() ? "" : ",") + item;
    json.add_member(json.root(), name, "[" + list + "]");
  };
  if (!overwritten_.empty()) {
    const std::vector<JsonText::Span> items = json.items(root.at("accessors"));
    for (const auto& [number, elements] : overwritten_) put_bounds(json, items[number], number);
  }
  add("bufferViews", new_views_);
  add("accessors", new_accessors_);
}

}  // namespace hwffd::gltf
