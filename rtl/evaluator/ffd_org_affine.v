// ffd_org_affine: `factored` for functions that sum to one, three multiplications for four points
//
// An affine combination: w0 P0 + w1 P1 + w2 P2 + w3 P3 = P3 + sum of w_b (P_b - P3), where the
// weights sum to one. 63 multiplications a component in place of 84, and 9 polynomials in place of
// 12: bank 3 has what the others leave, so that weights sum to one by construction, whatever is
// loaded, and with the same bits on both sides of a face. Weights of a derivative sum to zero.
//
// Formats:    fxW only: differences are exact there. One is a bit wider than a point, so that with
//             multipliers of 18 x 18 the format is fx17.
// Jacobian:   in one pass of 144 multiplications a component; derivative weights leave P3 out.
// Schedule, pipeline, freezes, ports: those of ffd_org_factored; in sequence of ffd_eval_serial.
// Parameters: as there, and FORMAT 8 to 32. FOLD also 4, and 64: in sequence, N is then 1, LANES
//             unused; and 16, along rows of vertices: ffd_eval_walk, N 4, one lane, or two for
//             pairs of vertices.
// Not checked: that the functions loaded sum to one; bank 3 has what the others leave, and
//             ffd_stream_sums tells.
// Model:      golden/include/hwffd/model/org_affine.hpp.  Test: tests/evaluator, tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_affine #(
  parameter FOLD            = 1,
  parameter LANES           = 1,
  parameter JACOBIAN        = 0,
  parameter FORMAT          = 17,
  parameter N               = 64,
  parameter PORTS           = 1,
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  generate
    if (SCHEDULE != `FFD_SCHEDULE_OVERLAPPED) begin : gen_bad_schedule
      ERROR_ffd_org_affine_schedule_must_be_overlapped u_error ();
    end else if (FOLD != 16 && FOLD != 64 && `FFD_FOLD_BAD(FOLD)) begin : gen_bad_fold
      ERROR_ffd_org_affine_fold_must_be_1_2_3_4_6_16_or_64 u_error ();
    end else if (FOLD >= 16 && N != 64 / FOLD) begin : gen_bad_n
      ERROR_ffd_org_affine_n_must_be_64_by_its_fold u_error ();
    end else if (FOLD >= 16 && JACOBIAN != 0) begin : gen_bad_jacobian
      ERROR_ffd_org_affine_jacobian_wants_fold_3 u_error ();
    end else if (FOLD == 64) begin : gen_serial
      ffd_eval_serial #(
        `include "ffd_org_arguments.vh"
      ) u_serial (
        `include "ffd_org_connections.vh"
      );
    end else if (FOLD == 16 && LANES != 1 && LANES != 2) begin : gen_bad_lanes
      ERROR_ffd_org_affine_folded_by_16_has_one_lane_or_two u_error ();
    end else if (FOLD == 16) begin : gen_walk
      ffd_eval_walk #(
        .PAIRS(LANES - 1),
        `include "ffd_org_arguments.vh"
      ) u_walk (
        `include "ffd_org_connections.vh"
      );
    end else begin : gen_affine
      ffd_org_factored #(
        .FOLD    (FOLD),
        .LANES   (LANES),
        .AFFINE  (1),
        .JACOBIAN(JACOBIAN),
        `include "ffd_org_arguments.vh"
      ) u_factored (
        `include "ffd_org_connections.vh"
      );
    end
  endgenerate
endmodule

`default_nettype wire
