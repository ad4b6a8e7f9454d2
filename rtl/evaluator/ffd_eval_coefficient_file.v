// ffd_eval_coefficient_file: the polynomial coefficient register file (paper, section 3.3.3)
//
// One entry is a blending function: the coefficients of 1, x, x^2, x^3 and the shift of its bank.
// Each power has a read port with its own address, because a pipelined evaluator uses the powers of
// one polynomial at different times; so has the shift.
//
// Formats:    entry {shift[1:0], c3, c2, c1, c0}; read port p is address p and coefficient p.
// Pipeline:   reads are combinational; an entry written is readable in the next clock.
// Reset:      none: the contents are undefined until they are loaded.
// Parameters: FORMAT as in ffd_num.vh, ADDRESS_W >= 1.
// Model:      golden/include/hwffd/model/coefficients.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_eval_coefficient_file #(
  parameter FORMAT    = 18,
  parameter ADDRESS_W = 4
) (
  input  wire                                            clk,
  input  wire                                            load_i,
  input  wire [ADDRESS_W-1:0]                            load_address_i,
  input  wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_i,
  input  wire [4*ADDRESS_W-1:0]                          address_i,
  output wire [4*`FFD_WEIGHT_W(FORMAT)-1:0]              coefficient_o,
  input  wire [ADDRESS_W-1:0]                            shift_address_i,
  output wire [1:0]                                      shift_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);

  genvar p;
  generate
    for (p = 0; p < 4; p = p + 1) begin : gen_power
      ffd_mem_sdp #(
        .WIDTH       (WEIGHT_W),
        .DEPTH       (1 << ADDRESS_W),
        .READ_LATENCY(0)
      ) u_coefficients (
        .clk            (clk),
        .write_i        (load_i),
        .write_address_i(load_address_i),
        .write_data_i   (load_entry_i[p*WEIGHT_W +: WEIGHT_W]),
        .read_address_i (address_i[p*ADDRESS_W +: ADDRESS_W]),
        .read_data_o    (coefficient_o[p*WEIGHT_W +: WEIGHT_W])
      );
    end
  endgenerate

  ffd_mem_sdp #(
    .WIDTH       (2),
    .DEPTH       (1 << ADDRESS_W),
    .READ_LATENCY(0)
  ) u_shifts (
    .clk            (clk),
    .write_i        (load_i),
    .write_address_i(load_address_i),
    .write_data_i   (load_entry_i[4*WEIGHT_W +: 2]),
    .read_address_i (shift_address_i),
    .read_data_o    (shift_o)
  );
endmodule

`default_nettype wire
