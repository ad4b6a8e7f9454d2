// ffd_stream_coefficients: the payload of a coefficients packet, into the bank that is not in use
//
// Twelve beats, a blending function each: axis s first, then t, u (docs/interface.md section 2),
// and twelve more for their derivatives where the header says so. The bank comes into use with the
// last.
//
// Formats:    words to weights of FORMAT; powers above an axis's degree become 0.
// Pipeline:   load_o in the clock of its beat.
// Parameters: FORMAT as in ffd_num.vh.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_stream_coefficients #(
  parameter FORMAT = 18
) (
  input  wire                                            clk,
  input  wire                                            rst,
  input  wire                                            header_i,
  input  wire                                            beat_i,
  input  wire [127:0]                                    data_i,
  output wire                                            last_o,
  output wire                                            load_o,
  output wire [1:0]                                      load_axis_o,
  output wire [3:0]                                      load_address_o,
  output wire [`FFD_ENTRY_W(`FFD_WEIGHT_W(FORMAT))-1:0]  load_entry_o,
  output wire                                            bank_o,
  output wire                                            loaded_o,
  output wire                                            derivatives_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam [3:0] LAST_FUNCTION = 4'd11;

  reg        bank_q;
  reg        loaded_q;
  reg        derivatives_q;  // of the bank in use
  reg        twice_q;        // derivatives follow in this packet
  reg        derivative_q;   // a beat of theirs
  reg  [3:0] function_q;
  reg  [5:0] degree_q;
  reg  [5:0] shift_q;
  reg  [5:0] derivative_shift_q;
  wire       last_function = function_q == LAST_FUNCTION;

  assign last_o        = last_function && derivative_q == twice_q;
  assign bank_o        = bank_q;
  assign loaded_o      = loaded_q;
  assign derivatives_o = derivatives_q;

  always @(posedge clk) begin
    if (rst) begin
      bank_q        <= 1'b0;
      loaded_q      <= 1'b0;
      derivatives_q <= 1'b0;
    end else if (beat_i && last_o) begin
      bank_q        <= !bank_q;
      loaded_q      <= 1'b1;
      derivatives_q <= twice_q;
    end
  end
  always @(posedge clk) begin
    if (header_i) begin
      function_q         <= 4'd0;
      derivative_q       <= 1'b0;
      degree_q           <= data_i[69:64];
      shift_q            <= data_i[77:72];
      derivative_shift_q <= data_i[85:80];
      twice_q            <= data_i[95];
    end else if (beat_i) begin
      function_q   <= last_function ? 4'd0 : function_q + 4'd1;
      derivative_q <= derivative_q || last_function;
    end
  end

  wire [1:0] axis  = function_q[3:2];
  wire [2:0] terms = {1'b0, degree_q[2*axis +: 2]} + 3'd1;
  wire [5:0] shift = derivative_q ? derivative_shift_q : shift_q;
  assign load_o         = beat_i;
  assign load_axis_o    = axis;
  assign load_address_o = {derivative_q, !bank_q, function_q[1:0]};
  assign load_entry_o[4*WEIGHT_W +: 2] = shift[2*axis +: 2];

  genvar p;
  generate
    for (p = 0; p < 4; p = p + 1) begin : gen_power
      localparam [2:0] POWER = p;
      wire [WEIGHT_W-1:0] number;
      ffd_num_in #(
        .FORMAT(FORMAT),
        .ROLE  (`FFD_ROLE_COEFFICIENT)
      ) u_in (
        .word_i    (data_i[32*p +: 32]),
        .exponent_i({`FFD_EXPONENT_W{1'b0}}),
        .number_o  (number)
      );
      assign load_entry_o[p*WEIGHT_W +: WEIGHT_W] = terms > POWER ? number : {WEIGHT_W{1'b0}};
    end
  endgenerate
endmodule

`default_nettype wire
