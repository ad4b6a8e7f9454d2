// Made from rtl/bus/registers.csv by tools/tables/registers.py; changes here are lost.
// What a core has, bits of FEATURES; docs/registers.md section 5.
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_FEATURES_VH
`define FFD_FEATURES_VH
`define FFD_FEATURE_PAGES(FEATURES)       (((FEATURES) >> 0) % 2)
`define FFD_FEATURE_LARGE(FEATURES)       (((FEATURES) >> 1) % 2)
`define FFD_FEATURE_FOURTH(FEATURES)      (((FEATURES) >> 2) % 2)
`define FFD_FEATURE_SPANS(FEATURES)       (((FEATURES) >> 3) % 2)
`define FFD_FEATURE_GRIDS(FEATURES)       (((FEATURES) >> 4) % 2)
`define FFD_FEATURE_PACKED(FEATURES)      (((FEATURES) >> 5) % 2)
`define FFD_FEATURE_MARKS(FEATURES)       (((FEATURES) >> 6) % 2)
`define FFD_FEATURE_RESIDENT(FEATURES)    (((FEATURES) >> 8) % 2)
`define FFD_FEATURE_INTERLEAVED(FEATURES) (((FEATURES) >> 9) % 2)
`define FFD_FEATURE_DERIVATIVES(FEATURES) (((FEATURES) >> 10) % 2)
`define FFD_FEATURE_DETERMINANT(FEATURES) (((FEATURES) >> 11) % 2)
`define FFD_FEATURE_HALVES(FEATURES)      (((FEATURES) >> 12) % 2)
// FEATURES of a module with the parameters of hwffd_stream.
`define FFD_FEATURES_NAMED ((PAGED != 0 ? 1 : 0) + (AXIS > 32 ? 2 : 0) + (FOURTH != 0 ? 4 : 0) \
  + (SPANS > 1 ? 8 : 0) + (GRIDS != 0 ? 16 : 0) + (PACKED != 0 ? 32 : 0) + (MARKS != 0 ? 64 : 0) \
  + (RESIDENT != 0 ? 256 : 0) + (INTERLEAVED != 0 ? 512 : 0) + (DERIVATIVES != 0 ? 1024 : 0) + \
  (DETERMINANT != 0 ? 2048 : 0) + (HALVES != 0 ? 4096 : 0))
`endif
