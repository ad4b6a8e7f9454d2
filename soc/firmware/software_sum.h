// Equation (1) in C, with the bits of the core: fx18 in product form (docs/numerics.md sections 3
// and 4).
#pragma once

#include "scene.h"

// The functions and points of a scene as numbers, which a program makes once for a lattice.
struct software_lattice {
  int32_t functions[3][4][4];  // of an axis: function, power; Q2.16
  uint32_t points[3];
  int32_t (*point)[3];  // Q1.17, u fastest
};

// A place for the points: three words each.
void open_software(struct software_lattice* lattice, const struct scene* scene,
                   int32_t (*place)[3]);

// The result of a vertex's beat: x, y, z in Q1.31. Vertices must lie in the lattice.
void software_sum(const struct software_lattice* lattice, const uint32_t beat[BEAT_WORDS],
                  uint32_t result[3]);
