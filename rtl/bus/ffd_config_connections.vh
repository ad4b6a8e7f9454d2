// Fields of the registers that say what was built, each joined with its word in ffd_bus_core. To be
// included in an instance, with more to follow.
// SPDX-License-Identifier: Apache-2.0
.config_org_i            (ORG_WORD[7:0]),
.config_n_i              (N_WORD[7:0]),
.config_format_i         (FORMAT_WORD[7:0]),
.config_schedule_i       (SCHEDULE_WORD[0]),
.config_evaluator_i      (EVALUATOR_WORD[1:0]),
.limits_in_flight_i      (IN_FLIGHT_WORD[15:0]),
.limits_points_axis_i    (AXIS_WORD[7:0]),
.limits2_pages_i         (PAGES_WORD[15:0]),
.limits2_spans_i         (SPANS_WORD[7:0]),
.limits2_count_width_i   (COUNT_WORD[5:0]),
.limits2_hardened_i      (HARDENED != 0),
`include "ffd_features_connections.vh"
