#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hwffd/tb/random.hpp"

namespace hwffd {

/// Makes broken inputs of valid ones: one to four changes to bytes, ranges, numbers, words or
/// nesting. Equal seeds give equal inputs.
class Mutator {
 public:
  /// @param corpus valid inputs, at least one
  Mutator(std::uint64_t seed, const std::vector<std::string>& corpus)
      : random_(seed), corpus_(corpus) {}

  /// The next input; about one in 64 is valid, unchanged.
  std::string next();

 private:
  struct Range {
    std::size_t start;
    std::size_t length;
  };

  void change(std::string& text);
  void change_byte(std::string& text);
  void cut(std::string& text);
  void copy(std::string& text);
  void change_number(std::string& text);
  void swap_words(std::string& text);
  void nest(std::string& text);
  void repeat(std::string& text);
  /// Up to `longest` bytes of the text.
  Range range(const std::string& text, std::size_t longest);

  tb::Random random_;
  const std::vector<std::string>& corpus_;
};

}  // namespace hwffd
