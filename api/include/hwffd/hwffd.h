/**
 * @file
 * Free-form deformation over plain arrays, for programs in C and everything that calls C.
 *
 * A lattice holds its control points at rest and deformed, and the device that evaluates it.
 * Points are doubles x, y, z, one point after the other, or lie as a hwffd_view says; control point
 * (i, j, k), i along s, j along t, k along u, is number (i*n_t + j)*n_u + k.
 *
 * Functions that can fail return HWFFD_OK, HWFFD_ERROR or HWFFD_USAGE, those that make a lattice
 * NULL; hwffd_error() then says why, in one line, and what they were to fill is unchanged. A
 * lattice may be used by one thread at a time.
 */
#ifndef HWFFD_HWFFD_H
#define HWFFD_HWFFD_H

#include <stddef.h>
#include <stdint.h>

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

/**
 * How many threads embed and evaluate, in all of the program; 0: as many as there are cores, as at
 * first. No result depends on it.
 */
void hwffd_set_threads(size_t count);

/** Why the last call of this thread failed; "" if none did. Valid until the next failure. */
const char* hwffd_error(void);

/**
 * A lattice from its control points, which must span a volume.
 * @param dims    points along s, t, u, each 4 to 64
 * @param points  dims[0]*dims[1]*dims[2] points, copied
 */
hwffd_lattice* hwffd_lattice_new(const int dims[3], const double* points);

/** A lattice file (docs/lattice.md section 3), with its family, and deformed where it says so. */
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

/** Control points along s, t, u. */
int hwffd_lattice_dims(const hwffd_lattice* lattice, int dims[3]);

/**
 * Makes the control points, at rest and deformed, those of another family of blending functions:
 * "bspline" (at first), "clamped", "bernstein", "catmull-rom" or "linear" (docs/lattice.md).
 */
int hwffd_lattice_family(hwffd_lattice* lattice, const char* family);

/** Copies the control points, dims[0]*dims[1]*dims[2] of them, as they are deformed now. */
int hwffd_lattice_points(const hwffd_lattice* lattice, double* points);

/** Moves the control points to new places; the lattice at rest stays. */
int hwffd_lattice_move(hwffd_lattice* lattice, const double* points);

/** Moves the control points further, as "twist:90" says (docs/lattice.md section 6). */
int hwffd_lattice_deform(hwffd_lattice* lattice, const char* deformation);

/**
 * What evaluates: "reference" (at first), for which the other words mean nothing, "model", "rtl",
 * a board, "serial:/dev/ttyUSB0", a core under Linux, "uio:0",
 * or one that a process serves, "socket:PATH" (docs/hwffd.md).
 * @param organization  "basic" (at first), "cg3", "factored/3", ..., or a row of `hwffd info`;
 * NULL: as at first, or what the board has
 * @param format        "fp32" (at first), "bfp32", "fx16", "fx17", "fx18", "fx32"; NULL: as at
 * first, or as the row
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
 * The transpose of hwffd_evaluate(): of the gradient of a number with respect to the points at n
 * embeddings, x, y, z for each, that with respect to the control points. The bits are the same for
 * embeddings in any order; where the control points are now does not matter.
 * @param device  what adds up: "reference", "model" for that of the organization affine in fx17, or
 * "rtl" for the simulated core with the same bits; NULL: hwffd_lattice_device(), which must be a
 * device that can do so
 * @param out     x, y, z for each control point of the lattice
 */
int hwffd_pull_back(hwffd_lattice* lattice, const char* device, const hwffd_embedding* embeddings,
                    size_t n, const double* gradient, double* out);

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

enum {
  HWFFD_FLOAT32 = 1, /**< float */
  HWFFD_FLOAT64 = 2  /**< double */
};

/**
 * Where points lie in memory that is the caller's: coordinate c of point i, a number of `type`, is
 * i*point_bytes + c*coordinate_bytes bytes behind `data`. Numbers need no alignment. What is read
 * is not written to.
 */
