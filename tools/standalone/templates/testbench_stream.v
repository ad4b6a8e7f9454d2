// {{ core.prefix }}_tb: {{ sample.vertices }} vertices through {{ core.prefix }}, every beat compared
//
// It offers the beats of {{ core.prefix }}_commands.hex, in the folder where it runs, and compares what comes with
// {{ core.prefix }}_results.hex, which are the words of the bit-true model of hwffd {{ version }}. Both streams pause
// as a shift register says. At the end it prints PASS, or at the first beat that differs FAIL, and then
// its exit status is not 0.
//
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module {{ core.prefix }}_tb;
  localparam COMMANDS = {{ commands | length }};
  localparam RESULTS  = {{ results | length }};
  localparam FIRST    = {{ first }};  // commands up to the end of a vertex by itself, without pauses
  localparam VERTICES = {{ sample.vertices }};
  localparam PATIENCE = {{ patience }};  // clocks without a beat in or out, at most
  localparam QUIET    = 64;     // clocks at the end, in which no beat may come

  reg                aclk;
  reg                aresetn;
  reg                s_valid;
  wire               s_ready;
  reg  [{{ width - 1 }}:0]       s_data;
  reg                s_last;
  wire               m_valid;
  reg                m_ready;
  wire [{{ width - 1 }}:0]       m_data;
  wire               m_last;
  wire               m_user;
{% if halves %}
  reg                s_half;
{% endif %}
{% if keep %}
  wire [{{ width // 8 - 1 }}:0]        m_keep;
{% endif %}
  wire [15:0]        events;
  wire               vertex;
  wire [1:0]         second;
  wire               idle;
  wire [31:0]        event_packet, event_beat;
  wire [2:0]         waits;
  wire               upset;

  {{ core.prefix }} u_core (
    .aclk          (aclk),
    .aresetn       (aresetn),
    .s_axis_tvalid (s_valid),
    .s_axis_tready (s_ready),
    .s_axis_tdata  (s_data),
{% if keep %}
    .s_axis_tkeep  ({{ keep }}),
{% endif %}
    .s_axis_tlast  (s_last),
    .m_axis_tvalid (m_valid),
    .m_axis_tready (m_ready),
    .m_axis_tdata  (m_data),
{% if keep %}
    .m_axis_tkeep  (m_keep),
{% endif %}
    .m_axis_tlast  (m_last),
    .m_axis_tuser  (m_user),
    .grid_stop_i   (1'b0),
    .event_o       (events),
    .event_packet_o(event_packet),
    .event_beat_o  (event_beat),
    .vertex_o      (vertex),
    .second_o      (second),
    .wait_o        (waits),
    .idle_o        (idle),
    .upset_o       (upset)
  );

  reg [{{ width + 3 }}:0] commands [0:COMMANDS-1];  // {flags, data}; flags: bit 0 tlast, 1 tuser, 2 no upper half
  reg [{{ width + 3 }}:0] expected [0:RESULTS-1];
  reg [31:0]  shifted;
  integer     sent;
  integer     checked;
  integer     vertices;
  integer     clocks;
  integer     still;
  integer     entered;
  integer     latency;
  reg         alone_q;  // that vertex has its result

  // For half of the time each stream is without pauses.
  wire offers = sent < FIRST || (alone_q && (shifted[1:0] != 2'd0 || clocks[9]));
  wire takes  = !alone_q || shifted[9:8] != 2'd1 || clocks[8];
  wire in     = (s_valid && s_ready) === 1'b1;
  wire out    = (m_valid && m_ready) === 1'b1;
  wire [{{ width + 3 }}:0] wanted = expected[checked < RESULTS ? checked : 0];
  wire unused_ok = &{1'b0, events, event_packet, event_beat, waits, upset, second[1], wanted[{{ width + 3 }}:{{ width }}]};
  wire same   = m_last === wanted[{{ width }}] && m_user === wanted[{{ width + 1 }}] &&
                {{ compared }};

  initial begin
    $readmemh("{{ core.prefix }}_commands.hex", commands);
    $readmemh("{{ core.prefix }}_results.hex", expected);
    if (^commands[0] === 1'bx || ^expected[0] === 1'bx) begin
      $display("FAIL {{ core.prefix }}_commands.hex and {{ core.prefix }}_results.hex must be in the folder where this runs");
      $stop;
    end
    aresetn  = 1'b0;
    s_valid  = 1'b0;
    s_data   = {{ zeros }};
    s_last   = 1'b0;
{% if halves %}
    s_half   = 1'b0;
{% endif %}
    m_ready  = 1'b0;
    shifted  = 32'h2545F491;
    sent     = 0;
    checked  = 0;
    vertices = 0;
    clocks   = 0;
    still    = 0;
    entered  = 0;
    latency  = 0;
    alone_q  = 1'b0;
  end

  initial begin
    aclk = 1'b0;
    forever #5 aclk = !aclk;
  end

  always @(posedge aclk) begin
    clocks  <= clocks + 1;
    shifted <= {shifted[30:0], shifted[31] ^ shifted[21] ^ shifted[1] ^ shifted[0]};
    aresetn <= clocks >= 4;
    if (aresetn) begin
      m_ready  <= takes;
      vertices <= vertices + (vertex ? 1 : 0) + (second[0] ? 1 : 0);
      still    <= in || out ? 0 : still + 1;
      entered  <= entered + (in ? 1 : 0);
      alone_q  <= alone_q || (checked != 0 && idle);
      if (in && entered == FIRST - 1) latency <= clocks;
      if (out && checked == 0) latency <= clocks - latency;
      if (!s_valid || s_ready) begin
        s_valid <= 1'b0;
        if (sent < COMMANDS && offers) begin
          s_valid <= 1'b1;
          s_last  <= commands[sent][{{ width }}];
{% if halves %}
          s_half  <= commands[sent][{{ width + 2 }}];
{% endif %}
          s_data  <= commands[sent][{{ width - 1 }}:0];
          sent    <= sent + 1;
        end
      end
      if (out) begin
        checked <= checked + 1;
        if (checked >= RESULTS || !same) begin
          $display("FAIL result %0d of %0d: got last %b user %b %h, wanted last %b user %b %h", checked, RESULTS,
                   m_last, m_user, m_data, wanted[{{ width }}], wanted[{{ width + 1 }}], wanted[{{ width - 1 }}:0]);
          $stop;
        end
      end
      if (still == PATIENCE) begin
        $display("FAIL nothing moves: %0d of %0d commands sent, %0d of %0d results checked", sent, COMMANDS,
                 checked, RESULTS);
        $stop;
      end
      if (checked == RESULTS && sent == COMMANDS && idle && still == QUIET) begin
        if (vertices != VERTICES) begin
          $display("FAIL %0d vertices counted, %0d sent", vertices, VERTICES);
          $stop;
        end
        $display("PASS %0d vertices, %0d results, %0d clocks, latency %0d", vertices, checked, clocks, latency);
        $finish;
      end
    end
  end
endmodule

`default_nettype wire
