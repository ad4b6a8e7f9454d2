#pragma once

#include <functional>
#include <string>
#include <vector>

namespace hwffd::glapi {

/// Commands that one check calls, and whether they did what they should.
struct CallCheck {
  std::vector<std::string> calls;
  std::function<bool()> passes;
};

/// Every command of glffd.h, in a check each or in one with those that it takes to see it work.
/// They need a current context.
std::vector<CallCheck> call_checks();

}  // namespace hwffd::glapi
