// properties_queue: what every queue with valid and ready must do, whatever its depth
//
// One beat, chosen freely, is followed through the queue: as many beats as were inside when it came
// in must come out, then it, unchanged. As every beat may be the one, order, loss, doubling and
// contents are all in `data` and `count`.
//
// Parameters: CAPACITY, the most beats inside; LATENCY, clocks from a beat's entry to the clock in
//             which it is offered if nothing is before it; WAIT, clocks with room in which ready
//             may be 0 (after reset, or after a full queue has moved).
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module properties_queue #(
  parameter WIDTH    = 4,
  parameter CAPACITY = 2,
  parameter LATENCY  = 1,
  parameter WAIT     = 0,
  parameter COUNT_W  = $clog2(CAPACITY + 2)
) (
  input wire             clk,
  input wire             rst,
  input wire             s_valid,
  input wire             s_ready,
  input wire [WIDTH-1:0] s_data,
  input wire             m_valid,
  input wire             m_ready,
  input wire [WIDTH-1:0] m_data,
  input wire             follow_i
);
  wire take = s_valid && s_ready;
  wire give = m_valid && m_ready;

  reg               first_q = 1'b1;
  reg               rst_q;
  reg               offered_q;
  reg [WIDTH-1:0]   offered_data_q;
  reg [COUNT_W-1:0] inside_q;
  reg               follow_q;
  reg               gone_q;
  reg [COUNT_W-1:0] before_q;
  reg [WIDTH-1:0]   data_q;
  reg [3:0]         hidden_q;    // clocks in which a beat was inside and none was offered
  reg [3:0]         refused_q;   // clocks with room and without ready

  always @(posedge clk) begin
    first_q        <= 1'b0;
    rst_q          <= rst;
    offered_q      <= m_valid && !m_ready && !rst;
    offered_data_q <= m_data;
    if (rst) begin
      inside_q  <= 0;
      follow_q  <= 1'b0;
      gone_q    <= 1'b0;
      hidden_q  <= 0;
      refused_q <= 0;
    end else begin
      inside_q <= inside_q + take - give;
      if (take && follow_i && !follow_q) begin
        follow_q <= 1'b1;
        before_q <= inside_q - give;
        data_q   <= s_data;
      end else if (give && follow_q) begin
        if (before_q == 0) gone_q <= 1'b1;
        before_q <= before_q - 1'b1;
      end
      hidden_q  <= m_valid || inside_q == 0 ? 0 : hidden_q + (hidden_q != 15);
      refused_q <= s_ready || inside_q >= CAPACITY ? 0 : refused_q + (refused_q != 15);
    end
  end

  always @* if (first_q) assume (rst);

  always @* if (!first_q && !rst) begin
    count: assert (inside_q <= CAPACITY && !(m_valid && inside_q == 0));
    if (follow_q && !gone_q) begin
      data: assert (!(m_valid && before_q == 0) || m_data == data_q);
    end
    stable: assert (!offered_q || (m_valid && m_data == offered_data_q));
    live_out: assert (inside_q == 0 || m_valid || hidden_q + 1 < LATENCY);
    live_in: assert (inside_q >= CAPACITY || s_ready || refused_q < WAIT);
  end

  always @* if (!first_q) begin
    reset: assert (!rst_q || !m_valid);
  end
endmodule

`default_nettype wire
