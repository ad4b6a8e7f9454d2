// ffd_stream_deep_fifo: first in, first out in block memory, DEPTH words
//
// For depths at which ffd_stream_fifo's combinational read would be large. The memory's own output
// register holds the word that is offered, so one more than DEPTH are inside. With EARLY what
// s_word_ready says is worked out a clock before, so that it leaves a register: 0 while DEPTH - 1
// words were there, so that one fewer may have to do. With COUNTED whoever sends counts the room
// (never more than DEPTH words sent and not taken), and s_word_ready is 1.
//
// Pipeline:   2 clocks from in to out, II 1.  Freezes: s_ready is 0 when full. valid and ready
//             come from registers; m_word_ready reaches the memory's read enable, no output.
// Parameters: WIDTH >= 1, DEPTH a power of two >= 2, with EARLY >= 4; EARLY, COUNTED 0 or 1.
// Model:      none (transport only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_stream_deep_fifo #(
  parameter WIDTH     = 128,
  parameter DEPTH     = 512,
  parameter EARLY     = 0,
  parameter COUNTED   = 0,
  parameter ADDRESS_W = $clog2(DEPTH)
) (
  input  wire             clk,
  input  wire             rst,
  input  wire             s_word_valid,
  output wire             s_word_ready,
  input  wire [WIDTH-1:0] s_word_data,
  output reg              m_word_valid,
  input  wire             m_word_ready,
  output wire [WIDTH-1:0] m_word_data
);
  generate
    if (DEPTH < 2 + 2 * EARLY || (1 << ADDRESS_W) != DEPTH) begin : gen_bad_depth
      ERROR_ffd_stream_deep_fifo_depth_must_be_a_power_of_two u_error ();
    end
  endgenerate

  // One more bit than the address: equal pointers are empty, pointers DEPTH apart full. The word
  // that is offered has left the memory for its register, and the pointer is one ahead of it.
  reg  [ADDRESS_W:0] write_q;
  reg  [ADDRESS_W:0] read_q;
  wire               push = s_word_valid && s_word_ready;
  wire               load = !m_word_valid || m_word_ready;
  wire               some = read_q != write_q;

  generate
    if (COUNTED) begin : gen_counted
      assign s_word_ready = 1'b1;
    end else if (EARLY) begin : gen_early
      // A word may come in the clock in which they are counted, and one in that of the answer.
      reg                ready_q;
      wire [ADDRESS_W:0] level = write_q - read_q;
      always @(posedge clk) ready_q <= !rst && !level[ADDRESS_W] && !(&level[ADDRESS_W-1:0]);
      assign s_word_ready = ready_q;
    end else begin : gen_exact
      assign s_word_ready = write_q != {!read_q[ADDRESS_W], read_q[ADDRESS_W-1:0]};
    end
  endgenerate

  always @(posedge clk) begin
    if (rst) begin
      write_q      <= {(ADDRESS_W + 1) {1'b0}};
      read_q       <= {(ADDRESS_W + 1) {1'b0}};
      m_word_valid <= 1'b0;
    end else begin
      if (push) write_q <= write_q + 1'b1;
      if (load && some) read_q <= read_q + 1'b1;
      if (load) m_word_valid <= some;
    end
  end

  ffd_mem_sdp #(
    .WIDTH       (WIDTH),
    .DEPTH       (DEPTH),
    .READ_LATENCY(1)
  ) u_memory (
    .clk            (clk),
    .write_i        (push),
    .write_address_i(write_q[ADDRESS_W-1:0]),
    .write_data_i   (s_word_data),
    .read_i         (load),
    .read_address_i (read_q[ADDRESS_W-1:0]),
    .read_data_o    (m_word_data)
  );
endmodule

`default_nettype wire
