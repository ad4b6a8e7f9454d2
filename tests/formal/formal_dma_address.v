// formal_dma_address: ffd_dma_address with any request, any window, any limit, any reset
//
// The window is any pair of addresses, held from a request's acceptance to its last burst (that is
// what the engine promises: windows are locked). A copy of the request, kept here, says what must
// come: it is wider than the address, so that nothing wraps unseen.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_dma_address #(
  parameter ADDRESS_W = 64,
  parameter LENGTH_W  = 32,
  parameter MAX_BURST = 256
) (
  input wire                 clk,
  input wire                 rst,
  input wire [ADDRESS_W-1:0] window_first,
  input wire [ADDRESS_W-1:0] window_last,
  input wire                 s_valid,
  input wire [ADDRESS_W-1:0] s_address,
  input wire [LENGTH_W-1:0]  s_length,
  input wire                 m_ready,
  input wire [7:0]           limit
);
  wire                 s_ready;
  wire                 refused;
  wire [2:0]           code;
  wire                 m_valid;
  wire [ADDRESS_W-1:0] m_address;
  wire [7:0]           m_len;
  wire                 m_last;
  wire [7:0]           offer;

  ffd_dma_address #(
    .ADDRESS_W(ADDRESS_W),
    .LENGTH_W (LENGTH_W),
    .MAX_BURST(MAX_BURST)
  ) u_dut (
    .clk              (clk),
    .rst              (rst),
    .window_first_i   (window_first),
    .window_last_i    (window_last),
    .s_request_valid  (s_valid),
    .s_request_ready  (s_ready),
    .s_request_address(s_address),
    .s_request_length (s_length),
    .refused_o        (refused),
    .refused_code_o   (code),
    .m_burst_valid    (m_valid),
    .m_burst_ready    (m_ready),
    .m_burst_address  (m_address),
    .m_burst_len      (m_len),
    .m_burst_last     (m_last),
    .offer_o          (offer),
    .limit_i          (limit)
  );

  // One bit more than an address.
  localparam W = ADDRESS_W + 1;
  reg                 first_q = 1'b1;
  reg                 open_q;       // a request is inside
  reg [1:0]           silent_q;     // clocks since it came without an answer
  reg [ADDRESS_W-1:0] window_first_q;
  reg [ADDRESS_W-1:0] window_last_q;
  reg [W-1:0]         next_q;       // first byte not yet in a burst
  reg [W-1:0]         end_q;        // first byte after the request
  reg                 bad_q;        // the request is to be refused, by definition
  reg                 waits_q;
  reg [ADDRESS_W-1:0] waits_address_q;

  wire                take  = s_valid && s_ready;
  wire                give  = m_valid && m_ready;
  wire [W-1:0]        bytes = {{(W - 12) {1'b0}}, m_len, 4'd0} + 5'd16;
  wire [W-1:0]        after = {1'b0, m_address} + bytes;
  wire [W-1:0]        s_end = {1'b0, s_address} + {{(W - LENGTH_W) {1'b0}}, s_length};

  always @(posedge clk) begin
    first_q         <= 1'b0;
    window_first_q  <= window_first;
    window_last_q   <= window_last;
    waits_q         <= m_valid && !m_ready && !rst;
    waits_address_q <= m_address;
    if (rst) begin
      open_q   <= 1'b0;
      silent_q <= 0;
    end else begin
      open_q   <= take || (open_q && !refused && !(give && m_last));
      silent_q <= !open_q || m_valid || refused ? 0 : silent_q + (silent_q != 3);
    end
    if (take) begin
      next_q <= {1'b0, s_address};
      end_q  <= s_end;
      bad_q  <= s_length == 0 || s_address[3:0] != 0 || s_length[3:0] != 0
             || s_address < window_first || s_end > {1'b0, window_last} + 1'b1;
    end else if (give) begin
      next_q <= after;
    end
  end

  always @* begin
    if (first_q) assume (rst);
    // From acceptance on the window stays.
    if (!first_q && open_q) begin
      assume (window_first == window_first_q && window_last == window_last_q);
    end
  end

  // What keeps the copy and the module together, stated so that each property is one step away.
  (* hierconn *) wire [ADDRESS_W-5:0] \u_dut.next_q ;
  (* hierconn *) wire [ADDRESS_W-5:0] \u_dut.last_q ;
  (* hierconn *) wire [LENGTH_W-5:0]  \u_dut.beats_q ;
  (* hierconn *) wire                 \u_dut.misaligned_q ;
  (* hierconn *) wire                 \u_dut.wraps_q ;
  (* hierconn *) wire [1:0]           \u_dut.state_q ;
  wire         bursting  = \u_dut.state_q == 2'd3;
  wire         judging   = \u_dut.state_q == 2'd1 || \u_dut.state_q == 2'd2;
  wire         summed    = \u_dut.state_q == 2'd2;
  wire         none      = \u_dut.beats_q == 0;
  wire [W-1:0] dut_next  = {1'b0, \u_dut.next_q , 4'd0};
  wire [W-1:0] dut_last  = {1'b0, \u_dut.last_q , 4'd0} + 5'd16;
  wire [W-1:0] dut_sum   = {\u_dut.wraps_q , \u_dut.last_q , 4'd0} + 5'd16;
  wire [W-1:0] dut_bytes = {{(W - LENGTH_W) {1'b0}}, \u_dut.beats_q , 4'd0};
  wire [W-1:0] beyond    = {1'b0, window_last} + 1'b1;
  wire         misfit    = none || next_q < {1'b0, window_first} || end_q > beyond;

  wire same_open  = open_q == (\u_dut.state_q != 0 || refused);
  wire same_claim = \u_dut.misaligned_q ? bad_q : dut_next == next_q && end_q == next_q + dut_bytes
                                                && bad_q == misfit;
  wire same_sum   = \u_dut.misaligned_q || none || dut_sum == end_q;
  wire same_burst = !bad_q && dut_next == next_q && dut_last == end_q && next_q < end_q
                 && {1'b0, window_first} <= next_q && end_q <= beyond;
  wire same       = same_open && (!judging || same_claim) && (!summed || same_sum)
                 && (!bursting || same_burst) && (!refused || (bad_q && \u_dut.state_q == 0));


  always @* if (!first_q && !rst) begin
    if (m_valid) begin
      window: assert (m_address >= window_first && after <= {1'b0, window_last} + 1'b1);
      boundary: assert ((m_address[11:0] + bytes[12:0]) <= 13'd4096 && m_len < MAX_BURST);
      whole: assert ({1'b0, m_address} == next_q && after <= end_q && m_last == (after == end_q));
      limit_kept: assert (m_len <= limit);
    end
    refusal: assert (!open_q || !(m_valid && bad_q) && !(refused && !bad_q));
    once: assert (open_q ? !s_ready && !(m_valid && refused) : !m_valid && !refused);
    stable: assert (!waits_q || (m_valid && m_address == waits_address_q));
    live_answer: assert (!open_q || m_valid || refused || silent_q < 2);
    live_next: assert (open_q || s_ready);
    copy: assert (same);
  end
endmodule

`default_nettype wire
