#include "software_sum.h"

enum { WIDTH = 18, WEIGHT_FRACTION = WIDTH - 2, WEIGHT_MOST = (1 << (WIDTH - 1)) - 1 };

// Half up.
static int32_t shifted(int32_t word, int bits) {
  return (int32_t)(((int64_t)word + (1 << (bits - 1))) >> bits);
}

static int32_t saturated(int64_t number, int32_t most) {
  return number > most ? most : number < -most - 1 ? -most - 1 : (int32_t)number;
}

static int32_t product(int32_t a, int32_t b) {
  const int64_t exact = (int64_t)a * b + (1 << (WEIGHT_FRACTION - 1));
  return saturated(exact >> WEIGHT_FRACTION, WEIGHT_MOST);
}

// The four weights of an axis, by Horner's rule.
static void weights(const int32_t functions[4][4], int32_t x, int32_t weight[4]) {
  for (int f = 0; f < 4; ++f) {
    int32_t w = functions[f][3];
    for (int power = 2; power >= 0; --power) {
      const int64_t exact = (int64_t)x * w + (1 << (WEIGHT_FRACTION - 1));
      w = saturated(functions[f][power] + (exact >> WEIGHT_FRACTION), WEIGHT_MOST);
    }
    weight[f] = w;
  }
}

void open_software(struct software_lattice* lattice, const struct scene* scene,
                   int32_t (*place)[3]) {
  const uint32_t* beat = scene->functions + BEAT_WORDS;
  for (int axis = 0; axis < 3; ++axis) {
    for (int f = 0; f < 4; ++f, beat += BEAT_WORDS) {
      for (int power = 0; power < 4; ++power) {
        lattice->functions[axis][f][power] =
            saturated(shifted((int32_t)beat[power], 30 - WEIGHT_FRACTION), WEIGHT_MOST);
      }
    }
  }
  for (int a = 0; a < 3; ++a) lattice->points[a] = scene->points[a];
  lattice->point = place;
  beat = scene->lattice + BEAT_WORDS;
  for (uint32_t p = 0; p + 1 < scene->lattice_beats; ++p, beat += BEAT_WORDS) {
    for (int a = 0; a < 3; ++a) {
      place[p][a] = saturated(shifted((int32_t)beat[a], 32 - WIDTH), WEIGHT_MOST);
    }
  }
}

void software_sum(const struct software_lattice* lattice, const uint32_t beat[BEAT_WORDS],
                  uint32_t result[3]) {
  int32_t weight[3][4];
  for (int a = 0; a < 3; ++a) {
    const int32_t x =
        (int32_t)((beat[a] + (1U << (30 - WEIGHT_FRACTION))) >> (31 - WEIGHT_FRACTION));
    weights(lattice->functions[a], x, weight[a]);
  }
  const uint32_t i = beat[3] >> 16 & 15;
  const uint32_t j = beat[3] >> 20 & 15;
  const uint32_t k = beat[3] >> 24 & 15;
  int64_t sum[3] = {0, 0, 0};
  for (uint32_t l = 0; l < 4; ++l) {
    for (uint32_t m = 0; m < 4; ++m) {
      const int32_t plane = product(weight[0][l], weight[1][m]);
      const int32_t(*point)[3] =
          (const int32_t(*)[3]) &
          lattice->point[((i + l) * lattice->points[1] + j + m) * lattice->points[2] + k];
      for (uint32_t n = 0; n < 4; ++n) {
        const int32_t w = product(plane, weight[2][n]);
        for (int a = 0; a < 3; ++a) sum[a] += (int64_t)w * point[n][a];
      }
    }
  }
  for (int a = 0; a < 3; ++a) {  // Q9.33 to Q1.31
    result[a] = (uint32_t)saturated((sum[a] + 2) >> 2, INT32_MAX);
  }
}
