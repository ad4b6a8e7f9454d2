#pragma once

#include <cstdint>
#include <memory>
#include <ostream>
#include <string>

#include "hwffd/cores/stream_core.hpp"

namespace hwffd::test {

/// A simulated core of a table of cores, which CMake reads.
struct BuiltCore {
  std::string name;
  std::unique_ptr<cores::StreamCore> (*make)(std::uint64_t seed);
};

inline std::ostream& operator<<(std::ostream& out, const BuiltCore& core) {
  return out << core.name;
}

}  // namespace hwffd::test
