// What the large memory holds at the start (soc/scene.cpp): words of 32 bits.
#pragma once

#include <stdbool.h>
#include <stdint.h>

enum { BEAT_WORDS = 4, BEAT_BYTES = 16 };

struct scene {
  uint32_t words;  // all of it
  uint32_t vertices;
  uint32_t points[3];   // control points an axis
  uint32_t* functions;  // packets, ready to be sent
  uint32_t functions_beats;
  uint32_t* lattice;
  uint32_t lattice_beats;
  const uint32_t* positions;  // three words a vertex, Q4.28 in cells
  const uint32_t* expected;   // four words a vertex: the results of the bit-true model
};

// False: there is none at that place.
bool read_scene(struct scene* scene, uint32_t* memory);

// A vertex of the mesh as the beat of a packet (docs/interface.md section 2).
void embed(const struct scene* scene, uint32_t vertex, uint32_t beat[BEAT_WORDS]);
