// What kind an organization is, by its number.
// Made from rtl/organizations.csv by scripts/made.py; changes here are lost.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_ORGANIZATIONS_VH
`define FFD_ORGANIZATIONS_VH

// It adds 64 products of weights and points.
`define FFD_ORG_PRODUCT(ORG) \
  ((ORG) == 0 || (ORG) == 1 || (ORG) == 2 || (ORG) == 3 || (ORG) == 4 || (ORG) == 5)

`endif
