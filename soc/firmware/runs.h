// Runs of the core: where rings, packets and results lie, and vertices through it.
#pragma once

#include "platform.h"
#include "scene.h"

enum { RING_LOG2 = 5, RING_ENTRIES = 1 << RING_LOG2, PACKET_VERTICES = 1024 };

struct runs {
  struct hwffd_core core;
  struct scene scene;
  uint32_t* ring;
  uint32_t* packets;
  uint32_t* results;
  unsigned entry;  // of the ring, that is filled next
};

// Bytes that a memory must have for a scene.
uint32_t memory_wanted(const struct scene* scene);

// Finds scene and core, lays out the memory from `start` to `end`, and locks the windows. False: it
// has said why.
bool open_runs(struct runs* runs, struct hwffd_core_port port, uint32_t* start, uint32_t* end);

// An empty ring, after a probe or a soft reset.
bool open_ring(struct runs* runs);

// The packet of `count` vertices from `first` on, at a place. Returns the place behind it.
uint32_t* put_vertices(const struct runs* runs, uint32_t* place, uint32_t first, uint32_t count);

// Descriptors for functions and lattice, and for a packet.
bool send_lattice(struct runs* runs);
bool send(struct runs* runs, const uint32_t* packet, uint32_t beats);

// The area of so many results, cleared, and a start.
bool start(struct runs* runs, uint32_t results);

// How many of the results in memory are not what the model says of the vertices from `first` on.
uint32_t mismatches(const struct runs* runs, uint32_t first, uint32_t count);

// Says in a line what went wrong, unless nothing did.
bool well(enum hwffd_core_status status, const char* what);
