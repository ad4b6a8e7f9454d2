// hwffd_scatter: the transpose of the evaluator between two AXI4-Streams
//
// Gradients of vertices in, sums at their control points out (docs/numerics.md section 11): opcodes
// 1, 10 and 11 of docs/interface.md section 2. All others are unknown. A vertex takes three clocks.
// With ROWS 1 a row of a grid takes as many as it has vertices, or three for each layer of control
// points that it touches, whichever is more; its sums are those of section 11, Rows.
//
// Formats:    128-bit beats, four little-endian words; fixed-point words (interface.md section 3).
// Pipeline:   ffd_scatter_decoder, ffd_scatter_core, ffd_scatter_encoder, which see.
// Freezes:    a stalled output holds back the collect that is under way, nothing else.
// Bad input:  nothing can hang it; see the decoder. event_o has a pulse for each kind; wait_o says
//             what waits, bit 0 a header for what is inside, bit 1 a vertex for room, bit 2 never;
//             idle_o: no packet, vertex or collect is under way, no page is swept.
// Parameters: FORMAT 12 to 18, fixed point; EVALUATOR pipelined or powers; latencies as in the
//             rows of affine in configurations.csv; AXIS 4 to 32, the most points an axis; PAGES 1
//             to 256; WAITING a power of two >= 2, the most vertices in front of the datapath;
//             BESIDE 1: an evaluator is on the same stream (hwffd_adjoint), which tells of
//             coefficients and of all other packets; ROWS 0 or 1; RESET_REGISTER as in
//             hwffd_stream.
// Model:      golden/include/hwffd/model/scatter_stream.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_scatter.vh"
`include "ffd_stream.vh"

module hwffd_scatter #(
  parameter FORMAT         = 17,
  parameter EVALUATOR      = `FFD_EVALUATOR_PIPELINED,
  parameter MUL_LATENCY    = 4,
  parameter ADD_LATENCY    = 1,
  parameter AXIS           = 16,
  parameter PAGES          = 2,
  parameter WAITING        = 16,
  parameter BESIDE         = 0,
  parameter ROWS           = 0,
  parameter RESET_REGISTER = 0
) (
  input  wire         aclk,
  input  wire         aresetn,
  input  wire         s_axis_tvalid,
  output wire         s_axis_tready,
  input  wire [127:0] s_axis_tdata,
  input  wire         s_axis_tlast,
  output wire         m_axis_tvalid,
  input  wire         m_axis_tready,
  output wire [127:0] m_axis_tdata,
  output wire         m_axis_tlast,
  output wire         m_axis_tuser,  // with the last beat of a packet with the flag I
  output wire [`FFD_EVENTS-1:0] event_o,
  output wire [31:0]  event_packet_o,
  output wire [31:0]  event_beat_o,
  output wire [2:0]   wait_o,
  output wire         idle_o
);
  localparam WEIGHT_W = `FFD_WEIGHT_W(FORMAT);
  localparam POINT_W  = `FFD_POINT_W(FORMAT);
  localparam PAGE_W   = `FFD_PAGE_NUMBER_W(PAGES);
  localparam PLACE_W  = 3 * `FFD_AXIS_W(AXIS);
  localparam INSIDE   = WAITING
                      + `FFD_SCATTER_MOVING(ROWS, EVALUATOR, MUL_LATENCY, ADD_LATENCY);

  wire clk = aclk;
  wire rst;
  wire unused_differs;  // 0: its register is not held three times

  wire                              load;
  wire [1:0]                        load_axis;
  wire [`FFD_OWN_W(1)-1:0]          load_address;
  wire [`FFD_ENTRY_W(WEIGHT_W)-1:0] load_entry;
  wire                              vertex_valid;
  wire                              vertex_ready;
  wire [3*WEIGHT_W-1:0]             vertex_coordinates;
  wire [PLACE_W-1:0]                vertex_cell;
  wire [3*`FFD_PLACE_W(1)-1:0]      vertex_bank;
  wire [1:0]                        vertex_along;
  wire [PAGE_W-1:0]                 vertex_page;
  wire [3*POINT_W-1:0]              vertex_gradient;
  wire                              vertex_saturated;
  wire                              vertex_last;
  wire                              added;
  wire [PAGE_W-1:0]                 added_page;
  wire                              added_saturated;
  wire                              leaves;
  wire                              layer_saturated;
  wire [PAGE_W-1:0]                 layer_page;
  wire                              begins;
  wire [PAGE_W-1:0]                 begin_page;
  wire                              sweeping;
  wire                              collect_valid;
  wire                              collect_ready;
  wire [PAGE_W-1:0]                 collect_page;
  wire [1:0]                        collect_shift;
  wire [PLACE_W-1:0]                collect_tops;
  wire [15:0]                       collect_tag;
  wire [1:0]                        collect_flags;
  wire [1:0]                        collect_status;
  wire                              collected;
  wire                              core_collecting;
  wire [PAGE_W-1:0]                 core_collecting_page;
  wire                              word_valid;
  wire                              word_ready;
  wire [95:0]                       word;
  wire                              word_saturated;
  wire                              word_last;
  wire                              saturates;
  wire                              decoder_idle, core_idle, encoder_idle;
  wire [1:0]                        waits;
  wire [`FFD_EVENTS-1:0]            decoder_event;

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
    .WIDTH(129)
  ) u_check_in (
    .clk      (clk),
    .rst      (rst),
    .valid_i  (s_axis_tvalid),
    .ready_i  (s_axis_tready),
    .payload_i({s_axis_tlast, s_axis_tdata})
  );

  ffd_channel_check #(
    .WIDTH(130)
  ) u_check_out (
    .clk      (clk),
    .rst      (rst),
    .valid_i  (m_axis_tvalid),
    .ready_i  (m_axis_tready),
    .payload_i({m_axis_tuser, m_axis_tlast, m_axis_tdata})
  );

  ffd_stream_packet_check u_check_packets (
    .clk        (clk),
    .rst        (rst),
    .grid_stop_i(1'b0),
    .event_i    (event_o),
    .packet_i   (event_packet_o),
    .beat_i     (event_beat_o)
  );

  ffd_scatter_decoder #(
    .FORMAT   (FORMAT),
    .EVALUATOR(EVALUATOR),
    .AXIS     (AXIS),
    .PAGES    (PAGES),
    .WAITING  (WAITING),
    .INSIDE   (INSIDE),
    .BESIDE   (BESIDE),
    .ROWS     (ROWS)
  ) u_decoder (
    .clk                 (clk),
    .rst                 (rst),
    .s_beat_valid        (s_axis_tvalid),
    .s_beat_ready        (s_axis_tready),
    .s_beat_data         (s_axis_tdata),
    .s_beat_last         (s_axis_tlast),
    .load_o              (load),
    .load_axis_o         (load_axis),
    .load_address_o      (load_address),
    .load_entry_o        (load_entry),
    .m_vertex_valid      (vertex_valid),
    .m_vertex_ready      (vertex_ready),
    .m_vertex_coordinates(vertex_coordinates),
    .m_vertex_cell       (vertex_cell),
    .m_vertex_bank       (vertex_bank),
    .m_vertex_along      (vertex_along),
    .m_vertex_page       (vertex_page),
    .m_vertex_gradient   (vertex_gradient),
    .m_vertex_saturated  (vertex_saturated),
    .m_vertex_last       (vertex_last),
    .added_i             (added),
    .added_page_i        (added_page),
    .added_saturated_i   (added_saturated),
    .left_i              (leaves),
    .layer_saturated_i   (layer_saturated),
    .layer_page_i        (layer_page),
    .begin_o             (begins),
    .begin_page_o        (begin_page),
    .sweeping_i          (sweeping),
    .m_collect_valid     (collect_valid),
    .m_collect_ready     (collect_ready),
    .m_collect_page      (collect_page),
    .m_collect_shift     (collect_shift),
    .m_collect_tops      (collect_tops),
    .collect_tag_o       (collect_tag),
    .collect_flags_o     (collect_flags),
    .collect_status_o    (collect_status),
    .collected_i         (collected),
    .event_o             (decoder_event),
    .event_packet_o      (event_packet_o),
    .event_beat_o        (event_beat_o),
    .wait_o              (waits),
    .idle_o              (decoder_idle)
  );

  ffd_scatter_core #(
    .FORMAT     (FORMAT),
    .EVALUATOR  (EVALUATOR),
    .MUL_LATENCY(MUL_LATENCY),
    .ADD_LATENCY(ADD_LATENCY),
    .AXIS       (AXIS),
    .PAGES      (PAGES),
    .ROWS       (ROWS)
  ) u_core (
    .clk                 (clk),
    .rst                 (rst),
    .load_i              (load),
    .load_axis_i         (load_axis),
    .load_address_i      (load_address),
    .load_entry_i        (load_entry),
    .s_vertex_valid      (vertex_valid),
    .s_vertex_ready      (vertex_ready),
    .s_vertex_coordinates(vertex_coordinates),
    .s_vertex_cell       (vertex_cell),
    .s_vertex_bank       (vertex_bank),
    .s_vertex_along      (vertex_along),
    .s_vertex_page       (vertex_page),
    .s_vertex_gradient   (vertex_gradient),
    .s_vertex_saturated  (vertex_saturated),
    .s_vertex_last       (vertex_last),
    .added_o             (added),
    .added_page_o        (added_page),
    .added_saturated_o   (added_saturated),
    .left_o              (leaves),
    .layer_saturated_o   (layer_saturated),
    .layer_page_o        (layer_page),
    .begin_i             (begins),
    .begin_page_i        (begin_page),
    .sweeping_o          (sweeping),
    .s_collect_valid     (collect_valid),
    .s_collect_ready     (collect_ready),
    .s_collect_page      (collect_page),
    .s_collect_shift     (collect_shift),
    .s_collect_tops      (collect_tops),
    .m_word_valid        (word_valid),
    .m_word_ready        (word_ready),
    .m_word_data         (word),
    .m_word_saturated    (word_saturated),
    .m_word_last         (word_last),
    .collecting_o        (core_collecting),
    .collecting_page_o   (core_collecting_page),
    .idle_o              (core_idle)
  );

  ffd_scatter_encoder u_encoder (
    .clk             (clk),
    .rst             (rst),
    .tag_i           (collect_tag),
    .flags_i         (collect_flags),
    .status_i        (collect_status),
    .s_word_valid    (word_valid),
    .s_word_ready    (word_ready),
    .s_word_data     (word),
    .s_word_saturated(word_saturated),
    .s_word_last     (word_last),
    .saturated_o     (saturates),
    .collected_o     (collected),
    .idle_o          (encoder_idle),
    .m_beat_valid    (m_axis_tvalid),
    .m_beat_ready    (m_axis_tready),
    .m_beat_data     (m_axis_tdata),
    .m_beat_last     (m_axis_tlast),
    .m_beat_mark     (m_axis_tuser)
  );

  // Of a word that leaves, a vertex that has added and a layer: those of a clock are one pulse.
  reg saturated_q;
  always @(posedge clk) begin
    saturated_q <= (saturates || (added && added_saturated) || layer_saturated) && !rst;
  end
  wire [`FFD_EVENTS-1:0] saturated = {{(`FFD_EVENTS - 1) {1'b0}}, saturated_q};

  assign event_o = decoder_event | saturated << `FFD_EVENT_SATURATED;
  assign wait_o  = {1'b0, waits};
  assign idle_o  = decoder_idle && core_idle && encoder_idle && !sweeping && !saturated_q;
  wire unused_ok = &{1'b0, core_collecting, core_collecting_page};
endmodule

`default_nettype wire
