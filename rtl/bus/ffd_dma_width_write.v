// ffd_dma_width_write: beats of 16 bytes to write data of a bus of DATA_WIDTH bits
//
// 64:  a beat is two of the bus, the lower half first.
// 128: wires, all bytes written.
// 256: two beats are one of the bus. s_beat_upper: it is the upper half. A burst that begins with
//      an upper half, or ends with a lower one, writes half of that beat.
//
// Pipeline:   64 and 256: 1 clock from the beat that completes one of the bus. 64: a beat of the
//             bus each clock; 256: one every second clock. The bus gets its valid, data, strobes
//             and last from registers; 128: from those before.
// Parameters: DATA_WIDTH 64, 128 or 256.
// Model:      none (transport only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module ffd_dma_width_write #(
  parameter DATA_WIDTH = 128
) (
  input  wire                    clk,
  input  wire                    rst,
  input  wire                    s_beat_valid,
  output wire                    s_beat_ready,
  input  wire [127:0]            s_beat_data,
  input  wire                    s_beat_last,
  input  wire                    s_beat_upper,
  output wire                    m_axi_wvalid,
  input  wire                    m_axi_wready,
  output wire [DATA_WIDTH-1:0]   m_axi_wdata,
  output wire [DATA_WIDTH/8-1:0] m_axi_wstrb,
  output wire                    m_axi_wlast
);
  generate
    if (DATA_WIDTH != 64 && DATA_WIDTH != 128 && DATA_WIDTH != 256) begin : gen_bad_width
      ERROR_ffd_dma_width_write_data_width_must_be_64_128_or_256 u_error ();
    end
  endgenerate

  generate
    if (DATA_WIDTH == 128) begin : gen_same
      assign s_beat_ready = m_axi_wready;
      assign m_axi_wvalid = s_beat_valid;
      assign m_axi_wdata  = s_beat_data;
      assign m_axi_wstrb  = 16'hFFFF;
      assign m_axi_wlast  = s_beat_last;
      wire unused_ok = &{1'b0, clk, rst, s_beat_upper};
    end else begin : gen_other
      reg  valid_q;
      reg  last_q;
      reg  waits_q;    // the first half of a beat has come, or of the beat that comes
      wire free = !valid_q || m_axi_wready;
      wire take = s_beat_valid && free;

      assign m_axi_wvalid = valid_q;
      assign m_axi_wlast  = last_q;

      if (DATA_WIDTH == 64) begin : gen_narrow
        reg [63:0] data_q;

        assign s_beat_ready = free && waits_q;
        assign m_axi_wdata  = data_q;
        assign m_axi_wstrb  = 8'hFF;

        always @(posedge clk) begin
          if (rst) begin
            valid_q <= 1'b0;
            waits_q <= 1'b0;
          end else begin
            if (free) valid_q <= s_beat_valid;
            if (take) waits_q <= !waits_q;
          end
        end

        always @(posedge clk) begin
          if (free) last_q <= s_beat_last && waits_q;
          if (free) data_q <= waits_q ? s_beat_data[127:64] : s_beat_data[63:0];
        end
        wire unused_ok = &{1'b0, s_beat_upper};
      end else begin : gen_wide
        reg [255:0] data_q;
        reg [1:0]   halves_q;    // {upper, lower} are there
        wire        whole = s_beat_upper || s_beat_last;

        assign s_beat_ready = free;
        assign m_axi_wdata  = data_q;
        assign m_axi_wstrb  = {{16 {halves_q[1]}}, {16 {halves_q[0]}}};

        always @(posedge clk) begin
          if (rst) begin
            valid_q <= 1'b0;
            waits_q <= 1'b0;
          end else begin
            if (free) valid_q <= s_beat_valid && whole;
            if (take) waits_q <= !whole;
          end
        end

        always @(posedge clk) begin
          if (free) last_q <= s_beat_last;
          if (take) halves_q <= {s_beat_upper, !s_beat_upper || waits_q};
          if (take && s_beat_upper) data_q[255:128] <= s_beat_data;
          if (take && !s_beat_upper) data_q[127:0] <= s_beat_data;
        end
      end
    end
  endgenerate
endmodule

`default_nettype wire
