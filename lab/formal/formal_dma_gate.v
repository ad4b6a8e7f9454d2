// formal_dma_gate: ffd_dma_gate with any bursts, any window, whatever becomes of the registers
// before it
//
// Until the lock the window is any pair of addresses, and no burst comes; from then on the registers
// that it came from hold anything. Nothing is said of the three copies of a burst but what two of
// them say, so that the third may hold anything in every clock.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_gate #(
  parameter DATA_WIDTH = 128
) (
  input wire        clk,
  input wire        rst,
  input wire        stop,
  input wire        go,
  input wire        locked,
  input wire [63:0] given_first,
  input wire [63:0] given_last,
  input wire        s_valid,
  input wire [63:0] s_address,
  input wire [7:0]  s_len,
  input wire        m_ready
);
  localparam BYTES = DATA_WIDTH / 8;

  wire        s_ready;
  wire        m_valid;
  wire [63:0] m_address;
  wire [7:0]  m_len;

  ffd_dma_gate #(
    .DATA_WIDTH(DATA_WIDTH)
  ) u_dut (
    .clk            (clk),
    .rst            (rst),
    .stop_i         (stop),
    .go_i           (go),
    .locked_i       (locked),
    .window_first_i (given_first),
    .window_last_i  (given_last),
    .s_burst_valid  (s_valid),
    .s_burst_ready  (s_ready),
    .s_burst_address(s_address),
    .s_burst_len    (s_len),
    .m_burst_valid  (m_valid),
    .m_burst_ready  (m_ready),
    .m_burst_address(m_address),
    .m_burst_len    (m_len)
  );

  reg         first_q = 1'b1;
  reg         locked_q;
  reg [127:0] window_q;    // as it was locked
  reg         waits_q;
  reg [71:0]  waits_burst_q;
  always @(posedge clk) begin
    first_q       <= 1'b0;
    locked_q      <= locked;
    waits_q       <= m_valid && !m_ready && !rst;
    waits_burst_q <= {m_address, m_len};
    if (!locked) window_q <= {given_last, given_first};
  end

  always @* begin
    if (first_q) assume (rst && !locked);
    else assume (locked || !locked_q);
    assume (locked || !s_valid);
  end

  (* hierconn *) wire [255:0] \u_dut.copies ;
  (* hierconn *) wire [2:0]   \u_dut.state ;
  (* hierconn *) wire [64:0]  \u_dut.last_q ;
  (* hierconn *) wire         \u_dut.inside_q ;

  // What must hold of a burst on the bus, in more bits than an address has.
  wire [64:0] beat   = {1'b0, m_address} / BYTES * BYTES;
  wire [64:0] last   = beat + m_len * BYTES;
  wire [64:0] byte_  = last + (DATA_WIDTH == 64 ? 7 : 15);
  wire        inside = m_address >= window_q[63:0] && byte_ <= {1'b0, window_q[127:64]};

  wire empty = \u_dut.state == 3'd0;
  wire sum   = \u_dut.state == 3'd1;
  wire check = \u_dut.state == 3'd2;
  wire judge = \u_dut.state == 3'd3;
  wire same  = \u_dut.copies == {2 {window_q}} && \u_dut.state < 5 && (empty || locked)
            && (!(check || judge) || \u_dut.last_q == last) && (!judge || \u_dut.inside_q == inside);

  always @* if (!first_q) begin
    copy: assert (same && (empty || sum || check || judge || inside));
    window: assert (!m_valid || inside);
    stable: assert (!waits_q || (m_valid && {m_address, m_len} == waits_burst_q));
  end
endmodule

`default_nettype wire
