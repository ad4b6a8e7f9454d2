// formal_stream_decoder: the control of ffd_stream_decoder, with any beats whatever
//
// Beside the decoder stands a reading of docs/interface.md section 2 that only counts beats: which
// of them ends a vertex, completes coefficients or a lattice. Behind it stands an evaluator that
// holds IN_FLIGHT = 2 vertices, in order, frees the slot of an interleaved one and lets it retire
// at any later time, or never.
//
// Abstractions: two vertices behind the decoder, where the core has up to 128; numbers of vertices
// are checked by lemma, not counted out.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module formal_stream_decoder #(
  parameter FORMAT = 18,
  parameter SLOTS  = 3,
  parameter AXIS   = 16,
  parameter CLOCKS = 7,
  parameter SLOT_W = $clog2(SLOTS)
) (
  input wire         clk,
  input wire         rst,
  input wire         s_valid,
  input wire [127:0] s_data,
  input wire         s_last,
  input wire         want_vertex,
  input wire         want_free,
  input wire         want_retire
);
  wire                                       s_ready;
  wire                                       load;
  wire [3:0]                                 load_address;
  wire                                       lattice_write;
  wire                                       lattice_buffer;
  wire [11:0]                                lattice_at;
  wire                                       slot_write;
  wire [SLOT_W-1:0]                          slot;
  wire                                       m_valid;
  wire [95:0]                                m_coordinates;
  wire [11:0]                                m_cell;
  wire [SLOT_W:0]                            m_source;
  wire                                       m_bank;
  wire [1:0]                                 m_results;
  wire                                       m_changed;
  wire [`FFD_EXPONENT_W-1:0]                 m_exponent;
  wire [`FFD_USER_W-1:0]                     m_user;
  wire [31:0]                                event_packet;
  wire [31:0]                                event_beat;
  wire                                       idle;
  wire                                       m_ready;
  wire                                       free;
  wire                                       retire;
  wire [2:0]                                 retire_user;

  wire [`FFD_KIND_W-1:0] s_kind;
  ffd_stream_header #(
    .AXIS(AXIS)
  ) u_header (
    .data_i(s_data),
    .kind_o(s_kind)
  );

  ffd_stream_decoder #(
    .FORMAT   (FORMAT),
    .SLOTS    (SLOTS),
    .IN_FLIGHT(2)
  ) u_dut (
    .clk                 (clk),
    .rst                 (rst),
    .s_beat_valid        (s_valid),
    .s_beat_ready        (s_ready),
    .s_beat_data         (s_data),
    .s_beat_kind         (s_kind),
    .s_beat_last         (s_last),
    .load_o              (load),
    .load_address_o      (load_address),
    .lattice_write_o     (lattice_write),
    .lattice_buffer_o    (lattice_buffer),
    .lattice_at_o        (lattice_at),
    .slot_write_o        (slot_write),
    .slot_o              (slot),
    .m_vertex_valid      (m_valid),
    .m_vertex_ready      (m_ready),
    .m_vertex_coordinates(m_coordinates),
    .m_vertex_cell       (m_cell),
    .m_vertex_source     (m_source),
    .m_vertex_bank       (m_bank),
    .m_vertex_results    (m_results),
    .m_vertex_changed    (m_changed),
    .m_vertex_exponent   (m_exponent),
    .m_vertex_user       (m_user),
    .slot_free_i         (free),
    .retire_i            (retire),
    .retire_user_i       (retire_user),
    .event_packet_o      (event_packet),
    .event_beat_o        (event_beat),
    .idle_o              (idle)
  );

  wire take = s_valid && s_ready;

  // ---- the evaluator: the older vertex is a_, the younger b_
  reg              a_q;
  reg              a_resident_q;
  reg              a_freed_q;
  reg              a_bank_q;
  reg [SLOT_W-1:0] a_at_q;       // slot or buffer
  reg [2:0]        a_user_q;
  reg              b_q;
  reg              b_resident_q;
  reg              b_freed_q;
  reg              b_bank_q;
  reg [SLOT_W-1:0] b_at_q;
  reg [2:0]        b_user_q;
  wire             a_free = a_q && !a_resident_q && !a_freed_q;
  wire             b_free = b_q && !b_resident_q && !b_freed_q;
  wire             enter  = m_valid && m_ready;
  assign m_ready     = want_vertex && !(a_q && b_q);
  assign free        = want_free && (a_free || b_free);
  assign retire      = want_retire && a_q && !a_free;
  assign retire_user = a_user_q;

  wire b_freed = b_freed_q || (free && !a_free);

  always @(posedge clk) begin
    if (rst) begin
      a_q <= 1'b0;
      b_q <= 1'b0;
    end else if (retire) begin
      a_q          <= b_q || enter;
      a_resident_q <= b_q ? b_resident_q : m_source[SLOT_W];
      a_freed_q    <= b_q && b_freed;
      a_bank_q     <= b_q ? b_bank_q : m_bank;
      a_at_q       <= b_q ? b_at_q : m_source[SLOT_W-1:0];
      a_user_q     <= b_q ? b_user_q : m_user[`FFD_USER_RETIRE(`FFD_USER_W)];
      b_q          <= b_q && enter;
      b_freed_q    <= 1'b0;
    end else begin
      if (free && a_free) a_freed_q <= 1'b1;
      if (free && !a_free) b_freed_q <= 1'b1;
      if (enter && !a_q) begin
        a_q          <= 1'b1;
        a_resident_q <= m_source[SLOT_W];
        a_freed_q    <= 1'b0;
        a_bank_q     <= m_bank;
        a_at_q       <= m_source[SLOT_W-1:0];
        a_user_q     <= m_user[`FFD_USER_RETIRE(`FFD_USER_W)];
      end
      if (enter && a_q) b_q <= 1'b1;
      if (enter && a_q) b_freed_q <= 1'b0;
    end
    if (enter && a_q && !b_q) begin
      b_resident_q <= m_source[SLOT_W];
      b_bank_q     <= m_bank;
      b_at_q       <= m_source[SLOT_W-1:0];
      b_user_q     <= m_user[`FFD_USER_RETIRE(`FFD_USER_W)];
    end
  end

  // ---- the packets, by counting beats
  reg         first_q = 1'b1;
  reg         header_q;          // the next beat is a header
  reg [2:0]   opcode_q;          // 0: dropped
  reg         twice_q;           // derivatives behind the coefficients
  reg [31:0]  left_q;            // vertices to come
  reg [5:0]   at_q;              // beats of the vertex, or of the coefficients, so far
  reg         offer_q;           // a vertex is to be offered
  reg         bank_q;            // the coefficients in use
  reg         bank_of_q;         // those of the vertex offered
  reg         buffer_q;
  reg         buffer_of_q;
  reg         loaded_q;
  reg         loaded_of_q;
  reg [11:0]  size_q;            // points - 1 an axis of the lattice that comes
  reg [11:0]  size_0_q;          // of either buffer
  reg [11:0]  size_1_q;
  reg [6:0]   wait_q;
  wire [7:0]  opcode   = s_data[7:0];
  wire [11:0] size     = {s_data[83:80] - 4'd1, s_data[75:72] - 4'd1, s_data[67:64] - 4'd1};
  wire        good     = s_data[71:64] >= 4 && s_data[71:64] <= AXIS && s_data[79:72] >= 4
                      && s_data[79:72] <= AXIS && s_data[87:80] >= 4 && s_data[87:80] <= AXIS;
  wire        vertex   = left_q != 0
                      && (opcode_q == 3 || (opcode_q == 4 && (at_q == 48 || s_last)));
  wire        finish   = take && !header_q && vertex;
  wire        complete = take && !header_q && opcode_q == 1 && at_q == (twice_q ? 23 : 11);
  wire        filled   = take && !header_q && opcode_q == 2 && lattice_at == size_q;
  wire        willing  = want_vertex && want_free && want_retire;

  always @(posedge clk) begin
    first_q <= 1'b0;
    if (rst) begin
      header_q <= 1'b1;
      offer_q  <= 1'b0;
      bank_q   <= 1'b0;
      buffer_q <= 1'b0;
      loaded_q <= 1'b0;
      wait_q   <= 0;
    end else begin
      if (take) header_q <= s_last;
      if (finish || m_ready) offer_q <= finish;
      if (finish) begin
        bank_of_q   <= bank_q;
        buffer_of_q <= buffer_q;
        loaded_of_q <= loaded_q;
      end
      if (complete) bank_q <= !bank_q;
      if (filled) begin
        buffer_q <= !buffer_q;
        loaded_q <= 1'b1;
      end
      wait_q <= s_valid && !s_ready && willing ? wait_q + (wait_q != 127) : 0;
    end
    if (filled && !buffer_q) size_1_q <= size_q;
    if (filled && buffer_q) size_0_q <= size_q;
    if (take && header_q) begin
      opcode_q <= opcode == 1 || (opcode == 2 && good)
               || ((opcode == 3 || opcode == 4) && s_data[73:72] != 3) ? opcode[2:0] : 3'd0;
      twice_q  <= s_data[95];
      left_q   <= s_data[63:32];
      at_q     <= 0;
      size_q   <= size;
    end else if (take) begin
      if (opcode_q == 4) at_q <= vertex ? 0 : at_q + (at_q != 63);
      else at_q <= at_q + (at_q != 63);
      if (vertex) left_q <= left_q - 1'b1;
      if (complete || filled) opcode_q <= 3'd0;
    end
  end

  always @* if (first_q) assume (rst);

  // ---- one clock before, and what was written since the vertex before was offered
  localparam HELD_W = 3*`FFD_WEIGHT_W(FORMAT)+12+SLOT_W+1+1+3+`FFD_EXPONENT_W+`FFD_USER_W;
  wire [HELD_W-1:0] held_vertex = {m_coordinates, m_cell, m_source, m_bank, m_changed, m_results,
                                   m_exponent, m_user};
  reg               rst_q;
  reg               held_q;
  reg  [HELD_W-1:0] held_vertex_q;
  reg               take_q;
  reg               last_q;
  reg  [31:0]       event_packet_q;
  reg  [31:0]       event_beat_q;
  reg               written_q;
  wire              new_vertex = m_valid && !held_q;
  always @(posedge clk) begin
    rst_q          <= rst;
    held_q         <= m_valid && !m_ready && !rst;
    held_vertex_q  <= held_vertex;
    take_q         <= take;
    last_q         <= s_last;
    event_packet_q <= event_packet;
    event_beat_q   <= event_beat;
    written_q      <= rst || load || lattice_write || (written_q && !new_vertex);
  end

  // ---- the place of an event, a step from that of the clock before
  wire [31:0] next_packet = event_packet_q + (take_q && last_q);
  wire [31:0] next_beat   = !take_q ? event_beat_q : last_q ? 32'd0 : event_beat_q + 32'd1;

  (* hierconn *) wire [2:0]  \u_dut.state_q ;
  (* hierconn *) wire [31:0] \u_dut.count_q ;
  wire        m_resident = m_source[SLOT_W];
  wire        m_buffer   = m_source[0];
  wire [11:0] m_size     = m_buffer ? size_1_q : size_0_q;
  wire [14:0] beyond     = {{1'b0, m_cell[11:8]} + 5'd3, {1'b0, m_cell[7:4]} + 5'd3,
                            {1'b0, m_cell[3:0]} + 5'd3};
  wire        inside     = beyond[4:0] <= m_size[3:0] && beyond[9:5] <= m_size[7:4]
                        && beyond[14:10] <= m_size[11:8];

  // For cell_inside: the last cell is that of the buffer in use; the other is filled unread.
  (* hierconn *) wire [3:0] \u_dut.u_lattice.gen_axis[0].last_cell_q ;
  (* hierconn *) wire [3:0] \u_dut.u_lattice.gen_axis[1].last_cell_q ;
  (* hierconn *) wire [3:0] \u_dut.u_lattice.gen_axis[2].last_cell_q ;
  wire [3:0]  cell_2    = \u_dut.u_lattice.gen_axis[2].last_cell_q ;
  wire [11:0] now_size  = buffer_q ? size_1_q : size_0_q;
  wire        loading   = \u_dut.state_q == 3'd2;
  wire        same_size = (!loaded_q
                           || (now_size[3:0] >= 3 && now_size[7:4] >= 3 && now_size[11:8] >= 3
                               && \u_dut.u_lattice.gen_axis[0].last_cell_q == now_size[3:0] - 4'd3
                               && \u_dut.u_lattice.gen_axis[1].last_cell_q == now_size[7:4] - 4'd3
                               && cell_2 == now_size[11:8] - 4'd3))
                       && (!loading || (size_q[3:0] >= 3 && size_q[7:4] >= 3 && size_q[11:8] >= 3))
                       && (!(m_valid && loaded_of_q) || loaded_q);
  wire        unread    = !loading
                       || (!(a_q && a_resident_q && a_at_q[0] != buffer_q)
                           && !(b_q && b_resident_q && b_at_q[0] != buffer_q)
                           && !(m_valid && m_resident && m_buffer != buffer_q));

  // ---- what ties the decoder's registers to those above
  (* hierconn *) wire       \u_dut.resident_q ;
  (* hierconn *) wire [3:0] \u_dut.group_q ;
  (* hierconn *) wire [1:0] \u_dut.phase_q ;
  (* hierconn *) wire       \u_dut.u_coefficients.bank_q ;
  (* hierconn *) wire [3:0] \u_dut.u_coefficients.function_q ;
  (* hierconn *) wire       \u_dut.u_coefficients.twice_q ;
  (* hierconn *) wire       \u_dut.u_coefficients.derivative_q ;
  (* hierconn *) wire       \u_dut.u_lattice.buffer_q ;
  (* hierconn *) wire       \u_dut.u_lattice.loaded_q ;
  (* hierconn *) wire [3:0] \u_dut.u_lattice.gen_axis[0].top_q ;
  (* hierconn *) wire [3:0] \u_dut.u_lattice.gen_axis[1].top_q ;
  (* hierconn *) wire [3:0] \u_dut.u_lattice.gen_axis[2].top_q ;
  (* hierconn *) wire [1:0] \u_dut.u_bank_readers.gen_bank[0].inside_q ;
  (* hierconn *) wire [1:0] \u_dut.u_bank_readers.gen_bank[1].inside_q ;
  (* hierconn *) wire [1:0] \u_dut.u_buffer_readers.gen_bank[0].inside_q ;
  (* hierconn *) wire [1:0] \u_dut.u_buffer_readers.gen_bank[1].inside_q ;
  (* hierconn *) wire [SLOT_W:0] \u_dut.used_q ;

  reg  same_state;
  wire is_vertex = opcode_q == 3 || opcode_q == 4;
  wire same_left = is_vertex && left_q != 0 && \u_dut.count_q == left_q
                && \u_dut.resident_q == (opcode_q == 3);
  wire [5:0] point = {\u_dut.group_q , 1'b0} + \u_dut.group_q + \u_dut.phase_q + 1'b1;
  wire [5:0] function_at = (\u_dut.u_coefficients.derivative_q ? 6'd12 : 6'd0)
                         + \u_dut.u_coefficients.function_q ;
  always @* begin
    case (\u_dut.state_q )
      3'd0: same_state = header_q;
      3'd1: same_state = opcode_q == 1 && at_q == function_at && \u_dut.u_coefficients.function_q < 12
                      && \u_dut.u_coefficients.twice_q == twice_q
                      && (twice_q || !\u_dut.u_coefficients.derivative_q );
      3'd2: same_state = opcode_q == 2;
      3'd3: same_state = same_left && (opcode_q == 3 || at_q == 0);
      3'd4: same_state = same_left && opcode_q == 4 && at_q == point && \u_dut.phase_q < 3;
      3'd5, 3'd6: same_state = opcode_q == 0 || (is_vertex && left_q == 0);
      default: same_state = 1'b0;
    endcase
    if (\u_dut.state_q != 3'd0 && header_q) same_state = 1'b0;
  end
  wire [11:0] top   = {\u_dut.u_lattice.gen_axis[2].top_q ,
                       \u_dut.u_lattice.gen_axis[1].top_q ,
                       \u_dut.u_lattice.gen_axis[0].top_q };
  wire same_lattice = size_q == top || header_q || \u_dut.state_q != 3'd2;
  wire same_offer   = bank_q == \u_dut.u_coefficients.bank_q
                   && buffer_q == \u_dut.u_lattice.buffer_q
                   && loaded_q == \u_dut.u_lattice.loaded_q && m_valid == offer_q
                   && (!m_valid || m_bank == bank_of_q)
                   && (!m_valid || !m_resident || m_buffer == buffer_of_q);

  function agrees(input resident, input buffer, input bank, input [2:0] user);
    agrees = user[2] == resident && (!resident || user[1] == buffer) && user[0] == bank;
  endfunction
  wire users   = (!a_q || agrees(a_resident_q, a_at_q[0], a_bank_q, a_user_q))
              && (!b_q || agrees(b_resident_q, b_at_q[0], b_bank_q, b_user_q))
              && (!m_valid || agrees(m_resident, m_buffer, m_bank, m_user[`FFD_USER_RETIRE(`FFD_USER_W)]))
              && (a_q || !b_q) && !(b_q && b_freed_q && a_free);
  wire readers = \u_dut.u_bank_readers.gen_bank[0].inside_q
                 == (a_q && !a_bank_q) + (b_q && !b_bank_q) + (m_valid && !m_bank)
              && \u_dut.u_bank_readers.gen_bank[1].inside_q
                 == (a_q && a_bank_q) + (b_q && b_bank_q) + (m_valid && m_bank)
              && \u_dut.u_buffer_readers.gen_bank[0].inside_q
                 == (a_q && a_resident_q && !a_at_q[0]) + (b_q && b_resident_q && !b_at_q[0])
                  + (m_valid && m_resident && !m_buffer)
              && \u_dut.u_buffer_readers.gen_bank[1].inside_q
                 == (a_q && a_resident_q && a_at_q[0]) + (b_q && b_resident_q && b_at_q[0])
                  + (m_valid && m_resident && m_buffer);
  // A buffer is known to be read from the clock after its vertex has been offered.
  (* hierconn *) wire [1:0] \u_dut.buffer_busy ;
  wire known   = (\u_dut.u_buffer_readers.gen_bank[0].inside_q == 0 || \u_dut.buffer_busy [0]
                  || (new_vertex && m_resident && !m_buffer))
              && (\u_dut.u_buffer_readers.gen_bank[1].inside_q == 0 || \u_dut.buffer_busy [1]
                  || (new_vertex && m_resident && m_buffer))
              && (!new_vertex || !m_resident || m_buffer == \u_dut.u_lattice.buffer_q );
  wire slots   = \u_dut.used_q == a_free + b_free + (m_valid && !m_resident)
                                + (\u_dut.state_q == 3'd4)
              && \u_dut.used_q <= SLOTS && (\u_dut.state_q != 3'd4 || !\u_dut.resident_q );

  always @* if (!first_q && !rst) begin
    resync: assert (header_q == (\u_dut.state_q == 3'd0));
    follows: assert (same_state && same_lattice && same_offer);
    counted: assert (users && readers && known && slots);
    each_vertex: assert (m_valid == offer_q && !(finish && offer_q && !m_ready));
    stable: assert (!held_q || (m_valid && held_vertex == held_vertex_q));
    bank_free: assert (!load || !((a_q && a_bank_q == load_address[2])
                               || (b_q && b_bank_q == load_address[2])
                               || (m_valid && m_bank == load_address[2])));
    buffer_free: assert (!lattice_write || !((a_q && a_resident_q && a_at_q[0] == lattice_buffer)
                                          || (b_q && b_resident_q && b_at_q[0] == lattice_buffer)
                                          || (m_valid && m_resident
                                              && m_buffer == lattice_buffer)));
    slot_unused: assert (!slot_write || !((a_free && a_at_q == slot) || (b_free && b_at_q == slot)
                                       || (m_valid && !m_resident
                                           && m_source[SLOT_W-1:0] == slot)));
    changed: assert (rst_q || !new_vertex || m_changed || (m_resident && !written_q));
    bank_order: assert (!m_valid || m_bank == bank_of_q);
    buffer_order: assert (!m_valid || !m_resident || m_buffer == buffer_of_q);
    point_inside: assert (!lattice_write || (lattice_at[3:0] <= size_q[3:0]
                          && lattice_at[7:4] <= size_q[7:4] && lattice_at[11:8] <= size_q[11:8]));
    cell_inside: assert ((!(m_valid && m_resident && loaded_of_q) || inside)
                         && same_size && unread);
    slot_inside: assert (slot < SLOTS && (!m_valid || m_resident || m_source[SLOT_W-1:0] < SLOTS));
    idle_means: assert (!idle || (header_q && !m_valid && !a_q && !b_q));
    live: assert (wait_q < CLOCKS);
    place: assert (event_packet == (rst_q ? 32'd0 : next_packet)
                   && event_beat == (rst_q ? 32'd0 : next_beat));
  end
endmodule

`default_nettype wire
