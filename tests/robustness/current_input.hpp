#pragma once

#include <string>

namespace hwffd {

/// While it lives, a program that is ended by a sanitizer, by a crash, or after 20 seconds, prints
/// a text that says what it was doing. One at a time.
class CurrentInput {
 public:
  explicit CurrentInput(const std::string& text);
  CurrentInput(const CurrentInput&) = delete;
  CurrentInput& operator=(const CurrentInput&) = delete;
  ~CurrentInput();
};

}  // namespace hwffd
