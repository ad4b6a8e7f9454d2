#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesh/gltf/accessors.hpp"
#include "mesh/gltf/json_text.hpp"

namespace hwffd::gltf {

/// Bytes of all elements of an accessor, one behind the other without gaps; none: those that were
/// read.
using Elements = std::optional<std::string>;

/// The accessors of a file while their elements change.
class AccessorEdit {
 public:
  AccessorEdit(const File& file, const std::vector<Accessor>& accessors);

  /// The elements as they were read.
  std::string elements_of(std::size_t accessor) const;

  /// What uses the accessor and does not move.
  void hold(std::size_t accessor);

  /// The number of an accessor with these elements: the same one if nobody needs it as it was, or
  /// one of the same kind that is appended.
  /// @param count  of elements
  std::size_t with(std::size_t accessor, Elements elements);

  /// The number of an appended accessor of indices.
  /// @param like  an accessor in whose buffer they go
  std::size_t indices(const std::vector<std::uint32_t>& indices, std::size_t like);

  /// Puts changes of accessors and views into the JSON.
  void put_into(JsonText& json) const;
  /// The buffers that have changed.
  const std::map<std::size_t, std::string>& buffers() const { return buffers_; }

 private:
  struct Variant {
    Elements elements;
    std::size_t number;
  };
  struct Range {
    std::size_t begin;
    std::size_t end;
    std::size_t stride;
    std::size_t size;
    std::size_t most_end;  ///< of this range and those before it
  };

  void find_ranges();
  void add_range(const Place& place, std::size_t count, std::size_t size);
  bool is_alone(const Accessor& accessor) const;
  std::string& buffer(std::size_t number);
  void overwrite(std::size_t accessor, const std::string& elements);
  std::size_t append(nlohmann::json object, const Accessor& like, const std::string& elements,
                     std::size_t count, bool is_index);
  void put_bounds(JsonText& json, JsonText::Span accessor, std::size_t number) const;

  const File& file_;
  const std::vector<Accessor>& accessors_;
  std::vector<std::vector<Variant>> variants_;        ///< of each accessor of the file
  std::map<std::size_t, std::vector<Range>> ranges_;  ///< of each buffer, by begin
  std::map<std::size_t, std::string> buffers_;
  std::map<std::size_t, std::string> overwritten_;  ///< accessor -> its elements
  std::map<std::string, std::size_t> lists_;        ///< of indices that were appended
  std::vector<std::string> new_accessors_;
  std::vector<std::string> new_views_;
};

}  // namespace hwffd::gltf
