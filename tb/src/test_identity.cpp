#include "hwffd/tb/test_identity.hpp"

#include <fmt/format.h>

namespace hwffd::tb {

std::string replay_command(const TestIdentity& test) {
  if (!test.replay.empty()) return test.replay;
  return fmt::format("SEED={} ctest -R '{}'", test.seed, test.name);
}

}  // namespace hwffd::tb
