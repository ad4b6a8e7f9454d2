#include "platform.h"

#include <generated/csr.h>
#include <generated/mem.h>
#include <generated/soc.h>
#include <irq.h>
#include <stdio.h>
#include <system.h>

#include "hwffd/registers.h"

static volatile bool came;

static int put(char letter, FILE* file) {
  (void)file;
  while (uart_txfull_read() != 0) {
  }
  uart_rxtx_write((uint8_t)letter);
  return letter;
}

static FILE console = FDEV_SETUP_STREAM(put, NULL, NULL, _FDEV_SETUP_WRITE);
FILE* const stdout = &console;

uint64_t clocks(void) {
  timer0_uptime_latch_write(1);
  return timer0_uptime_cycles_read();
}

static int read_register(void* context, uint32_t offset, uint32_t* value) {
  *value = *(volatile uint32_t*)((uintptr_t)context + offset);
  return 0;
}

// The cache writes through, so memory has what was written before.
static int write_register(void* context, uint32_t offset, uint32_t value) {
  __asm__ volatile("fence" ::: "memory");
  *(volatile uint32_t*)((uintptr_t)context + offset) = value;
  return 0;
}

struct hwffd_core_port core_port(void) {
  return memory_port((uint32_t*)HWFFD_BASE);
}

struct hwffd_core_port memory_port(uint32_t* registers) {
  const struct hwffd_core_port port = {registers, read_register, write_register};
  return port;
}

void see_memory(void) { flush_cpu_dcache(); }

void allow_interrupt(bool allowed) {
  came = false;
  irq_setmask(allowed ? 1U << HWFFD_INTERRUPT : 0U);
  irq_setie(allowed);
}

bool interrupted(void) { return came; }

// An interrupt of the core stays until its cause is cleared, so it is masked here.
void trap(uint32_t cause, uint32_t place) {
  const uint32_t external = 0x8000000BU;
  if (cause == external && (irq_pending() & 1U << HWFFD_INTERRUPT) != 0) {
    came = true;
    irq_setmask(0);
    return;
  }
  printf("soc: trap %08lx at %08lx\n", (unsigned long)cause, (unsigned long)place);
  printf("status 3\n");
  finish();
}

// Only a simulated system has what follows.
#ifdef CSR_FAULTS_BASE
bool set_fault(enum fault fault, uint32_t address) {
  faults_address_write(address);
  faults_kind_write(fault);
  return true;
}
#else
bool set_fault(enum fault fault, uint32_t address) {
  (void)fault;
  (void)address;
  return false;
}
#endif

void finish(void) {
#ifdef CSR_SIM_FINISH_BASE
  sim_finish_finish_write(1);
#endif
  for (;;) {
  }
}
