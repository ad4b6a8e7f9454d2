#include "runs.h"

#include <stdio.h>
#include <string.h>

enum { OPCODE_VERTICES = 3 };

bool well(enum hwffd_core_status status, const char* what) {
  if (status == HWFFD_CORE_OK) return true;
  printf("soc: %s: %s\n", what, hwffd_core_text(status));
  return false;
}

static uint32_t packets_of(uint32_t vertices) {
  return (vertices + PACKET_VERTICES - 1) / PACKET_VERTICES;
}

// The ring lies at a multiple of its size.
static uint32_t ring_offset(const struct scene* scene) {
  const uint32_t bytes = RING_ENTRIES * BEAT_BYTES;
  return (4 * scene->words + bytes - 1) / bytes * bytes;
}

static uint32_t packets_offset(const struct scene* scene) {
  return ring_offset(scene) + RING_ENTRIES * BEAT_BYTES;
}

static uint32_t results_offset(const struct scene* scene) {
  return packets_offset(scene) + (packets_of(scene->vertices) + scene->vertices) * BEAT_BYTES;
}

uint32_t memory_wanted(const struct scene* scene) {
  return results_offset(scene) + scene->vertices * BEAT_BYTES;
}

bool open_runs(struct runs* runs, struct hwffd_core_port port, uint32_t* start, uint32_t* end) {
  const uint32_t base = (uint32_t)(uintptr_t)start;
  const uint32_t bytes = (uint32_t)(uintptr_t)end - base;
  memset(runs, 0, sizeof *runs);
  runs->core.port = port;
  if (!well(hwffd_core_probe(&runs->core), "core")) return false;
  if (!read_scene(&runs->scene, start)) {
    printf("soc: memory: no scene at %08lx\n", (unsigned long)base);
    return false;
  }
  if (memory_wanted(&runs->scene) > bytes) {
    printf("soc: memory: too small: the scene wants %lu bytes, and %lu are there\n",
           (unsigned long)memory_wanted(&runs->scene), (unsigned long)bytes);
    return false;
  }
  runs->ring = start + ring_offset(&runs->scene) / 4;
  runs->packets = start + packets_offset(&runs->scene) / 4;
  runs->results = start + results_offset(&runs->scene) / 4;
  // Packets, functions and lattice may be read, and results written, nothing else.
  return well(hwffd_core_set_windows(&runs->core, base, (uint32_t)(uintptr_t)runs->results - 1,
                                     (uint32_t)(uintptr_t)runs->results, base + bytes - 1),
              "windows") &&
         well(hwffd_core_lock_windows(&runs->core), "windows") && open_ring(runs);
}

bool open_ring(struct runs* runs) {
  runs->entry = 0;
  return well(hwffd_core_set_ring(&runs->core, (uint32_t)(uintptr_t)runs->ring, RING_LOG2),
              "ring") &&
         well(hwffd_core_next_entry(&runs->core, &runs->entry), "ring");
}

uint32_t* put_vertices(const struct runs* runs, uint32_t* place, uint32_t first, uint32_t count) {
  place[0] = OPCODE_VERTICES;
  place[1] = count;
  place[2] = 0;  // outside: onto the nearest face; positions alone
  place[3] = 0;
  place += BEAT_WORDS;
  for (uint32_t v = 0; v < count; ++v, place += BEAT_WORDS) embed(&runs->scene, first + v, place);
  return place;
}

bool send(struct runs* runs, const uint32_t* packet, uint32_t beats) {
  uint32_t* descriptor = runs->ring + BEAT_WORDS * runs->entry;
  if (!well(hwffd_core_descriptor(&runs->core, descriptor, (uint32_t)(uintptr_t)packet,
                                  beats * BEAT_BYTES, 0),
            "packet")) {
    return false;
  }
  runs->entry = (runs->entry + 1) % RING_ENTRIES;
  return well(hwffd_core_push(&runs->core, 1), "ring");
}

bool send_lattice(struct runs* runs) {
  return send(runs, runs->scene.functions, runs->scene.functions_beats) &&
         send(runs, runs->scene.lattice, runs->scene.lattice_beats);
}

bool start(struct runs* runs, uint32_t results) {
  memset(runs->results, 0xA5, results * BEAT_BYTES);
  return well(hwffd_core_set_results(&runs->core, (uint32_t)(uintptr_t)runs->results,
                                     results * BEAT_BYTES),
              "results") &&
         well(hwffd_core_start(&runs->core), "start");
}

uint32_t mismatches(const struct runs* runs, uint32_t first, uint32_t count) {
  uint32_t wrong = 0;
  see_memory();
  for (uint32_t v = 0; v < count; ++v) {
    const uint32_t* result = runs->results + BEAT_WORDS * v;
    const uint32_t* expected = runs->scene.expected + BEAT_WORDS * (first + v);
    if (memcmp(result, expected, BEAT_BYTES) == 0) continue;
    if (wrong++ != 0) continue;
    printf("soc: vertex %lu: %08lx %08lx %08lx %08lx, the model says %08lx %08lx %08lx %08lx\n",
           (unsigned long)(first + v), (unsigned long)result[0], (unsigned long)result[1],
           (unsigned long)result[2], (unsigned long)result[3], (unsigned long)expected[0],
           (unsigned long)expected[1], (unsigned long)expected[2], (unsigned long)expected[3]);
  }
  return wrong;
}