typedef struct hwffd_view {
  void* data;                 /**< x of the first point; NULL if there are none */
  size_t count;               /**< of points */
  int type;                   /**< HWFFD_FLOAT32 or HWFFD_FLOAT64 */
  ptrdiff_t point_bytes;      /**< from a point to the next; negative too */
  ptrdiff_t coordinate_bytes; /**< from x to y and y to z */
} hwffd_view;

/** A view of x, y, z, one point after the other; of an unknown type a view that is refused. */
hwffd_view hwffd_packed(int type, const void* data, size_t count);
/** The same of room for results. */
hwffd_view hwffd_packed_out(int type, void* data, size_t count);

/** As hwffd_deform(), of points that lie anywhere; `out` may be `points`. */
int hwffd_deform_view(hwffd_lattice* lattice, const hwffd_view* points, const hwffd_view* out);

/**
 * Points attached to a lattice: where they lie in it at rest, kept to be deformed again and again.
 * It refers to no lattice that lives, and may be used by several threads.
 */
typedef struct hwffd_attached hwffd_attached;

/** Embeds points in the lattice at rest, with its family and hwffd_lattice_outside() of now. */
hwffd_attached* hwffd_attach(const hwffd_lattice* lattice, const hwffd_view* points);

/** NULL is allowed. */
void hwffd_attached_free(hwffd_attached* attached);

/** What became of points that were attached. */
typedef struct hwffd_counts {
  size_t points;
  size_t inside;
  size_t outside;
  double worst_residual; /**< of those inside: distance of eq. (1) at rest from the point */
} hwffd_counts;

int hwffd_attached_counts(const hwffd_attached* attached, hwffd_counts* counts);

/**
 * Where the deformed lattice takes the points: the bits of hwffd_deform().
 * @param lattice  that which they were attached to, or one with the same points at rest and family
 */
int hwffd_attached_deform(const hwffd_attached* attached, hwffd_lattice* lattice,
                          const hwffd_view* out);

/**
 * The gradient of the deformation at each point, 3 x 3, in double: out[9*i + 3*r + c] is the
 * derivative of coordinate r of the moved point i along coordinate c of the point at rest. NaN
 * where it is not known: at poles and axes, and where the nearest place of a point outside that
 * follows jumps.
 */
int hwffd_attached_gradients(const hwffd_attached* attached, const hwffd_lattice* lattice,
                             double* out);

/** The determinants of these gradients, one for each point. */
int hwffd_attached_determinants(const hwffd_attached* attached, const hwffd_lattice* lattice,
                                double* out);

/** Normals, of any length, as the deformation turns them, of length 1; NaN where not known. */
int hwffd_attached_normals(const hwffd_attached* attached, const hwffd_lattice* lattice,
                           const hwffd_view* normals, const hwffd_view* out);

/** How many weights hwffd_attached_weights() gives; 0 for NULL. */
size_t hwffd_attached_weight_count(const hwffd_attached* attached);

/**
 * The weights of the control points in the points, a sparse matrix W by rows: row i has values[w]
 * in column columns[w], the number of a control point, for w from starts[i] to starts[i + 1] - 1.
 * Where P are control points, W P + hwffd_attached_unmoved() are the points, but for rounding.
 * @param starts  points + 1 numbers
 * @param columns, values  hwffd_attached_weight_count() numbers each
 */
int hwffd_attached_weights(const hwffd_attached* attached, int64_t* starts, int32_t* columns,
                           double* values);

/** What does not move with the control points: 0 for a point inside, the point if it stays. */
int hwffd_attached_unmoved(const hwffd_attached* attached, const hwffd_view* out);

/**
 * The transpose product: of the gradient of a number with respect to the points that with respect
 * to the control points.
 * @param out  x, y, z for each control point of the lattice
 */
int hwffd_attached_pull_back(const hwffd_attached* attached, const hwffd_view* gradient,
                             double* out);

#ifdef __cplusplus
}
#endif

#endif
