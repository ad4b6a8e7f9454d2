#pragma once

#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace hwffd {

/// What work in a child process may use.
struct ChildLimits {
  std::uint64_t bytes;  ///< of memory, beside what the caller has
  unsigned seconds;     ///< of processor time; six times as many may pass on the clock
};

/// The work ended without a result: it crashed, or went beyond its limits. what() is a few words.
class ChildFailure : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs code that may crash or not end, such as other people's readers of files, in a child
/// process, so that it takes only the child down. The child has the caller's memory as it is now;
/// what it changes is lost, only the bytes that it returns come back. Its output is dropped.
/// @throws Error as `work` throws it, ChildFailure if it ends in any other way
std::string run_in_child(const std::function<std::string()>& work, const ChildLimits& limits);

}  // namespace hwffd
