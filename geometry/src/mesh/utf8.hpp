#pragma once

#include <string>
#include <string_view>

namespace hwffd {

/// A name as glTF and XML must have it: UTF-8 as it is, but control characters, which XML has not,
/// become blanks; what is not UTF-8 is taken for Latin-1.
std::string utf8_of(std::string_view name);

}  // namespace hwffd
