// ffd_num_latencies: whether the latencies of a row are some that its format has
//
// A guard and nothing else: what an organization counts on is checked once, whether it has a unit
// that would refuse it or not.
//
// Parameters: FORMAT as in ffd_num.vh; MUL_LATENCY and ADD_LATENCY >= 1; FMA_LATENCY >= 1 fuses, in
//             binary32 only, 0 does not; CONVERT_LATENCY >= 0.
// Model:      none (guards only).  Test: tests/lint/bad_parameters.csv.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"

module ffd_num_latencies #(
  parameter FORMAT          = 18,
  parameter MUL_LATENCY     = 1,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 0
) ();
  generate
    if (`FFD_FORMAT_BAD(FORMAT)) begin : gen_bad_format
      ERROR_ffd_num_latencies_format_is_unknown u_error ();
    end
    if (MUL_LATENCY < 1 || ADD_LATENCY < 1) begin : gen_bad_latency
      ERROR_ffd_num_latencies_must_be_at_least_1 u_error ();
    end
    if (`FFD_FMA_BAD(FORMAT, FMA_LATENCY)) begin : gen_bad_fma
      ERROR_ffd_num_latencies_fused_needs_fp32 u_error ();
    end
    if (CONVERT_LATENCY < 0) begin : gen_bad_convert
      ERROR_ffd_num_latencies_convert_latency_must_not_be_negative u_error ();
    end
  endgenerate
endmodule

`default_nettype wire
