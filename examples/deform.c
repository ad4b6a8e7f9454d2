/* Twists points of a sphere in a lattice of its shape. */
#include <hwffd/hwffd.h>
#include <stdio.h>

int main(void) {
  const double corners[] = {-1, -1, -1, 1, 1, 1};
  const double points[] = {0.5, 0.9, 0, 0, 0.9, 0.5, 0.5, -0.9, 0};
  double moved[9];
  hwffd_embedding where[3];
  hwffd_lattice* sphere = hwffd_lattice_around("sphere", NULL, corners, 2);
  if (sphere == NULL || hwffd_embed(sphere, points, 3, where) != HWFFD_OK ||
      hwffd_lattice_deform(sphere, "twist:90") != HWFFD_OK ||
      hwffd_deform(sphere, points, 3, moved) != HWFFD_OK) {
    fprintf(stderr, "%s\n", hwffd_error());
    return 1;
  }
  for (int i = 0; i < 3; ++i) {
    printf("cell %d %d %d: %.6f %.6f %.6f\n", where[i].cell[0], where[i].cell[1], where[i].cell[2],
           moved[3 * i], moved[3 * i + 1], moved[3 * i + 2]);
  }
  hwffd_lattice_free(sphere);
  return 0;
}
