#pragma once

#include <memory>
#include <string>
#include <vector>

#include "samples.hpp"

namespace hwffd::words {

/// One row of the study: a form of eq. (1) in a number format.
class Row {
 public:
  Row(std::string form, std::string format, int word_length)
      : form_(std::move(form)), format_(std::move(format)), word_length_(word_length) {}
  virtual ~Row() = default;

  const std::string& form() const { return form_; }
  const std::string& format() const { return format_; }  ///< e.g. "fx18", "fp32-tree"
  int word_length() const { return word_length_; }
  bool is_fixed() const { return format_.rfind("fx", 0) == 0; }

  /// What the bit-true model makes of a vertex.
  virtual Point evaluate(const Sample& sample) const = 0;
  /// The proved bound of any component's error.
  virtual double bound() const = 0;

 private:
  std::string form_;
  std::string format_;
  int word_length_;
};

using Rows = std::vector<std::unique_ptr<Row>>;

/// Every form in every format: 12 to 32 bits, then binary32 in its four orders of operation.
Rows all_rows();

}  // namespace hwffd::words
