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
  input wire                 s_check,
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
    .s_request_check  (s_check),
    .refused_o        (refused),
    .refused_code_o   (code),
    .m_burst_valid    (m_valid),
    .m_burst_ready    (m_ready),
    .m_burst_address  (m_address),
    .m_burst_len      (m_len),
    .m_burst_last     (m_last),
    .offer_o          (offer),
    .limited_i        (offer > limit),
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
  reg                 check_q;      // it is only to be checked
  reg                 waits_q;
  reg [ADDRESS_W-1:0] waits_address_q;

  wire                take  = s_valid && s_ready;
  wire                give  = m_valid && m_ready;
  wire [W-1:0]        bytes = {{(W - 12) {1'b0}}, m_len, 4'd0} + 5'd16;
  wire [W-1:0]        after = {1'b0, m_address} + bytes;
  wire [W-1:0]        s_end = {1'b0, s_address} + {{(W - LENGTH_W) {1'b0}}, s_length};

  (* hierconn *) wire [2:0] \u_dut.state_q ;
  (* hierconn *) wire [2:0] \u_dut.code ;
  // What was only to be checked is done when it is judged.
  wire                passed = open_q && check_q && \u_dut.state_q == 3'd3 && \u_dut.code == 0;

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
      open_q   <= take || (open_q && !refused && !(give && m_last) && !passed);
      silent_q <= !open_q || m_valid || refused ? 0 : silent_q + (silent_q != 3);
    end
    if (take) begin
      check_q <= s_check;
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
  localparam BURST_W = $clog2(MAX_BURST);
  (* hierconn *) wire [ADDRESS_W-5:0] \u_dut.next_q ;
  (* hierconn *) wire [ADDRESS_W-5:0] \u_dut.last_q ;
  (* hierconn *) wire [LENGTH_W-5:0]  \u_dut.more_q ;
  (* hierconn *) wire [BURST_W-1:0]   \u_dut.left_q ;
  (* hierconn *) wire [BURST_W-1:0]   \u_dut.offer_q ;
  (* hierconn *) wire                 \u_dut.check_q ;
  (* hierconn *) wire                 \u_dut.misaligned_q ;
  (* hierconn *) wire                 \u_dut.none_q ;
  (* hierconn *) wire                 \u_dut.wraps_q ;
  (* hierconn *) wire                 \u_dut.below_q ;
  (* hierconn *) wire                 \u_dut.above_q ;
  (* hierconn *) wire                 \u_dut.same_q ;
  wire         summing   = \u_dut.state_q == 3'd1;
  wire         summed    = \u_dut.state_q == 3'd2 || \u_dut.state_q == 3'd3;
  wire         judging   = \u_dut.state_q == 3'd3;
  wire         bursting  = \u_dut.state_q == 3'd4;
  wire         moving    = \u_dut.state_q == 3'd5;
  wire         none      = \u_dut.none_q ;
  wire [W-1:0] dut_next  = {1'b0, \u_dut.next_q , 4'd0};
  wire [W-1:0] dut_last  = {1'b0, \u_dut.last_q , 4'd0} + 5'd16;
  wire [W-1:0] dut_sum   = {\u_dut.wraps_q , \u_dut.last_q , 4'd0} + 5'd16;
  wire [W-1:0] dut_bytes = {{(W - LENGTH_W) {1'b0}}, \u_dut.more_q , 4'd0} + 5'd16;
  wire [W-1:0] beyond    = {1'b0, window_last} + 1'b1;
  wire         below     = next_q < {1'b0, window_first};
  wire         misfit    = none || below || end_q > beyond;
  wire         block     = (next_q >> (BURST_W + 4)) == ((end_q - 1'b1) >> (BURST_W + 4));
  wire [BURST_W-1:0] left = \u_dut.last_q [BURST_W-1:0] - \u_dut.next_q [BURST_W-1:0];

  wire same_open  = open_q == (\u_dut.state_q != 0 || refused) && \u_dut.state_q < 6
                 && (\u_dut.state_q == 0 || \u_dut.check_q == check_q);
  // The request: what is behind next_q is shorter than the longest request.
  wire same_claim = \u_dut.misaligned_q ? bad_q : dut_next == next_q && bad_q == misfit
                                                && (none ? end_q == next_q : next_q < end_q)
                                                && end_q - next_q < (65'd1 << LENGTH_W);
  wire same_first = \u_dut.misaligned_q || none || end_q == next_q + dut_bytes;
  wire same_sum   = \u_dut.misaligned_q || none || (dut_sum == end_q && \u_dut.below_q == below);
  wire same_judge = \u_dut.misaligned_q || none || \u_dut.wraps_q
                 || (\u_dut.above_q == (end_q > beyond) && \u_dut.same_q == block
                     && \u_dut.left_q == left);
  wire same_rest  = !bad_q && !check_q && !\u_dut.misaligned_q && !none && !\u_dut.wraps_q
                 && !\u_dut.below_q && dut_last == end_q && next_q < end_q
                 && end_q - next_q < (65'd1 << LENGTH_W)
                 && {1'b0, window_first} <= next_q && end_q <= beyond;
  wire same_burst = dut_next == next_q && \u_dut.same_q == block
                 && \u_dut.offer_q == (block ? left : ~\u_dut.next_q [BURST_W-1:0]);
  wire same_next  = dut_next + dut_bytes == next_q && \u_dut.more_q < MAX_BURST;
  wire same       = same_open && (!(summing || summed) || same_claim) && (!summing || same_first)
                 && (!summed || same_sum) && (!judging || same_judge)
                 && (!(bursting || moving) || same_rest) && (!bursting || same_burst)
                 && (!moving || same_next) && (!refused || (bad_q && \u_dut.state_q == 0));

  always @* if (!first_q && !rst) begin
    if (m_valid) begin
      window: assert (m_address >= window_first && after <= {1'b0, window_last} + 1'b1);
      boundary: assert ((m_address[11:0] + bytes[12:0]) <= 13'd4096 && m_len < MAX_BURST);
      whole: assert ({1'b0, m_address} == next_q && after <= end_q && m_last == (after == end_q));
      limit_kept: assert (m_len <= limit);
    end
    refusal: assert (!open_q || !(m_valid && (bad_q || check_q)) && !(refused && !bad_q) && !(passed && bad_q));
    once: assert (open_q ? !s_ready && !(m_valid && refused) : !m_valid && !refused);
    stable: assert (!waits_q || (m_valid && m_address == waits_address_q));
    live_answer: assert (!open_q || m_valid || refused || silent_q < 3);
    live_next: assert (open_q || s_ready);
    copy: assert (same);
  end
endmodule

`default_nettype wire
