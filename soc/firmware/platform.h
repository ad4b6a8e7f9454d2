// What the firmware wants of the system: a console, a clock, one interrupt, and memory as the
// core's DMA sees it.
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "hwffd/core_driver.h"

// Clocks since reset.
uint64_t clocks(void);

// The registers of the core.
struct hwffd_core_port core_port(void);
// Registers that stand in memory, with offsets as those of a core: for what answers as none does.
struct hwffd_core_port memory_port(uint32_t* registers);

// What the DMA has written becomes visible to the processor.
void see_memory(void);

// Whether the core's interrupt may come; its handler then disables it again.
void allow_interrupt(bool allowed);
// Whether it has come since it was allowed.
bool interrupted(void);

// Arms the word at an address: the DMA's access to it is answered with an error, or not at all.
// False: this system cannot.
enum fault { NO_FAULT = 0, FAULT_ERROR = 1, FAULT_SILENCE = 2 };
bool set_fault(enum fault fault, uint32_t address);

// Ends the simulation, and on a board the program.
void finish(void) __attribute__((noreturn));

// The large memory, which the scene is at the start of.
extern uint32_t memory_start[];
extern uint32_t memory_end[];
