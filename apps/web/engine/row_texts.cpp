#include "row_texts.hpp"

#include <fmt/format.h>

#include "hwffd/model/organizations.hpp"
#include "hwffd/model/schedule.hpp"
#include "hwffd/stream/word_codec.hpp"

namespace hwffd::web {

std::string title_of(const Configuration& row) {
  const WordCodec codec(row.format);
  if (codec.is_float()) return fmt::format("{}, single precision", row.org);
  return fmt::format("{}, {}-bit {}", row.org,
                     std::string(row.format).substr(codec.is_block() ? 3 : 2),
                     codec.is_block() ? "block floating point" : "fixed point");
}

std::string formula_of(const Configuration& row) {
  const Organization& organization = organization_of(row);
  std::string text = organization.overlapped_text;
  if (text.find("start") != std::string::npos) {
    text += fmt::format(", start = {}", row.evaluator == std::string("iterative") ? 3 : 1);
  }
  return walks(row) ? fmt::format("{} in any order, 1 along rows", text) : text;
}

}  // namespace hwffd::web
