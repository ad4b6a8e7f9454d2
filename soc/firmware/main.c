// A mesh from the system's memory through the core, every result compared with the model's; the
// same sum in C; what is refused; and soft resets and errors of the bus in the middle of transfers.
// soc/simulate.py reads what it prints.

#include <stdio.h>

#include "hwffd/registers.h"
#include "refusals.h"
#include "resets.h"
#include "runs.h"
#include "software_sum.h"

enum {
  POLLS = 10000000,     // of a run
  SOFTWARE_SUMS = 500,  // vertices of the sample
  MOST_POINTS = 512
};

static struct runs runs;
static int32_t points[MOST_POINTS][3];  // of the sum in C

static void say(const char* name, uint32_t value) {
  printf("%s %lu\n", name, (unsigned long)value);
}

// A mean over so many, in thousandths.
static void say_mean(const char* name, uint64_t sum, uint32_t count) {
  say(name, (uint32_t)(1000 * sum / count));
}

// Descriptors for packets of all vertices.
static bool send_vertices(const uint32_t* packet) {
  uint32_t left = runs.scene.vertices;
  while (left != 0) {
    const uint32_t count = left < PACKET_VERTICES ? left : PACKET_VERTICES;
    if (!send(&runs, packet, 1 + count)) return false;
    packet += BEAT_WORDS * (1 + count);
    left -= count;
  }
  return true;
}

static void put_all(void) {
  uint32_t* place = runs.packets;
  for (uint32_t first = 0; first < runs.scene.vertices; first += PACKET_VERTICES) {
    const uint32_t left = runs.scene.vertices - first;
    place = put_vertices(&runs, place, first, left < PACKET_VERTICES ? left : PACKET_VERTICES);
  }
}

// What a run has left: results, errors, words.
static bool compare(const char* name) {
  struct hwffd_core_errors errors = {0};
  uint32_t results = 0;
  if (!well(hwffd_core_result_count(&runs.core, &results), "results") ||
      !well(hwffd_core_take_errors(&runs.core, &errors), "errors")) {
    return false;
  }
  if (results != runs.scene.vertices || errors.status != 0) {
    printf("soc: %lu results of %lu vertices, errors %08lx\n", (unsigned long)results,
           (unsigned long)runs.scene.vertices, (unsigned long)errors.status);
    return false;
  }
  say(name, mismatches(&runs, 0, runs.scene.vertices));
  return true;
}

// The whole mesh, polled: functions and lattice first, so that clocks are those of vertices.
static bool deform_polled(void) {
  uint64_t from = clocks();
  put_all();
  say_mean("embedding_clocks", clocks() - from, runs.scene.vertices);
  from = clocks();
  if (!send_lattice(&runs) || !start(&runs, 1) ||
      !well(hwffd_core_wait_done(&runs.core, POLLS), "lattice")) {
    return false;
  }
  say("lattice_clocks", (uint32_t)(clocks() - from));
  if (!send_vertices(runs.packets) || !start(&runs, runs.scene.vertices)) return false;
  from = clocks();
  if (!well(hwffd_core_wait_done(&runs.core, POLLS), "run")) return false;
  say_mean("core_clocks", clocks() - from, runs.scene.vertices);
  return compare("mismatches_polled");
}

// The same, and the processor waits for the interrupt.
static bool deform_by_interrupt(void) {
  uint32_t bits = 0;
  if (!send_vertices(runs.packets) ||
      // The end of the run before has set it, too.
      !well(hwffd_core_take_interrupts(&runs.core, &bits), "interrupt") ||
      !well(hwffd_core_enable_interrupts(&runs.core, HWFFD_IRQ_ENABLE_DONE_MASK), "interrupt")) {
    return false;
  }
  allow_interrupt(true);
  if (!start(&runs, runs.scene.vertices)) return false;
  const uint64_t from = clocks();
  if (!wait_interrupt(1000 * runs.scene.vertices)) return false;
  say_mean("interrupt_clocks", clocks() - from, runs.scene.vertices);
  return well(hwffd_core_take_interrupts(&runs.core, &bits), "interrupt") &&
         well(hwffd_core_enable_interrupts(&runs.core, 0), "interrupt") &&
         compare("mismatches_interrupt");
}

static bool sum_in_c(void) {
  struct software_lattice lattice;
  const uint32_t sums = runs.scene.vertices < SOFTWARE_SUMS ? runs.scene.vertices : SOFTWARE_SUMS;
  uint32_t wrong = 0;
  uint64_t spent = 0;
  if (runs.scene.lattice_beats - 1 > MOST_POINTS) {
    printf("soc: software: more than %d control points\n", MOST_POINTS);
    return false;
  }
  open_software(&lattice, &runs.scene, points);
  for (uint32_t n = 0; n < sums; ++n) {
    const uint32_t vertex = (uint32_t)((uint64_t)n * runs.scene.vertices / sums);
    uint32_t beat[BEAT_WORDS];
    uint32_t result[3];
    embed(&runs.scene, vertex, beat);
    const uint64_t from = clocks();
    software_sum(&lattice, beat, result);
    spent += clocks() - from;
    const uint32_t* expected = runs.scene.expected + BEAT_WORDS * vertex;
    wrong += result[0] != expected[0] || result[1] != expected[1] || result[2] != expected[2];
  }
  say("software_vertices", sums);
  say("software_mismatches", wrong);
  say_mean("software_clocks", spent, sums);
  return true;
}

static bool reset_often(void) {
  struct resets resets = {0};
  const bool ended = try_resets(&runs, RESETS, &resets);
  for (unsigned kind = 0; kind < 5; ++kind) {
    printf("soc: %lu %s\n", (unsigned long)resets.by_kind[kind], reset_kinds[kind]);
  }
  say("resets", resets.done);
  say("resets_caught", resets.caught);
  say("resets_silent", resets.silent);
  say("resets_results", resets.results);
  say("resets_mismatches", resets.mismatches);
  say("hangs", resets.hangs);
  return ended;
}

static bool work(void) {
  if (!open_runs(&runs, core_port(), memory_start, memory_end)) return false;
  const struct hwffd_core_identity* core = &runs.core.identity;
  printf("soc: hwffd %u.%u.%u, organization %u, format %u\n", core->version_major,
         core->version_minor, core->version_patch, core->org, core->format);
  say("vertices", runs.scene.vertices);
  if (!deform_polled() || !deform_by_interrupt() || !sum_in_c()) return false;
  const uint32_t refused = count_refusals(&runs);
  say("refusals", refused);
  return refused == REFUSALS && reset_often();
}

int main(void) {
  printf("status %d\n", work() ? 0 : 1);
  finish();
}
