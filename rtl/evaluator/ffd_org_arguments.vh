// An organization's parameters, each given the one of the same name. To be included in an instance.
// SPDX-License-Identifier: Apache-2.0
.FORMAT         (FORMAT),
.N              (N),
.SCHEDULE       (SCHEDULE),
.EVALUATOR      (EVALUATOR),
.MUL_LATENCY    (MUL_LATENCY),
.ADD_LATENCY    (ADD_LATENCY),
.FMA_LATENCY    (FMA_LATENCY),
.CONVERT_LATENCY(CONVERT_LATENCY),
.READ_LATENCY   (READ_LATENCY),
.SOURCE_W       (SOURCE_W),
.PORTS          (PORTS),
.SPANS          (SPANS)
