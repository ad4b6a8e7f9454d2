// What kind an organization is, by its number.
// Made from rtl/organizations.csv by tools/tables/generated_files.py; changes here are lost.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_ORGANIZATIONS_VH
`define FFD_ORGANIZATIONS_VH

// It takes the 64 points of a vertex in turn, N in a clock.
`define FFD_ORG_IN_TURN(ORG) \
  ((ORG) == 0 || (ORG) == 1 || (ORG) == 3 || (ORG) == 4 || (ORG) == 5 || (ORG) == 13 || \
    (ORG) == 16)

// It takes for granted that the functions of an axis sum to one.
`define FFD_ORG_AFFINE(ORG) \
  ((ORG) == 10 || (ORG) == 11 || (ORG) == 12 || (ORG) == 13 || (ORG) == 14 || (ORG) == 15 || \
    (ORG) == 16 || (ORG) == 17 || (ORG) == 18 || (ORG) == 22 || (ORG) == 23)

// How many points it takes in a clock; four, the functions of an axis, where it may be any.
`define FFD_ORG_N(ORG) \
  ((ORG) == 0 ? 1 : (ORG) == 1 ? 1 : (ORG) == 3 ? 1 : (ORG) == 5 ? 64 : \
    (ORG) == 6 ? 64 : (ORG) == 7 ? 32 : (ORG) == 10 ? 64 : (ORG) == 11 ? 32 : \
    (ORG) == 12 ? 64 : (ORG) == 13 ? 1 : (ORG) == 14 ? 32 : (ORG) == 15 ? 32 : \
    (ORG) == 16 ? 16 : (ORG) == 17 ? 16 : (ORG) == 18 ? 32 : (ORG) == 20 ? 32 : \
    (ORG) == 22 ? 4 : (ORG) == 23 ? 4 : 4)

// At how many ports it reads points.
`define FFD_ORG_PORTS(ORG) ((ORG) == 17 ? 3 : 1)

// One pass of it gives the position and its three derivatives.
`define FFD_ORG_JACOBIAN(ORG) \
  ((ORG) == 18 || (ORG) == 20)

// It takes a second vertex of the same cell of a row with each one.
`define FFD_ORG_PAIRS(ORG) \
  ((ORG) == 23)

`endif
