#include "refusals.h"

#include <stdio.h>
#include <string.h>

#include "hwffd/registers.h"

bool wait_interrupt(uint32_t most) {
  const uint64_t until = clocks() + most;
  while (!interrupted()) {
    if (clocks() < until) continue;
    printf("soc: interrupt: none came in %lu clocks\n", (unsigned long)most);
    return false;
  }
  return true;
}

// Registers in memory that answer as a core does, with this identification and this version.
static bool refuses(uint32_t id, uint32_t version, enum hwffd_core_status wanted) {
  static uint32_t registers[16];
  struct hwffd_core core;
  memset(&core, 0, sizeof core);
  core.port = memory_port(registers);
  registers[HWFFD_ID_OFFSET / 4] = id;
  registers[HWFFD_VERSION_OFFSET / 4] = version;
  const enum hwffd_core_status status = hwffd_core_probe(&core);
  return !well(status, "core") && status == wanted;
}

uint32_t count_refusals(struct runs* runs) {
  static struct runs other;
  uint32_t refused = 0;
  refused += refuses(HWFFD_ID_RESET + 1, 0, HWFFD_CORE_ABSENT);
  refused += refuses(HWFFD_ID_RESET, (HWFFD_VERSION_MAJOR_RESET + 1U) << HWFFD_VERSION_MAJOR_SHIFT,
                     HWFFD_CORE_OTHER_VERSION);
  const uint32_t less = memory_wanted(&runs->scene) - BEAT_BYTES;
  refused += !open_runs(&other, core_port(), memory_start, memory_start + less / 4);
  // A run that ends without an interrupt, because none is enabled.
  allow_interrupt(true);
  refused += well(hwffd_core_enable_interrupts(&runs->core, 0), "interrupt") && start(runs, 1) &&
             !wait_interrupt(10000);
  allow_interrupt(false);
  return refused;
}
