#include "scene.h"

enum { MAGIC = 0x4E454353, FRACTION = 28 };

bool read_scene(struct scene* scene, uint32_t* memory) {
  if (memory[0] != MAGIC) return false;
  scene->words = memory[1];
  scene->vertices = memory[2];
  for (int a = 0; a < 3; ++a) scene->points[a] = memory[3 + a];
  scene->functions = memory + memory[6];
  scene->functions_beats = memory[7];
  scene->lattice = memory + memory[8];
  scene->lattice_beats = memory[9];
  scene->positions = memory + memory[10];
  scene->expected = memory + memory[11];
  return true;
}

void embed(const struct scene* scene, uint32_t vertex, uint32_t beat[BEAT_WORDS]) {
  uint32_t cells = 0;
  for (int a = 0; a < 3; ++a) {
    const uint32_t position = scene->positions[3 * vertex + a];
    const uint32_t last = scene->points[a] - 4;
    uint32_t cell = position >> FRACTION;
    if (cell > last) cell = last;  // on the last face, at 1
    beat[a] = (position - (cell << FRACTION)) << (31 - FRACTION);
    cells |= cell << (16 + 4 * a);
  }
  beat[3] = cells | (vertex & 0xFFFF);
}
