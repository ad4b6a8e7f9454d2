// Parameters of hwffd_stream, handed on under the same names. To be included in an instance, as the
// last of its parameters.
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
.AXIS             (AXIS),
.IN_FLIGHT        (IN_FLIGHT),
.WAITING          (WAITING),
.FEATURES         (FEATURES)
