// ffd_org_select: the organization numbered ORG
//
// ORG is 0 basic (N 1), 1 cg1 (N 1), 3 cg3 (N 1), 4 tree, 5 parallel (N 64), 6 factored (N 64), 7
// factored/3 (N 32), 10 affine (N 64), 11 affine/3 (N 32), 12 affine/3x2 (N 64), 13 affine/64 (N
// 1), 14 affine/2 (N 32), 15 affine/6 (N 32), 16 affine/4 (N 16), 17 affine/4x3 (N 16), 18
// jacobian/3 (N 32), 20 jet/3 (N 32), 22 walk (N 4), 23 walk/2 (N 4).
// Made from rtl/organizations.csv by tools/tables/generated_files.py; changes here are lost.
//
// Ports, pipeline, parameters: those of every organization (docs/architecture.md).
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_select #(
  parameter ORG             = 0,
  parameter FORMAT          = 18,
  parameter N               = 1,
  parameter PORTS           = `FFD_ORG_PORTS(ORG),
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
  ffd_num_latencies #(
    .FORMAT         (FORMAT),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY)
  ) u_latencies ();

  generate
    if (ORG == 0 && N != 1 ||
        ORG == 1 && N != 1 ||
        ORG == 3 && N != 1 ||
        ORG == 5 && N != 64 ||
        ORG == 6 && N != 64 ||
        ORG == 7 && N != 32 ||
        ORG == 10 && N != 64 ||
        ORG == 11 && N != 32 ||
        ORG == 12 && N != 64 ||
        ORG == 13 && N != 1 ||
        ORG == 14 && N != 32 ||
        ORG == 15 && N != 32 ||
        ORG == 16 && N != 16 ||
        ORG == 17 && N != 16 ||
        ORG == 18 && N != 32 ||
        ORG == 20 && N != 32 ||
        ORG == 22 && N != 4 ||
        ORG == 23 && N != 4) begin : gen_bad_n
      ERROR_ffd_org_select_n_is_not_that_of_the_organization u_error ();
    end
    if (ORG == 0) begin : gen_basic
      ffd_org_tree #(
        .SERIAL(1),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 1) begin : gen_cg1
      ffd_org_cg #(
        .SIZE(1),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 3) begin : gen_cg3
      ffd_org_cg #(
        .SIZE(3),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 4) begin : gen_tree
      ffd_org_tree #(
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 5) begin : gen_parallel
      ffd_org_tree #(
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 6) begin : gen_factored
      ffd_org_factored #(
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 7) begin : gen_factored_by_3
      ffd_org_factored #(
        .FOLD(3),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 10) begin : gen_affine
      ffd_org_affine #(
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 11) begin : gen_affine_by_3
      ffd_org_affine #(
        .FOLD(3),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 12) begin : gen_affine_by_3x2
      ffd_org_affine #(
        .FOLD(3),
        .LANES(2),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 13) begin : gen_affine_by_64
      ffd_org_affine #(
        .FOLD(64),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 14) begin : gen_affine_by_2
      ffd_org_affine #(
        .FOLD(2),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 15) begin : gen_affine_by_6
      ffd_org_affine #(
        .FOLD(6),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 16) begin : gen_affine_by_4
      ffd_org_affine #(
        .FOLD(4),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 17) begin : gen_affine_by_4x3
      ffd_org_affine #(
        .FOLD(4),
        .LANES(3),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 18) begin : gen_jacobian_by_3
      ffd_org_affine #(
        .FOLD(3),
        .JACOBIAN(1),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 20) begin : gen_jet_by_3
      ffd_org_factored #(
        .FOLD(3),
        .JACOBIAN(1),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 22) begin : gen_walk
      ffd_org_affine #(
        .FOLD(16),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else if (ORG == 23) begin : gen_walk_by_2
      ffd_org_affine #(
        .FOLD(16),
        .LANES(2),
        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
    end else begin : gen_bad_org
      ERROR_ffd_org_select_org_is_unknown u_error ();
    end
  endgenerate
endmodule

`default_nettype wire
