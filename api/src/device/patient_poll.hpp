#pragma once

#include <chrono>

namespace hwffd {

/// As poll() of one file, but that no signal ends it early: above 0 where one of the events has
/// come, or the end of the file, 0 where none has for so long, below 0 with errno.
int patient_poll(int file, short events, std::chrono::milliseconds patience);

}  // namespace hwffd
