// ffd_dma_width_read: read data of a bus of DATA_WIDTH bits to beats of 16 bytes
//
// 64:  two beats of the bus are one: the first of them rests in a register. Its response counts
//      where it is an error, else the second one's. RLAST on a first one ends the burst, too.
// 128: wires.
// 256: a beat of the bus is two, the lower half first, or one at an end of a burst that is not a
//      multiple of 32 bytes. A beat rests in a register, so that the bus gets a beat every second
//      clock and rready is 0 in the clock after one of two halves. Both have its response.
// asked_i: the address of a burst is raised in the next clock; asked_first_i and asked_last_i say
// which halves of beats of 256 bits its first and its last 16 bytes are (1 the upper one). Data
// without a burst is ignored.
//
// Pipeline:   64 and 128: none. 256: 1 clock to the lower half, 2 to the upper one. The beats of 16
//             bytes come without a gap where those of the bus do so: m_beat_ready is 1 out of
//             reset, where ffd_dma_read is behind it, and is not looked at with 256.
// Parameters: DATA_WIDTH 64, 128 or 256; OUTSTANDING as in ffd_dma_read.
// Model:      none (transport only).  Test: tests/bus/dma.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_assert.vh"

module ffd_dma_width_read #(
  parameter DATA_WIDTH  = 128,
  parameter OUTSTANDING = 8
) (
  input  wire                  clk,
  input  wire                  rst,
  input  wire                  asked_i,
  input  wire                  asked_first_i,
  input  wire                  asked_last_i,
  input  wire                  m_axi_rvalid,
  output wire                  m_axi_rready,
  input  wire [DATA_WIDTH-1:0] m_axi_rdata,
  input  wire [1:0]            m_axi_rresp,
  input  wire                  m_axi_rlast,
  output wire                  m_beat_valid,
  input  wire                  m_beat_ready,
  output wire [127:0]          m_beat_data,
  output wire [1:0]            m_beat_response,
  output wire                  m_beat_last
);
  generate
    if (DATA_WIDTH != 64 && DATA_WIDTH != 128 && DATA_WIDTH != 256) begin : gen_bad_width
      ERROR_ffd_dma_width_read_data_width_must_be_64_128_or_256 u_error ();
    end
  endgenerate

  generate
    if (DATA_WIDTH == 128) begin : gen_same
      assign m_axi_rready    = m_beat_ready;
      assign m_beat_valid    = m_axi_rvalid;
      assign m_beat_data     = m_axi_rdata;
      assign m_beat_response = m_axi_rresp;
      assign m_beat_last     = m_axi_rlast;
      wire unused_ok = &{1'b0, clk, rst, asked_i, asked_first_i, asked_last_i};
    end else begin : gen_other
      // Bursts whose last beat has not come, and their ends.
      wire queue_ready;
      wire open;
      wire first_upper;
      wire last_upper;
      wire take = m_axi_rvalid && m_axi_rready && open;
      `FFD_ASSERT(a_burst_is_asked_and_too_many_are_open, !asked_i || queue_ready)

      ffd_stream_fifo #(
        .WIDTH(2),
        .DEPTH(OUTSTANDING)
      ) u_asked (
        .clk         (clk),
        .rst         (rst),
        .s_word_valid(asked_i),
        .s_word_ready(queue_ready),
        .s_word_data ({asked_last_i, asked_first_i}),
        .m_word_valid(open),
        .m_word_ready(take && m_axi_rlast),
        .m_word_data ({last_upper, first_upper})
      );

      if (DATA_WIDTH == 64) begin : gen_narrow
        reg        upper_q;    // a first half waits
        reg [63:0] lower_q;
        reg [1:0]  response_q;

        assign m_axi_rready    = m_beat_ready;
        assign m_beat_valid    = take && (upper_q || m_axi_rlast);
        assign m_beat_data     = {m_axi_rdata, lower_q};
        assign m_beat_response = upper_q && response_q != 2'b00 ? response_q : m_axi_rresp;
        assign m_beat_last     = m_axi_rlast;

        always @(posedge clk) begin
          if (rst) upper_q <= 1'b0;
          else if (take) upper_q <= !upper_q && !m_axi_rlast;
        end

        always @(posedge clk) begin
          if (!upper_q) {response_q, lower_q} <= {m_axi_rresp, m_axi_rdata};
        end
        wire unused_ok = &{1'b0, queue_ready, first_upper, last_upper};
      end else begin : gen_wide
        reg         begun_q;     // the burst's first beat has come
        reg         ready_q;
        reg [1:0]   halves_q;    // those of the beat that are still to go: {upper, lower}
        reg [255:0] data_q;
        reg [1:0]   response_q;
        reg         last_q;
        wire        lower = begun_q || !first_upper;
        wire        upper = !lower || !m_axi_rlast || last_upper;

        assign m_axi_rready    = ready_q;
        assign m_beat_valid    = halves_q != 2'b00;
        assign m_beat_data     = halves_q[0] ? data_q[127:0] : data_q[255:128];
        assign m_beat_response = response_q;
        assign m_beat_last     = last_q && halves_q != 2'b11;

        always @(posedge clk) begin
          if (rst) begin
            begun_q  <= 1'b0;
            ready_q  <= 1'b0;
            halves_q <= 2'b00;
          end else begin
            if (take) begun_q <= !m_axi_rlast;
            ready_q  <= !(take && lower && upper);
            halves_q <= take ? {upper, lower} : {halves_q == 2'b11, 1'b0};
          end
        end

        always @(posedge clk) begin
          if (ready_q) {last_q, response_q, data_q} <= {m_axi_rlast, m_axi_rresp, m_axi_rdata};
        end
        wire unused_ok = &{1'b0, queue_ready, m_beat_ready};
      end
    end
  endgenerate
endmodule

`default_nettype wire
