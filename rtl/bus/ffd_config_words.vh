// What was built, in words, as the registers show it (ffd_config_connections.vh).
// SPDX-License-Identifier: Apache-2.0
localparam [31:0] ORG_WORD       = ORG;
localparam [31:0] N_WORD         = N;
localparam [31:0] FORMAT_WORD    = FORMAT;
localparam [31:0] SCHEDULE_WORD  = SCHEDULE;
localparam [31:0] EVALUATOR_WORD = EVALUATOR;
localparam [31:0] IN_FLIGHT_WORD = `FFD_IN_FLIGHT(IN_FLIGHT, ORG, N);
// No lattice is kept: no points an axis, no pages.
localparam [31:0] AXIS_WORD      = `FFD_FEATURE_RESIDENT(FEATURES) != 0 ? AXIS : 0;
localparam [31:0] PAGES_WORD     = `FFD_FEATURE_RESIDENT(FEATURES) != 0 ? PAGES : 0;
localparam [31:0] SPANS_WORD     = SPANS;
localparam [31:0] FEATURES_WORD  = FEATURES;
localparam [31:0] COUNT_WORD     = COUNT_WIDTH;
