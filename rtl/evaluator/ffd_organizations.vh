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
    (ORG) == 16 || (ORG) == 17 || (ORG) == 18 || (ORG) == 22)

// At how many ports it reads points.
`define FFD_ORG_PORTS(ORG) ((ORG) == 17 ? 3 : 1)

// One pass of it gives the position and its three derivatives.
`define FFD_ORG_JACOBIAN(ORG) \
  ((ORG) == 18 || (ORG) == 20)

`endif
