/**
 * @file
 * Free-form deformation over plain arrays, for programs in C and everything that calls C.
 *
 * A lattice holds its control points at rest and deformed, and the device that evaluates it.
 * Points are doubles x, y, z, one point after the other; control point (i, j, k), i along s, j
 * along t, k along u, is number (i*n_t + j)*n_u + k.
 *
 * Functions that can fail return HWFFD_OK, HWFFD_ERROR or HWFFD_USAGE, those that make a lattice
 * NULL; hwffd_error() then says why, in one line, and what they were to fill is unchanged. A
 * lattice may be used by one thread at a time.
 */
#ifndef HWFFD_HWFFD_H
#define HWFFD_HWFFD_H

#include <stddef.h>

#include "hwffd/version.h"

#ifdef __cplusplus
extern "C" {
#endif

enum {
  HWFFD_OK = 0,
  HWFFD_ERROR = 1, /**< a file, lattice or point is no good */
  HWFFD_USAGE = 2  /**< a name or number that is not accepted */
};

typedef struct hwffd_lattice hwffd_lattice;

/** HWFFD_VERSION of the library that runs, "1.2.3"; the macros are those of the headers. */
const char* hwffd_version(void);

/** Why the last call of this thread failed; "" if none did. Valid until the next failure. */
const char* hwffd_error(void);

/**
 * A lattice from its control points, which must span a volume.
 * @param dims    points along s, t, u, each 4 to 64
 * @param points  dims[0]*dims[1]*dims[2] points, copied
 */
hwffd_lattice* hwffd_lattice_new(const int dims[3], const double* points);

/** A lattice file (docs/lattice.md section 3). */
hwffd_lattice* hwffd_lattice_read(const char* path);

/**
 * An upright shape whose cells hold n points, also as floats (docs/lattice.md section 1).
 * @param shape  "box", "cylinder", "sphere", ..., a kind of docs/lattice.md section 1
 * @param dims   control points an axis; NULL: what suits the shape
 */
hwffd_lattice* hwffd_lattice_around(const char* shape, const int dims[3], const double* points,
                                    size_t n);

/** NULL is allowed. */
void hwffd_lattice_free(hwffd_lattice* lattice);

void hwffd_lattice_dims(const hwffd_lattice* lattice, int dims[3]);

/** Copies the control points, dims[0]*dims[1]*dims[2] of them, as they are deformed now. */
void hwffd_lattice_points(const hwffd_lattice* lattice, double* points);

/** Moves the control points to new places; the lattice at rest stays. */
int hwffd_lattice_move(hwffd_lattice* lattice, const double* points);

/** Moves the control points further, as "twist:90" says (docs/lattice.md section 6). */
int hwffd_lattice_deform(hwffd_lattice* lattice, const char* deformation);

/**
 * What evaluates: "model" (at first), "rtl" or "reference".
 * @param organization  "basic" (at first), "cg3", "factored/3", ..., or a row of `hwffd info`;
 * NULL: as at first
 * @param format        "fp32" (at first), "bfp32", "fx18", "fx32"; NULL: as at first, or as the row
 */
int hwffd_lattice_device(hwffd_lattice* lattice, const char* device, const char* organization,
                         const char* format);

/** What points outside do: "keep" (at first), "clamp" or "fade:WIDTH". */
int hwffd_lattice_outside(hwffd_lattice* lattice, const char* outside);

enum {
  HWFFD_INSIDE = 0,       /**< eq. (1) gives the point back */
  HWFFD_OUTSIDE = 1,      /**< proved: no cell has the point */
  HWFFD_NOT_CONVERGED = 2 /**< neither found nor excluded */
};

/** Where a point lies in the lattice at rest. */
typedef struct hwffd_embedding {
  int cell[3];     /**< along s, t, u */
  int status;      /**< HWFFD_INSIDE, ... */
  double local[3]; /**< s, t, u, in [0, 1] if inside */
  double residual; /**< distance of eq. (1) there from the point */
} hwffd_embedding;

/** Embeds n points in the lattice at rest (paper, eq. 2). */
int hwffd_embed(const hwffd_lattice* lattice, const double* points, size_t n, hwffd_embedding* out);

/** Eq. (1) in the deformed lattice at n embeddings; coordinates beyond [0, 1] are clamped. */
int hwffd_evaluate(hwffd_lattice* lattice, const hwffd_embedding* embeddings, size_t n,
                   double* out);

/**
 * Carries n points of the lattice at rest to where the deformed one takes them: hwffd_embed() and
 * hwffd_evaluate() with hwffd_lattice_outside() for those outside.
 * @param out  n points; may be `points`
 */
int hwffd_deform(hwffd_lattice* lattice, const double* points, size_t n, double* out);

/**
 * How many points of the last hwffd_deform() that succeeded lay outside the cells; with "keep" they
 * stayed where they were. 0 before, and for NULL.
 */
size_t hwffd_outside(const hwffd_lattice* lattice);

#ifdef __cplusplus
}
#endif

#endif
