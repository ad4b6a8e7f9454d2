#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace hwffd {

/// A type of numbers in a ply file.
struct PlyType {
  enum class Kind { kSigned, kUnsigned, kFloat };
  Kind kind = Kind::kFloat;
  std::size_t size = 0;  ///< bytes of the binary form
  std::string name;      ///< as the file calls it

  bool is_integer() const { return kind != Kind::kFloat; }
};

/// A number of each row of an element, or a list of them behind their count.
struct PlyProperty {
  std::string name;
  bool is_list = false;
  PlyType count;  ///< of a list
  PlyType value;
};

struct PlyElement {
  std::string name;
  std::uint64_t rows = 0;
  std::vector<PlyProperty> properties;
};

struct PlyHeader {
  enum class Format { kText, kLittle, kBig };
  Format format = Format::kText;
  std::vector<PlyElement> elements;
  struct Texture {
    std::string name;
    std::size_t at = 0;  ///< of the name
  };
  std::vector<Texture> textures;  ///< the files that comments name as such
  std::size_t end = 0;            ///< where the data begin
};

/// @throws Error, without the file's name, for what is no such header
PlyHeader ply_header(const std::string& bytes);

/// Goes over the data, value by value.
class PlyCursor {
 public:
  PlyCursor(const std::string& bytes, const PlyHeader& header);

  /// The bytes of the next value: a word of text, or a number of its size.
  /// @throws Error, without the file's name, where the data end before
  std::string_view take(const PlyType& type);
  /// How many values of a list follow.
  std::uint64_t take_count(const PlyProperty& list);
  /// Passes over the next value, or list of them.
  void skip(const PlyProperty& property);

  /// What the bytes of a value say.
  double number(std::string_view value, const PlyType& type) const;
  /// The bytes of a number.
  /// @throws Error, without the file's name, for what the type does not hold
  std::string bytes_of(double number, const PlyType& type) const;

  bool is_text() const { return format_ == PlyHeader::Format::kText; }

 private:
  std::string_view rest_;
  PlyHeader::Format format_;
};

}  // namespace hwffd
