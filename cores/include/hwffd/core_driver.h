#pragma once

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @file
 * The programming sequence of docs/registers.md section 4 in C, for a processor without an
 * operating system: no heap, no library, no state but that of a struct. `hwffd::Driver` is the same
 * in C++.
 *
 *     struct hwffd_core core = {0};
 *     core.port = ...;
 *     if (hwffd_core_probe(&core) != HWFFD_CORE_OK) ...
 *     hwffd_core_set_windows(&core, read_base, read_limit, write_base, write_limit);
 *     hwffd_core_lock_windows(&core);
 *     hwffd_core_set_ring(&core, ring, log2_size);
 *     hwffd_core_set_results(&core, results, bytes);  // from here on once a run
 *     hwffd_core_descriptor(&core, entry, packet, bytes, 0);  // of each packet
 *     hwffd_core_push(&core, packets);
 *     hwffd_core_start(&core);
 *     hwffd_core_wait_done(&core, polls);  // or the interrupt, and then the same
 *     hwffd_core_take_errors(&core, &errors);
 *
 * After an error that the DMA raised: hwffd_core_soft_reset, then from hwffd_core_set_ring on.
 */

/** What went wrong; hwffd_core_text() says it in a line. */
enum hwffd_core_status {
  HWFFD_CORE_OK = 0,
  HWFFD_CORE_BUS_ERROR,     /**< the bus answered an access to a register with an error */
  HWFFD_CORE_ABSENT,        /**< ID is another */
  HWFFD_CORE_OTHER_VERSION, /**< VERSION.major is another */
  HWFFD_CORE_NOT_PROBED,
  HWFFD_CORE_WINDOW,    /**< a window's base is above its limit */
  HWFFD_CORE_LOCKED,    /**< the windows are locked until reset */
  HWFFD_CORE_RING_SIZE, /**< a ring of one descriptor, or of more than 2^15 */
  HWFFD_CORE_RING_BASE, /**< the ring's base is no multiple of its size */
  HWFFD_CORE_RING_USED, /**< another ring is in use: soft reset first */
  HWFFD_CORE_RING_FULL, /**< no room for so many descriptors */
  HWFFD_CORE_AREA,      /**< an address or a size is no multiple of 16, or the size is 0 */
  HWFFD_CORE_NO_MARKS,  /**< this core has no interrupts of descriptors */
  HWFFD_CORE_UNLOCKED,  /**< start refused: lock the windows first */
  HWFFD_CORE_STOPPED,   /**< start refused: a bus error stopped the DMA */
  HWFFD_CORE_BUSY,      /**< start refused: busy */
  HWFFD_CORE_LATE       /**< it does not end */
};

/** A line for people, without a newline. */
const char* hwffd_core_text(enum hwffd_core_status status);

/** The way to the registers. Offsets are bytes (hwffd/registers.h). Both return 0 where the bus
 * answered well. What was written to memory before write32 must be there for the core's DMA when
 * the write arrives. */
struct hwffd_core_port {
  void* context;
  int (*read32)(void* context, uint32_t offset, uint32_t* value);
  int (*write32)(void* context, uint32_t offset, uint32_t value);
};

/** What was built: VERSION, CONFIG, LIMITS, FEATURES and LIMITS2. */
struct hwffd_core_identity {
  unsigned version_major, version_minor, version_patch;
  unsigned org;         /**< number in rtl/organizations.csv */
  unsigned n;           /**< units of a step */
  unsigned format;      /**< 0 fp32, W fxW, 99 bfp32 */
  unsigned schedule;    /**< 0 overlapped, 1 paper */
  unsigned evaluator;   /**< 0 pipelined, 1 iterative, 3 powers */
  unsigned in_flight;   /**< most evaluations at once */
  unsigned points_axis; /**< of the resident lattice; 0: none */
  unsigned grid_limit;  /**< a grid has 2^grid_limit vertices at most; 0 without grids */
  uint32_t features;    /**< HWFFD_FEATURES_*_MASK */
  unsigned pages;       /**< of points, the two buffers of opcode 2 among them; 0: none */
  unsigned spans;       /**< of an axis, each with functions of its own */
  unsigned count_width; /**< bits of the counts of waits, 8 to 32; 0: there are none */
};

