// Fields of the register FEATURES, each joined with its bit of FEATURES_WORD. To be included in an
// instance, with more to follow.
// SPDX-License-Identifier: Apache-2.0
.features_pages_i        (FEATURES_WORD[0]),
.features_large_i        (FEATURES_WORD[1]),
.features_fourth_i       (FEATURES_WORD[2]),
.features_spans_i        (FEATURES_WORD[3]),
.features_grids_i        (FEATURES_WORD[4]),
.features_packed_i       (FEATURES_WORD[5]),
.features_marks_i        (FEATURES_WORD[6]),
.features_resident_i     (FEATURES_WORD[8]),
.features_interleaved_i  (FEATURES_WORD[9]),
.features_derivatives_i  (FEATURES_WORD[10]),
.features_determinant_i  (FEATURES_WORD[11]),
