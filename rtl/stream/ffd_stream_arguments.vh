// Parameters of hwffd_stream, handed on under the same names. To be included in an instance, as the
// last of its parameters.
// SPDX-License-Identifier: Apache-2.0
`include "ffd_row_arguments.vh"
.AXIS             (AXIS),
.PAGES            (PAGES),
.IN_FLIGHT        (IN_FLIGHT),
.WAITING          (WAITING),
.RESIDENT         (RESIDENT),
.INTERLEAVED      (INTERLEAVED),
.PAGED            (PAGED),
.FOURTH           (FOURTH),
.GRIDS            (GRIDS),
.PACKED           (PACKED),
.MARKS            (MARKS),
.DERIVATIVES      (DERIVATIVES),
.DETERMINANT      (DETERMINANT),
.HALVES           (HALVES),
.SPANS            (SPANS),
.GRID_LIMIT       (GRID_LIMIT),
.HARDENED         (HARDENED)
