#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace hwffd {

/// A text from outside, fit to be quoted in the one line of an error: printable ASCII, other bytes
/// as \\xNN, and no longer than `limit` characters; "..." stands for what was cut from its end.
/// @param limit at least 8
std::string excerpt(std::string_view text, std::size_t limit = 60);

/// The text with control characters, such as the newline in a file's name, as \\xNN: a message
/// stays one line. Everything else stays, whatever its encoding.
std::string one_line(std::string_view text);

}  // namespace hwffd
