// Parameters that a row of configurations.csv has, with their defaults. To be included in the list
// of a module's parameters, with more to follow.
// SPDX-License-Identifier: Apache-2.0
parameter ORG             = 0,
parameter N               = 1,
parameter FORMAT          = 18,
parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
parameter EVALUATOR       = `FFD_EVALUATOR_PIPELINED,
parameter MUL_LATENCY     = 2,
parameter ADD_LATENCY     = 1,
parameter FMA_LATENCY     = 0,
parameter CONVERT_LATENCY = 1,
