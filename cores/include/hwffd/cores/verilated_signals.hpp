#pragma once

#include <verilated.h>
#include <verilated_syms.h>

#include <algorithm>
#include <string>
#include <vector>

#include "hwffd/cores/signal.hpp"

namespace hwffd::cores {

/// Bytes in which a model keeps a word of so many bits.
inline int storage_of(int width) {
  return width <= 8    ? 1
         : width <= 16 ? 2
         : width <= 32 ? 4
         : width <= 64 ? 8
                       : (width + 31) / 32 * 4;
}

/// The visible signals of the model of a context, by instance, then by name; no memories. (All
/// processors that run this keep the lowest byte first.)
inline std::vector<Signal> visible_signals(VerilatedContext& context) {
  std::vector<Signal> signals;
  for (const auto& [instance, scope] : *context.scopeNameMap()) {
    if (scope->varsp() == nullptr) continue;
    for (const auto& [name, variable] : *scope->varsp()) {
      if (variable.udims() != 0) continue;
      const int width = std::max(variable.packed().elements(), 1);
      signals.push_back({instance, name, width, storage_of(width), variable.datap()});
    }
  }
  return signals;
}

}  // namespace hwffd::cores
