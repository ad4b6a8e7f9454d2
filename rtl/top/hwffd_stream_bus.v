// hwffd_stream_bus: hwffd_stream on AXI4-Streams of 64 or 256 bits
//
// A packet is a row of units of 16 bytes, which are the beats of hwffd_stream. A bus of 64 bits
// carries half a unit a beat, low half first; one of 256 bits two units, the first one low, and a
// packet with an odd number of them ends in a beat whose upper half tkeep leaves out
// (docs/interface.md section 1). With 128 bits this is hwffd_stream as it is.
//
// Formats:    beats of DATA_WIDTH bits, little-endian 32-bit words; words by FORMAT.
// Pipeline:   as hwffd_stream, a clock more on each side; with 256 bits a result waits for the next
//             one of its packet, or is the packet's last. Where ORG gives derivatives in one pass,
//             two results of a vertex with four pass in a clock, else a unit passes in each.
// Freezes:    as hwffd_stream.
// Not checked: of s_axis_tkeep nothing but bit 16 of a packet's last beat, with 256 bits, is looked
//             at: 0 there leaves out the upper half.
// Parameters: those of hwffd_stream, and DATA_WIDTH, 64, 128 or 256.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/system/width_test.cpp.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module hwffd_stream_bus #(
  parameter ORG             = 1,
  parameter N               = `FFD_ORG_N(ORG),
  parameter FORMAT          = 18,
  parameter SCHEDULE        = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR       = `FFD_EVALUATOR_ITERATIVE,
  parameter MUL_LATENCY     = 2,
  parameter ADD_LATENCY     = 1,
  parameter FMA_LATENCY     = 0,
  parameter CONVERT_LATENCY = 1,
  parameter AXIS            = 16,
  parameter PAGES           = 2,
  parameter IN_FLIGHT       = 0,
  parameter WAITING         = 16,
  parameter RESIDENT        = 1,
  parameter INTERLEAVED     = 1,
  parameter PAGED           = 0,
  parameter FOURTH          = 0,
  parameter GRIDS           = 0,
  parameter PACKED          = 0,
  parameter MARKS           = 0,
  parameter DERIVATIVES     = 0,
  parameter DETERMINANT     = 0,
  parameter HALVES          = 0,
  parameter SPANS           = 1,
  parameter GRID_LIMIT      = 48,
  parameter HARDENED        = 0,
  parameter DATA_WIDTH      = 64,
  parameter RESET_REGISTER  = 0
) (
  input  wire                    aclk,
  input  wire                    aresetn,
  input  wire                    s_axis_tvalid,
  output wire                    s_axis_tready,
  input  wire [DATA_WIDTH-1:0]   s_axis_tdata,
  input  wire [DATA_WIDTH/8-1:0] s_axis_tkeep,
  input  wire                    s_axis_tlast,
  output wire                    m_axis_tvalid,
  input  wire                    m_axis_tready,
  output wire [DATA_WIDTH-1:0]   m_axis_tdata,
  output wire [DATA_WIDTH/8-1:0] m_axis_tkeep,
  output wire                    m_axis_tlast,
  output wire                    m_axis_tuser,  // with the last beat of a packet with the flag I
  input  wire                    grid_stop_i,   // ends a grid that is under way
  output wire [`FFD_EVENTS-1:0]  event_o,
  output wire [31:0]             event_packet_o,
  output wire [31:0]             event_beat_o,
  output wire                    vertex_o,
  output wire [1:0]              second_o,
  output wire [2:0]              wait_o,
  output wire                    idle_o,
  output wire                    upset_o
);
  generate
    if (DATA_WIDTH != 64 && DATA_WIDTH != 128 && DATA_WIDTH != 256) begin : gen_bad_data_width
      ERROR_hwffd_stream_bus_data_width_must_be_64_128_or_256 u_error ();
    end
  endgenerate

  localparam FEATURES = `FFD_FEATURES_NAMED;
  localparam UNITS    = DATA_WIDTH == 256 && `FFD_TWO_RESULTS(ORG, FEATURES) ? 2 : 1;

  wire         in_valid;
  wire         in_ready;
  wire [127:0] in_data;
  wire         in_last;
  wire         out_valid;
  wire         out_ready;
  wire [128*UNITS-1:0] out_data;
  wire         out_last;
  wire         in_idle;
  wire         out_idle;
  wire         core_idle;
  wire         out_user;

  wire rst;
  wire unused_differs;  // 0: its register is not held three times

  ffd_reset_register #(
    .REGISTERED(RESET_REGISTER),
    .HARDENED  (0)
  ) u_reset (
    .clk      (aclk),
    .resetn_i (aresetn),
    .rst_o    (rst),
    .differs_o(unused_differs)
  );

  ffd_channel_check #(
    .WIDTH(DATA_WIDTH + 1)
  ) u_check_in (
    .clk      (aclk),
    .rst      (rst),
    .valid_i  (s_axis_tvalid),
    .ready_i  (s_axis_tready),
    .payload_i({s_axis_tlast, s_axis_tdata})
  );

  ffd_channel_check #(
    .WIDTH(DATA_WIDTH + DATA_WIDTH/8 + 2)
  ) u_check_out (
    .clk      (aclk),
    .rst      (rst),
    .valid_i  (m_axis_tvalid),
    .ready_i  (m_axis_tready),
    .payload_i({m_axis_tuser, m_axis_tlast, m_axis_tkeep, m_axis_tdata})
  );

  hwffd_stream #(
    .RESULT_WIDTH     (128 * UNITS),
    `include "ffd_stream_arguments.vh"
  ) u_core (
    .aclk          (aclk),
    .aresetn       (!rst),
    .s_axis_tvalid (in_valid),
    .s_axis_tready (in_ready),
    .s_axis_tdata  (in_data),
    .s_axis_tlast  (in_last),
    .m_axis_tvalid (out_valid),
    .m_axis_tready (out_ready),
    .m_axis_tdata  (out_data),
    .m_axis_tlast  (out_last),
    .m_axis_tuser  (out_user),
    .grid_stop_i   (grid_stop_i),
    .event_o       (event_o),
    .event_packet_o(event_packet_o),
    .event_beat_o  (event_beat_o),
    .vertex_o      (vertex_o),
    .second_o      (second_o),
    .wait_o        (wait_o),
    .idle_o        (core_idle),
    .upset_o       (upset_o)
  );

  assign idle_o = in_idle && out_idle && core_idle;

  generate
    if (DATA_WIDTH == 128) begin : gen_same
      assign in_valid      = s_axis_tvalid;
      assign s_axis_tready = in_ready;
      assign in_data       = s_axis_tdata;
      assign in_last       = s_axis_tlast;
      assign m_axis_tvalid = out_valid;
      assign out_ready     = m_axis_tready;
      assign m_axis_tdata  = out_data;
      assign m_axis_tkeep  = 16'hFFFF;
      assign m_axis_tlast  = out_last;
      assign m_axis_tuser  = out_user;
      assign in_idle       = 1'b1;
      assign out_idle      = 1'b1;
      wire unused_ok = &{1'b0, s_axis_tkeep};
    end else begin : gen_units
      // A bus of 64 bits has no upper unit; the bit is not looked at there.
      localparam UPPER = DATA_WIDTH == 256 ? 16 : 0;
      wire upper;

      ffd_stream_units_in #(
        .WIDTH(DATA_WIDTH)
      ) u_in (
        .clk         (aclk),
        .rst         (rst),
        .idle_o      (in_idle),
        .s_beat_valid(s_axis_tvalid),
        .s_beat_ready(s_axis_tready),
        .s_beat_data (s_axis_tdata),
        .s_beat_upper(s_axis_tkeep[UPPER]),
        .s_beat_last (s_axis_tlast),
        .m_unit_valid(in_valid),
        .m_unit_ready(in_ready),
        .m_unit_data (in_data),
        .m_unit_last (in_last)
      );

      ffd_stream_units_out #(
        .WIDTH(DATA_WIDTH),
        .UNITS(UNITS)
      ) u_out (
        .clk         (aclk),
        .rst         (rst),
        .idle_o      (out_idle),
        .s_unit_valid(out_valid),
        .s_unit_ready(out_ready),
        .s_unit_data (out_data),
        .s_unit_two  (UNITS == 2 && !out_data[128*UNITS-1]),
        .s_unit_last (out_last),
        .s_unit_user (out_user),
        .m_beat_valid(m_axis_tvalid),
        .m_beat_ready(m_axis_tready),
        .m_beat_data (m_axis_tdata),
        .m_beat_upper(upper),
        .m_beat_last (m_axis_tlast),
        .m_beat_user (m_axis_tuser)
      );

      assign m_axis_tkeep = {{(DATA_WIDTH / 16) {upper}}, {(DATA_WIDTH / 16) {1'b1}}};
      wire unused_ok = &{1'b0, s_axis_tkeep};
    end
  endgenerate
endmodule

`default_nettype wire
