// ffd_eval_coefficient_file: the polynomial coefficient register file (paper, section 3.3.3)
//
// One entry is a blending function: the coefficients of 1, x, x^2, x^3 and the shift of its bank,
// which the four functions of a bank share: it is kept once, and the last one that came counts.
// PORTS 4:    each power has a read port with its own address, because a pipelined evaluator uses
//             the powers of one polynomial at different times.
// PORTS 1:    one address for all powers: one wide memory, fewer blocks.
//
// The shift has a read port to itself.
//
// Formats:    entry {shift[1:0], c3, c2, c1, c0}; address {bank, function[1:0]}; read port p is
//             address p and coefficient p.
// Pipeline:   READ_LATENCY registers in each read; an entry written is readable in the next clock.
// Reset:      none: the contents are undefined until they are loaded.
// Parameters: FORMAT as in ffd_num.vh, PORTS 1 or 4, READ_LATENCY 0 or 1, ADDRESS_W >= 3.
// Model:      golden/include/hwffd/model/coefficients.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_coefficient_file #(
  parameter FORMAT       = 18,
  parameter PORTS        = 4,
  parameter READ_LATENCY = 0,
  parameter ADDRESS_W    = 4
) (
  input  wire                                            clk,
  input  wire                                            load_i,
  input  wire [ADDRESS_W-1:0]                            load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire [PORTS*ADDRESS_W-1:0]                      address_i,
  output wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]              coefficient_o,
  input  wire [ADDRESS_W-1:0]                            shift_address_i,
  output wire [1:0]                                      shift_o
);
  generate
    if (PORTS != 1 && PORTS != 4) begin : gen_bad_ports
      ERROR_ffd_eval_coefficient_file_ports_must_be_1_or_4 u_error ();
    end
  endgenerate

  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam PORT_W   = 4 / PORTS * WEIGHT_W;

  genvar p;
  generate
    for (p = 0; p < PORTS; p = p + 1) begin : gen_port
      ffd_mem_sdp #(
        .WIDTH       (PORT_W),
        .DEPTH       (1 << ADDRESS_W),
        .READ_LATENCY(READ_LATENCY)
      ) u_coefficients (
        .clk            (clk),
        .write_i        (load_i),
        .write_address_i(load_address_i),
        .write_data_i   (load_entry_i[p*PORT_W +: PORT_W]),
        .read_i         (1'b1),
        .read_address_i (address_i[p*ADDRESS_W +: ADDRESS_W]),
        .read_data_o    (coefficient_o[p*PORT_W +: PORT_W])
      );
    end
  endgenerate

  ffd_mem_sdp #(
    .WIDTH       (2),
    .DEPTH       (1 << (ADDRESS_W - 2)),
    .READ_LATENCY(READ_LATENCY)
  ) u_shifts (
    .clk            (clk),
    .write_i        (load_i),
    .write_address_i(load_address_i[ADDRESS_W-1:2]),
    .write_data_i   (load_entry_i[4*WEIGHT_W +: 2]),
    .read_i         (1'b1),
    .read_address_i (shift_address_i[ADDRESS_W-1:2]),
    .read_data_o    (shift_o)
  );
  wire unused_ok = &{1'b0, shift_address_i[1:0]};
endmodule

`default_nettype wire
