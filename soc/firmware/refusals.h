// What is refused, each with a line and a status.
#pragma once

#include "runs.h"

// How many of them were refused as they should; all are REFUSALS.
enum { REFUSALS = 4 };
uint32_t count_refusals(struct runs* runs);

// Waits for the core's interrupt, so many clocks at most. False: it has said that it did not come.
bool wait_interrupt(uint32_t most);