/** A core. The port is the caller's to fill in, the rest is 0 at first and the driver's then. */
struct hwffd_core {
  struct hwffd_core_port port;
  struct hwffd_core_identity identity; /**< since a probe that went well */
  int probed;
  unsigned ring_size; /**< a power of two; 0 and 1 have no room */
};

/** The errors so far, and the first of them. */
struct hwffd_core_errors {
  uint32_t status;     /**< a bit a code, HWFFD_ERROR_STATUS_*_MASK */
  uint32_t count;      /**< since it was last cleared */
  int recorded;        /**< whether the four below are there */
  unsigned first_code; /**< bit of ERROR_STATUS */
  uint32_t first_packet;
  uint32_t first_beat;
  uint64_t first_address; /**< of the first error of the DMA since then; 0: there was none */
};

/** Step 1. HWFFD_CORE_ABSENT and HWFFD_CORE_OTHER_VERSION say what is not there; the identity then
 * has the version that was read. */
enum hwffd_core_status hwffd_core_probe(struct hwffd_core* core);

/** Step 2: first and last address of what the DMA may read, and of what it may write. */
enum hwffd_core_status hwffd_core_set_windows(struct hwffd_core* core, uint64_t read_base,
                                              uint64_t read_limit, uint64_t write_base,
                                              uint64_t write_limit);
/** For good, until aresetn. Nothing starts before. */
enum hwffd_core_status hwffd_core_lock_windows(struct hwffd_core* core);
enum hwffd_core_status hwffd_core_windows_locked(struct hwffd_core* core, int* locked);

/** Step 3: an empty ring of 2^log2_size descriptors of 16 bytes, 2 to 2^15. */
enum hwffd_core_status hwffd_core_set_ring(struct hwffd_core* core, uint64_t base,
                                           unsigned log2_size);

/** Step 4. The next start takes it. */
enum hwffd_core_status hwffd_core_set_results(struct hwffd_core* core, uint64_t base,
                                              uint32_t bytes);

/** The descriptor of a packet, four words as they stand in memory.
 * @param interrupt  not 0: IRQ_STATE.descriptor is set when the packet has been read */
enum hwffd_core_status hwffd_core_descriptor(const struct hwffd_core* core, uint32_t descriptor[4],
                                             uint64_t address, uint32_t bytes, int interrupt);
/** Index of the next descriptor in the ring. */
enum hwffd_core_status hwffd_core_next_entry(struct hwffd_core* core, unsigned* entry);
/** Descriptors in the ring that are not done. */
enum hwffd_core_status hwffd_core_pending(struct hwffd_core* core, unsigned* pending);
/** Step 5: that many more descriptors are in the ring; they must be in memory by now. */
enum hwffd_core_status hwffd_core_push(struct hwffd_core* core, unsigned descriptors);

/** Steps 4 and 6: clears what is left of the last start, interrupts too, then starts. */
enum hwffd_core_status hwffd_core_start(struct hwffd_core* core);
/** Step 7: reads STATUS until it is done, `polls` times at most; else HWFFD_CORE_LATE. */
enum hwffd_core_status hwffd_core_wait_done(struct hwffd_core* core, uint64_t polls);
/** Results in memory since the last start. */
enum hwffd_core_status hwffd_core_result_count(struct hwffd_core* core, uint32_t* count);
/** Whether a bus error or a time-out of the bus stopped the DMA: only a soft reset helps. */
enum hwffd_core_status hwffd_core_stopped(struct hwffd_core* core, int* stopped);

/** Step 8: the errors so far, which are cleared; ERROR_COUNT is not. */
enum hwffd_core_status hwffd_core_take_errors(struct hwffd_core* core,
                                              struct hwffd_core_errors* errors);

/** Step 9; the ring is empty then, and has to be set again. HWFFD_CORE_LATE: still not idle after
 * reading STATUS `polls` times. */
enum hwffd_core_status hwffd_core_soft_reset(struct hwffd_core* core, uint64_t polls);
/** Step 10. */
enum hwffd_core_status hwffd_core_stop_grid(struct hwffd_core* core);

/** @param bits  HWFFD_IRQ_ENABLE_*_MASK; what is not among them is disabled */
enum hwffd_core_status hwffd_core_enable_interrupts(struct hwffd_core* core, uint32_t bits);
/** What is set in IRQ_STATE, which is cleared. */
enum hwffd_core_status hwffd_core_take_interrupts(struct hwffd_core* core, uint32_t* bits);

#ifdef __cplusplus
}
#endif
