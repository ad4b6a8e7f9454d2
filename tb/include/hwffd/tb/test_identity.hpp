#pragma once

#include <cstdint>
#include <string>

namespace hwffd::tb {

/// What a report needs to say which run failed and how to repeat it.
struct TestIdentity {
  std::string name;        ///< as ctest knows it
  std::uint64_t seed = 0;  ///< the value of SEED
  std::string replay;      ///< the command; `SEED=<seed> ctest -R '<name>'` when empty
};

/// The command that repeats the run.
inline std::string replay_command(const TestIdentity& test) {
  if (!test.replay.empty()) return test.replay;
  return "SEED=" + std::to_string(test.seed) + " ctest -R '" + test.name + "'";
}

}  // namespace hwffd::tb
