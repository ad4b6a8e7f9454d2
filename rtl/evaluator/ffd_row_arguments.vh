// Parameters that a row of configurations.csv has, each given the one of the same name. To be
// included in an instance, with more to follow.
// SPDX-License-Identifier: Apache-2.0
.ORG              (ORG),
.N                (N),
.FORMAT           (FORMAT),
.SCHEDULE         (SCHEDULE),
.EVALUATOR        (EVALUATOR),
.MUL_LATENCY      (MUL_LATENCY),
.ADD_LATENCY      (ADD_LATENCY),
.FMA_LATENCY      (FMA_LATENCY),
.CONVERT_LATENCY  (CONVERT_LATENCY),
