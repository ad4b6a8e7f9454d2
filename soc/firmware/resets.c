#include "resets.h"

#include <stdio.h>

#include "hwffd/registers.h"

enum {
  VERTICES = 16,   // of a run
  POLLS = 100000,  // until it is said to hang
  PROGRESS = 50,   // tries between two lines, so that whoever watches knows that it goes on
  LONGEST = 6000   // clocks from a start to a soft reset: about those of a run
};

enum { SOFT_RESET, READ_ERROR, WRITE_ERROR, READ_SILENCE, WRITE_SILENCE };

const char* const reset_kinds[5] = {"soft resets", "errors of reads", "errors of writes",
                                    "reads without an answer", "writes without an answer"};

// Below `below`, by xorshift.
static uint32_t drawn(uint32_t below) {
  static uint32_t state = 2463534242U;
  state ^= state << 13;
  state ^= state >> 17;
  state ^= state << 5;
  return state % below;
}

static bool begin(struct runs* runs, uint32_t first) {
  uint32_t* end = put_vertices(runs, runs->packets, first, VERTICES);
  return send_lattice(runs) &&
         send(runs, runs->packets, (uint32_t)(end - runs->packets) / BEAT_WORDS) &&
         start(runs, VERTICES);
}

// A word that the run will read or write.
static uint32_t* some_word(const struct runs* runs, bool write) {
  const struct scene* scene = &runs->scene;
  if (write) return runs->results + drawn(VERTICES * BEAT_WORDS);
  switch (drawn(4)) {
    case 0:
      return runs->ring + ((runs->entry + drawn(3)) % RING_ENTRIES) * BEAT_WORDS +
             drawn(BEAT_WORDS);
    case 1:
      return scene->functions + drawn(scene->functions_beats * BEAT_WORDS);
    case 2:
      return scene->lattice + drawn(scene->lattice_beats * BEAT_WORDS);
    default:
      return runs->packets + drawn((1 + VERTICES) * BEAT_WORDS);
  }
}

static bool recover(struct runs* runs, struct resets* resets) {
  const enum hwffd_core_status status = hwffd_core_soft_reset(&runs->core, POLLS);
  if (status == HWFFD_CORE_LATE) ++resets->hangs;
  return well(status, "soft reset") && open_ring(runs);
}

static bool spoil(struct runs* runs, struct resets* resets, uint32_t kind, uint32_t first) {
  struct hwffd_core_errors errors = {0};
  if (kind == SOFT_RESET) {
    uint32_t results = 0;
    if (!begin(runs, first)) return false;
    const uint64_t until = clocks() + drawn(LONGEST);
    while (clocks() < until) {
    }
    if (!well(hwffd_core_result_count(&runs->core, &results), "results")) return false;
    resets->caught += results < VERTICES;
    return recover(runs, resets);
  }
  const bool write = kind == WRITE_ERROR || kind == WRITE_SILENCE;
  const bool silence = kind == READ_SILENCE || kind == WRITE_SILENCE;
  set_fault(silence ? FAULT_SILENCE : FAULT_ERROR, (uint32_t)(uintptr_t)some_word(runs, write));
  if (!begin(runs, first)) return false;
  const enum hwffd_core_status status = hwffd_core_wait_done(&runs->core, POLLS);
  set_fault(NO_FAULT, 0);
  if (status == HWFFD_CORE_LATE) ++resets->hangs;
  if (!well(status, "run with an error") ||
      !well(hwffd_core_take_errors(&runs->core, &errors), "errors")) {
    return false;
  }
  const uint32_t wanted = write ? HWFFD_ERROR_STATUS_DMA_WRITE_RESPONSE_MASK
                                : HWFFD_ERROR_STATUS_DMA_READ_RESPONSE_MASK;
  // A packet that an error cuts is too short as well.
  const uint32_t allowed = write ? 0 : HWFFD_ERROR_STATUS_PACKET_SHORT_MASK;
  if ((errors.status & ~allowed) == wanted) {
    ++resets->caught;
  } else {
    ++resets->silent;
  }
  return recover(runs, resets);
}

bool try_resets(struct runs* runs, uint32_t count, struct resets* resets) {
  const uint32_t places = runs->scene.vertices - VERTICES + 1;
  for (; resets->done < count; ++resets->done) {
    const uint32_t kind = set_fault(NO_FAULT, 0) ? drawn(5) : SOFT_RESET;
    const uint32_t first = drawn(places);
    if (!spoil(runs, resets, kind, drawn(places)) || !begin(runs, first)) return false;
    const enum hwffd_core_status status = hwffd_core_wait_done(&runs->core, POLLS);
    if (status == HWFFD_CORE_LATE) ++resets->hangs;
    if (!well(status, "run after a reset")) return false;
    resets->mismatches += mismatches(runs, first, VERTICES);
    resets->results += VERTICES;
    ++resets->by_kind[kind];
    if (resets->done % PROGRESS == 0) printf("tried %lu\n", (unsigned long)resets->done);
  }
  return true;
}
