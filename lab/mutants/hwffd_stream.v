// domain: hwffd_stream with results of 128 bits; what goes with a result or an event is 0 where there is none
// SPDX-License-Identifier: Apache-2.0
module domain (
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
  output wire         m_axis_tuser,
  input  wire         grid_stop_i,
  output wire [15:0]  event_o,
  output wire [31:0]  event_packet_o,
  output wire [31:0]  event_beat_o,
  output wire         vertex_o,
  output wire [1:0]   second_o,
  output wire [2:0]   wait_o,
  output wire         idle_o,
  output wire         upset_o
);
  wire [127:0] data;
  wire         last;
  wire         user;
  wire [31:0]  packet;
  wire [31:0]  beat;
  assign {m_axis_tdata, m_axis_tlast, m_axis_tuser} = {data, last, user} & {130{m_axis_tvalid}};
  assign {event_packet_o, event_beat_o}             = {packet, beat} & {64{event_o != 16'd0}};

  hwffd_stream u_inside (
    .aclk          (aclk),
    .aresetn       (aresetn),
    .s_axis_tvalid (s_axis_tvalid),
    .s_axis_tready (s_axis_tready),
    .s_axis_tdata  (s_axis_tdata),
    .s_axis_tlast  (s_axis_tlast),
    .m_axis_tvalid (m_axis_tvalid),
    .m_axis_tready (m_axis_tready),
    .m_axis_tdata  (data),
    .m_axis_tlast  (last),
    .m_axis_tuser  (user),
    .grid_stop_i   (grid_stop_i),
    .event_o       (event_o),
    .event_packet_o(packet),
    .event_beat_o  (beat),
    .vertex_o      (vertex_o),
    .second_o      (second_o),
    .wait_o        (wait_o),
    .idle_o        (idle_o),
    .upset_o       (upset_o)
  );
endmodule
