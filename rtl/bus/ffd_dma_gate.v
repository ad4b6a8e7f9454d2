// ffd_dma_gate: the last check of an address before it goes out to the bus
//
// A burst {address, beats - 1} is taken, held three times, and raised on the bus only if it lies
// inside the window. The window is held three times, too: as the registers have it, and in two
// copies that no longer follow once it is locked; window_*_o is what two of them say. So an
// address that changed behind the check of ffd_dma_address goes no further than here: it is
// dropped, with refused_o, a pulse. A burst waits for go_i before it is raised (raise_o); then it
// stays until it is taken. stop_i (level): nothing is taken or raised. differs_o: a copy was
// outvoted.
//
// Pipeline:   taken, summed, checked, judged, raised: a burst in 5 clocks at least. A window that
//             is not locked is followed a clock later.
// Cuts:       everything; valid, address and length leave the gates of a majority.
// Parameters: DATA_WIDTH 64, 128 or 256. Of a beat of 256 bits the upper half may be left out: it
//             is the lower one that must be inside.
// Model:      none (control only).  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_gate #(
  parameter DATA_WIDTH = 128
) (
  input  wire        clk,
  input  wire        rst,
  input  wire        stop_i,
  input  wire        go_i,
  input  wire        locked_i,
  input  wire [63:0] window_first_i,
  input  wire [63:0] window_last_i,
  output wire [63:0] window_first_o,
  output wire [63:0] window_last_o,
  input  wire        s_burst_valid,
  output wire        s_burst_ready,
  input  wire [63:0] s_burst_address,
  input  wire [7:0]  s_burst_len,
  output wire        m_burst_valid,
  input  wire        m_burst_ready,
  output wire [63:0] m_burst_address,
  output wire [7:0]  m_burst_len,
  output wire        raise_o,
  output reg         refused_o,
  output wire        differs_o
);
  generate
    if (DATA_WIDTH != 64 && DATA_WIDTH != 128 && DATA_WIDTH != 256) begin : gen_bad_width
      ERROR_ffd_dma_gate_data_width_must_be_64_128_or_256 u_error ();
    end
  endgenerate

  localparam SIZE_W = DATA_WIDTH == 64 ? 3 : DATA_WIDTH == 256 ? 5 : 4;
  localparam [2:0] EMPTY = 3'd0;
  localparam [2:0] SUM   = 3'd1;
  localparam [2:0] CHECK = 3'd2;
  localparam [2:0] JUDGE = 3'd3;
  localparam [2:0] SEND  = 3'd4;

  wire [127:0] given = {window_last_i, window_first_i};
  wire [255:0] copies;
  wire [127:0] first    = copies[127:0];
  wire [127:0] other  = copies[255:128];
  wire [127:0] window = (first & other) | (first & given) | (other & given);
  genvar k;
  generate
    for (k = 0; k < 2; k = k + 1) begin : gen_window
      ffd_hard_copy #(
        .WIDTH(128)
      ) u_copy (
        .clk(clk),
        .d_i(locked_i ? window : given),
        .q_o(copies[128*k +: 128])
      );
    end
  endgenerate
  assign {window_last_o, window_first_o} = window;

  // Before it is locked the copies are a clock behind.
  reg  unlike_q;
  reg  locked_q;
  always @(posedge clk) begin
    unlike_q <= (first != given || other != given) && locked_i && locked_q;
    locked_q <= locked_i;
  end

  wire [2:0]  state;
  reg  [2:0]  state_d;
  wire        state_differs;
  wire [71:0] burst;
  wire        burst_differs;
  wire        take = s_burst_valid && s_burst_ready;

  assign s_burst_ready = state == EMPTY && !stop_i;
  assign m_burst_valid = state == SEND;
  assign {m_burst_address, m_burst_len} = burst;
  assign differs_o = state_differs || burst_differs || unlike_q;

  ffd_hard_triple #(
    .WIDTH(3)
  ) u_state (
    .clk      (clk),
    .d_i      (rst ? EMPTY : state_d),
    .q_o      (state),
    .differs_o(state_differs)
  );

  ffd_hard_triple #(
    .WIDTH(72)
  ) u_burst (
    .clk      (clk),
    .d_i      (take ? {s_burst_address, s_burst_len} : burst & {72{!rst}}),
    .q_o      (burst),
    .differs_o(burst_differs)
  );

  // The last beat of the burst.
  reg  [64:0] last_q;
  reg         inside_q;
  wire [63:0] first_beat = {m_burst_address[63:SIZE_W], {SIZE_W {1'b0}}};
  wire [63:0] bytes      = {{(56 - SIZE_W) {1'b0}}, m_burst_len, {SIZE_W {1'b0}}};
  wire [63:0] last_byte  = {last_q[63:4], DATA_WIDTH == 64 ? last_q[3:0] | 4'd7 : 4'd15};
  always @(posedge clk) begin
    last_q   <= {1'b0, first_beat} + {1'b0, bytes};
    inside_q <= m_burst_address >= window_first_o && last_byte <= window_last_o && !last_q[64];
  end

  assign raise_o = state == JUDGE && inside_q && go_i && !stop_i;

  always @* begin
    state_d = state;
    case (state)
      EMPTY: if (take) state_d = SUM;
      SUM: state_d = CHECK;
      CHECK: state_d = JUDGE;
      JUDGE: if (stop_i || !inside_q) state_d = EMPTY; else if (go_i) state_d = SEND;
      SEND: if (m_burst_ready) state_d = EMPTY;
      default: state_d = EMPTY;
    endcase
  end

  always @(posedge clk) refused_o <= state == JUDGE && !inside_q && !rst;
endmodule

`default_nettype wire
