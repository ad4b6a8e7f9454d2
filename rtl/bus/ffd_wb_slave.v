// ffd_wb_slave: Wishbone B4 on one side, words that are written and read on the other
//
// Classic standard cycles with registered feedback: an access begins in the clock in which cyc and
// stb are high and none is inside, and ends with one clock of ack or err, in which the master still
// holds it. What a write does and its ack appear at the same edge. A pipelined master connects with
// the wrapper of the specification (stall = cyc && !ack && !err).
//
// Responses:  ack, or err where the other side says error; the data of such a read is 0.
// Pipeline:   3 clocks from stb to ack, one access every 4. None begins in reset.
// Freezes:    never: no answer waits.
// Cuts:       everything: what goes to the bus and to the words leaves a register, and comes from
//             them into one.
// Not checked: the two low bits of an address (every access is a word; sel names the bytes, of a
//             write only). An access that its master gives up (cyc or stb falls before the answer)
//             may still act, and is not answered.
// Parameters: ADDRESS_W 3 to 64, the bits of a byte address.
// Model:      tests/bus/axil/register_model.hpp.  Test: tests/bus/wb.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_wb_slave #(
  parameter ADDRESS_W = 12
) (
  input  wire                 clk,
  input  wire                 rst,
  input  wire                 s_wb_cyc,
  input  wire                 s_wb_stb,
  input  wire                 s_wb_we,
  input  wire [ADDRESS_W-1:0] s_wb_adr,
  input  wire [31:0]          s_wb_dat_w,
  input  wire [3:0]           s_wb_sel,
  output reg  [31:0]          s_wb_dat_r,
  output reg                  s_wb_ack,
  output reg                  s_wb_err,
  output wire                 m_awake,
  output reg                  m_write_valid,
  output wire [ADDRESS_W-3:0] m_write_word,
  output reg  [31:0]          m_write_data,
  output reg  [3:0]           m_write_strobe,
  input  wire                 m_write_error,
  output reg                  m_read_valid,
  output wire [ADDRESS_W-3:0] m_read_word,
  input  wire [31:0]          m_read_data,
  input  wire                 m_read_error
);
  generate
    if (ADDRESS_W < 3 || ADDRESS_W > 64) begin : gen_bad_address
      ERROR_ffd_wb_slave_address_w_must_be_3_to_64 u_error ();
    end
  endgenerate

  // An access is held, then it acts, then it is answered: a clock each.
  reg                  held_q;
  reg                  act_q;
  reg                  write_q;
  reg                  wanted_q;   // its master has held it all the time
  reg  [ADDRESS_W-3:0] word_q;
  wire                 asked = s_wb_cyc && s_wb_stb;
  wire                 take  = asked && !held_q && !act_q && !s_wb_ack && !s_wb_err;
  wire                 error = write_q ? m_write_error : m_read_error;
  wire                 respond  = act_q && wanted_q && asked;

  // Something is asked or inside: the clock must not stop.
  assign m_awake = asked || held_q || act_q || s_wb_ack || s_wb_err;

  assign m_write_word = word_q;
  assign m_read_word  = word_q;

  always @(posedge clk) begin
    if (rst) begin
      held_q        <= 1'b0;
      act_q         <= 1'b0;
      m_write_valid <= 1'b0;
      m_read_valid  <= 1'b0;
      s_wb_ack      <= 1'b0;
      s_wb_err      <= 1'b0;
    end else begin
      held_q        <= take;
      act_q         <= held_q;
      m_write_valid <= held_q && write_q;
      m_read_valid  <= held_q && !write_q;
      s_wb_ack      <= respond && !error;
      s_wb_err      <= respond && error;
    end
  end

  always @(posedge clk) begin
    wanted_q <= take || (wanted_q && asked);
    if (take) begin
      write_q        <= s_wb_we;
      word_q         <= s_wb_adr[ADDRESS_W-1:2];
      m_write_data   <= s_wb_dat_w;
      m_write_strobe <= s_wb_sel;
    end
    if (act_q) s_wb_dat_r <= write_q || m_read_error ? 32'd0 : m_read_data;
  end

  wire unused_ok = &{1'b0, s_wb_adr[1:0]};
endmodule

`default_nettype wire
