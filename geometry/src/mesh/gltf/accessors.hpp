#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mesh/gltf/file.hpp"

namespace hwffd::gltf {

/// The type of the numbers of an accessor (glTF 2.0, section 3.6.2.2).
enum class ComponentType {
  kByte = 5120,
  kUnsignedByte = 5121,
  kShort = 5122,
  kUnsignedShort = 5123,
  kUnsignedInt = 5125,
  kFloat = 5126,
};

std::size_t size_of(ComponentType type);

/// Where elements stand: each `stride` bytes behind the one before.
struct Place {
  std::size_t buffer;
  std::size_t offset;
  std::size_t stride;
};

/// An accessor, checked: nothing of it lies outside of its buffer.
struct Accessor {
  std::size_t count;
  ComponentType type;
  std::size_t components;      ///< of an element: 1 to 4 of a scalar or vector, 4 to 16 of a matrix
  std::size_t size;            ///< of an element in bytes, with what fills up columns of a matrix
  bool is_normalized;          ///< integers that stand for -1 to 1 or 0 to 1
  std::optional<Place> place;  ///< none: zeros

  /// Elements that take the place of some of those.
  struct Sparse {
    std::size_t count;
    ComponentType type;  ///< of their numbers
    Place indices;       ///< increasing
    Place values;
  };
  std::optional<Sparse> sparse;
};

/// All accessors of a file.
/// @throws Error for one that is broken
std::vector<Accessor> read_accessors(const File& file);

/// All numbers of the elements, one element after the other; of normalized integers what they stand
/// for.
std::vector<double> values_of(const File& file, const Accessor& accessor);

/// Of whole numbers without a sign, one an element.
std::vector<std::uint32_t> integers_of(const File& file, const Accessor& accessor);

/// The number that stands there in the accessor's type.
double decoded(const char* bytes, const Accessor& accessor);

/// A number in the accessor's type.
/// @return no bytes if the type does not hold it
std::string encoded(double value, const Accessor& accessor);

/// The number that stands there as JSON has it in min and max: an integer as it is, a float in the
/// digits that tell it from others (section 3.6.2.5).
std::string json_number(const char* bytes, ComponentType type);

}  // namespace hwffd::gltf
