// Soft resets and errors of the bus in the middle of transfers, and a run with the right bits after
// each.
#pragma once

#include "runs.h"

struct resets {
  uint32_t done;        // tries
  uint32_t by_kind[5];  // of `kinds`
  uint32_t caught;      // tries that met the core at work
  uint32_t hangs;       // the core did not end, or was not idle after a soft reset
  uint32_t silent;      // errors that ERROR_STATUS did not have
  uint32_t results;     // compared afterwards
  uint32_t mismatches;
};

extern const char* const reset_kinds[5];

// Tries them `count` times, in turn, at places and moments by chance. False: it has said why it
// stopped.
bool try_resets(struct runs* runs, uint32_t count, struct resets* resets);
