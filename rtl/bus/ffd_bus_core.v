// ffd_bus_core: hwffd_stream with DMA and registers, before the bus of the registers
//
// Registers (docs/registers.md), which come as words, start runs of the DMA (docs/interface.md
// section 8), which feeds hwffd_stream and writes down what comes out. The AXI4 master has one ID
// for all bursts: answers come in order.
//
// Formats:    as hwffd_stream; addresses of ADDRESS_WIDTH bits, data of DATA_WIDTH.
// Pipeline:   as hwffd_stream behind the DMA's queues; words as in ffd_bus_registers.
// Cuts:       every output but the answers to words leaves a register, with HARDENED gates behind
//             some, or is a constant.
// Not checked: nothing on a bus can hang it but a slave that does not answer, and that only for
//             BUS_TIMEOUT clocks.
// Parameters: as in hwffd_axi, without SECURE_ONLY and RESET_REGISTER.
// Model:      golden/include/hwffd/model/stream_model.hpp.  Test: tests/bus/axi.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_eval.vh"
`include "ffd_stream.vh"

module ffd_bus_core #(
  parameter ORG               = 1,
  parameter N                 = `FFD_ORG_N(ORG),
  parameter FORMAT            = 18,
  parameter SCHEDULE          = `FFD_SCHEDULE_OVERLAPPED,
  parameter EVALUATOR         = `FFD_EVALUATOR_ITERATIVE,
  parameter MUL_LATENCY       = 2,
  parameter ADD_LATENCY       = 1,
  parameter FMA_LATENCY       = 0,
  parameter CONVERT_LATENCY   = 1,
  parameter AXIS              = 16,
  parameter PAGES             = 2,
  parameter IN_FLIGHT         = 0,
  parameter WAITING           = 16,
  parameter RESIDENT          = 1,
  parameter INTERLEAVED       = 1,
  parameter PAGED             = 0,
  parameter FOURTH            = 0,
  parameter GRIDS             = 0,
  parameter PACKED            = 0,
  parameter MARKS             = 0,
  parameter DERIVATIVES       = 0,
  parameter DETERMINANT       = 0,
  parameter HALVES            = 0,
  parameter SPANS             = 1,
  parameter GRID_LIMIT        = 48,
  parameter MAX_BURST         = 256,
  parameter READ_DEPTH        = 512,
  parameter WRITE_DEPTH       = 512,
  parameter READ_OUTSTANDING  = 8,
  parameter WRITE_OUTSTANDING = 8,
  parameter FLUSH_CLOCKS      = 16,
  parameter COUNT_WIDTH       = 0,
  parameter BUS_TIMEOUT       = 1048576,
  parameter AXI_PROT          = 2,
  parameter AXI_CACHE         = 2,
  parameter ADDRESS_WIDTH     = 64,
  parameter DATA_WIDTH        = 128,
  parameter ID_WIDTH          = 1,
  parameter ID                = 0,
  parameter HARDENED          = 0
) (
  input  wire         aclk,
  input  wire         aresetn,
  // While it is high, in reset and 16 clocks after, nothing may be valid.
  output wire         s_clearing,

  // A write acts in the clock of its valid and is answered in it; its word comes a clock before.
  input  wire         s_write_valid,
  input  wire [9:0]   s_write_word,
  input  wire [31:0]  s_write_data,
  input  wire [3:0]   s_write_strobe,
  output wire         s_write_error,

  // A read is answered in the clock of its valid; its word comes a clock before.
  input  wire         s_read_valid,
  input  wire [9:0]   s_read_word,
  output wire [31:0]  s_read_data,
  output wire         s_read_error,
  input  wire         awake_i,  // a word comes, or is answered
  input  wire         upset_i,  // a copy of a register of the top or its slave differed
  output wire         sleep_o,
  output wire         irq_o,
  output wire [ID_WIDTH-1:0] m_axi_arid,
  output wire [ID_WIDTH-1:0] m_axi_awid,

  // Reads: bursts of whole beats at rising addresses.
  output wire         m_axi_arvalid,
  input  wire         m_axi_arready,
  output wire [ADDRESS_WIDTH-1:0] m_axi_araddr,
  output wire [7:0]   m_axi_arlen,
  output wire [2:0]   m_axi_arsize,
  output wire [1:0]   m_axi_arburst,
  output wire [3:0]   m_axi_arcache,
  output wire [2:0]   m_axi_arprot,
  input  wire         m_axi_rvalid,
  output wire         m_axi_rready,
  input  wire [DATA_WIDTH-1:0] m_axi_rdata,
  input  wire [1:0]   m_axi_rresp,
  input  wire         m_axi_rlast,

  // Writes: the same, each byte of a beat written, or of one of its halves of 16 bytes.
  output wire         m_axi_awvalid,
  input  wire         m_axi_awready,
  output wire [ADDRESS_WIDTH-1:0] m_axi_awaddr,
  output wire [7:0]   m_axi_awlen,
  output wire [2:0]   m_axi_awsize,
  output wire [1:0]   m_axi_awburst,
  output wire [3:0]   m_axi_awcache,
  output wire [2:0]   m_axi_awprot,
  output wire         m_axi_wvalid,
  input  wire         m_axi_wready,
  output wire [DATA_WIDTH-1:0] m_axi_wdata,
  output wire [DATA_WIDTH/8-1:0] m_axi_wstrb,
  output wire         m_axi_wlast,
  input  wire         m_axi_bvalid,
  output wire         m_axi_bready,
  input  wire [1:0]   m_axi_bresp
);
  generate
    if (IN_FLIGHT >= 65536) begin : gen_bad_in_flight
      ERROR_ffd_bus_core_in_flight_must_be_below_65536 u_error ();
    end
    if (AXI_PROT < 0 || AXI_PROT > 7) begin : gen_bad_prot
      ERROR_ffd_bus_core_axi_prot_must_be_0_to_7 u_error ();
    end
    if (ADDRESS_WIDTH < 32 || ADDRESS_WIDTH > 64) begin : gen_bad_address_width
      ERROR_ffd_bus_core_address_width_must_be_32_to_64 u_error ();
    end
    if (ID_WIDTH < 1 || ID_WIDTH > 16 || ID < 0 || ID >= (1 << ID_WIDTH)) begin : gen_bad_id
      ERROR_ffd_bus_core_id_must_have_at_most_id_width_bits_and_16 u_error ();
    end
    // To allocate in a cache, a transfer must be modifiable.
    if (AXI_CACHE < 0 || AXI_CACHE > 15 || (AXI_CACHE > 3 && AXI_CACHE / 2 % 2 == 0))
    begin : gen_bad_cache
      ERROR_ffd_bus_core_axi_cache_must_be_a_memory_type_of_axi u_error ();
    end
  endgenerate

  localparam FEATURES     = `FFD_FEATURES_NAMED;
  localparam [31:0] ORG_WORD       = ORG;
  localparam [31:0] N_WORD         = N;
  localparam [31:0] FORMAT_WORD    = FORMAT;
  localparam [31:0] SCHEDULE_WORD  = SCHEDULE;
  localparam [31:0] EVALUATOR_WORD = EVALUATOR;
  localparam [31:0] IN_FLIGHT_WORD = `FFD_IN_FLIGHT(IN_FLIGHT, ORG, N);
  // No lattice is kept: no points an axis, no pages.
  localparam [31:0] AXIS_WORD      = `FFD_FEATURE_RESIDENT(FEATURES) != 0 ? AXIS : 0;
  localparam [31:0] PAGES_WORD     = `FFD_FEATURE_RESIDENT(FEATURES) != 0 ? PAGES : 0;
  localparam [31:0] SPANS_WORD     = SPANS;
  localparam [31:0] COUNT_WORD     = COUNT_WIDTH;
  localparam [31:0] GRID_WORD      = `FFD_FEATURE_GRIDS(FEATURES) != 0 ? GRID_LIMIT : 0;
  localparam [31:0] PROT_WORD      = AXI_PROT;
  localparam [31:0] CACHE_WORD     = AXI_CACHE;
  localparam [31:0] ID_WORD        = ID;

  assign m_axi_arcache = CACHE_WORD[3:0];
  assign m_axi_awcache = CACHE_WORD[3:0];
  assign m_axi_arprot  = PROT_WORD[2:0];
  assign m_axi_awprot  = PROT_WORD[2:0];
  assign m_axi_arid    = ID_WORD[ID_WIDTH-1:0];
  assign m_axi_awid    = ID_WORD[ID_WIDTH-1:0];

  // The windows' bounds have no bits above ADDRESS_WIDTH, and so has no address of a burst.
  wire [63:0] read_address;
  wire [63:0] write_address;
  assign m_axi_araddr = read_address[ADDRESS_WIDTH-1:0];
  assign m_axi_awaddr = write_address[ADDRESS_WIDTH-1:0];

  wire clk = aclk;

  // The reset inside is a clock longer than outside: it is high in the clock after, too. The DMA
  // makes its own longer.
  wire rst;
  wire reset_differs;
  ffd_bus_reset #(
    .HARDENED(HARDENED)
  ) u_reset (
    .clk      (clk),
    .aresetn  (aresetn),
    .rst_o    (rst),
    .differs_o(reset_differs)
  );

  // ---- registers

  wire         start;
  wire         soft_reset;
  wire         stop_grid;
  wire         busy;
  wire         idle;
  wire         stopped;
  wire         done;
  wire [63:0]  ring_base;
  wire [3:0]   ring_log2_size;
  wire [15:0]  ring_head;
  wire [15:0]  ring_tail;
  wire         ring_running;
  wire [63:0]  result_base;
  wire [31:0]  result_size;
  wire [31:0]  result_count;
  wire [63:0]  read_first;
  wire [63:0]  read_last;
  wire [63:0]  write_first;
  wire [63:0]  write_last;
  wire         vertex;
  wire [1:0]   second;       // with it; that its words saturate is no error of its own
  wire         stall;
  wire         error_any;
  wire [`FFD_ERRORS-1:0] error_event;
  wire [31:0]  error_packet;
  wire [31:0]  error_beat;
  wire         error_address_valid;
  wire [63:0]  error_address;
  wire         clear_counters;
  wire [159:0] waits;
  wire         locked;
  wire [4:0]   irq_enable;
  wire         result_marked;
  wire         ring_marked;

  // What UPSET_STATUS tells of: with HARDENED only.
  wire         stored_differs, run_upset, core_upset;
  wire [3:0]   dma_upset;
  ffd_bus_registers #(
    .WAITS        (COUNT_WIDTH != 0),
    .HARDENED     (HARDENED),
    .MARKS        (`FFD_FEATURE_MARKS(FEATURES)),
    .ADDRESS_WIDTH(ADDRESS_WIDTH)
  ) u_registers (
    .clk                     (clk),
    .rst                     (rst),
    .s_clearing              (s_clearing),
    .s_write_valid           (s_write_valid),
    .s_write_word            (s_write_word),
    .s_write_data            (s_write_data),
    .s_write_strobe          (s_write_strobe),
    .s_write_error           (s_write_error),
    .s_read_valid            (s_read_valid),
    .s_read_word             (s_read_word),
    .s_read_data             (s_read_data),
    .s_read_error            (s_read_error),
    .config_org_i            (ORG_WORD[7:0]),
    .config_n_i              (N_WORD[7:0]),
    .config_format_i         (FORMAT_WORD[7:0]),
    .config_schedule_i       (SCHEDULE_WORD[0]),
    .config_evaluator_i      (EVALUATOR_WORD[1:0]),
    .limits_in_flight_i      (IN_FLIGHT_WORD[15:0]),
    .limits_points_axis_i    (AXIS_WORD[7:0]),
    .limits_grid_limit_i     (GRID_WORD[5:0]),
    .limits2_pages_i         (PAGES_WORD[15:0]),
    .limits2_spans_i         (SPANS_WORD[7:0]),
    .limits2_count_width_i   (COUNT_WORD[5:0]),
    .limits2_hardened_i      (HARDENED != 0),
    .features_pages_i        (`FFD_FEATURE_PAGES(FEATURES) != 0),
    .features_large_i        (`FFD_FEATURE_LARGE(FEATURES) != 0),
    .features_fourth_i       (`FFD_FEATURE_FOURTH(FEATURES) != 0),
    .features_spans_i        (`FFD_FEATURE_SPANS(FEATURES) != 0),
    .features_grids_i        (`FFD_FEATURE_GRIDS(FEATURES) != 0),
    .features_packed_i       (`FFD_FEATURE_PACKED(FEATURES) != 0),
    .features_marks_i        (`FFD_FEATURE_MARKS(FEATURES) != 0),
    .features_resident_i     (`FFD_FEATURE_RESIDENT(FEATURES) != 0),
    .features_interleaved_i  (`FFD_FEATURE_INTERLEAVED(FEATURES) != 0),
    .features_derivatives_i  (`FFD_FEATURE_DERIVATIVES(FEATURES) != 0),
    .features_determinant_i  (`FFD_FEATURE_DETERMINANT(FEATURES) != 0),
    .features_halves_i       (`FFD_FEATURE_HALVES(FEATURES) != 0),
    .control_start_o         (start),
    .control_soft_reset_o    (soft_reset),
    .control_clear_counters_o(clear_counters),
    .control_stop_grid_o     (stop_grid),
    .status_busy_i           (busy),
    .status_idle_i           (idle),
    .status_stopped_i        (stopped),
    .status_ring_running_i   (ring_running),
    .status_done_set_i       (done),
    .upset_status_memory_set_i(core_upset),
    .upset_status_state_set_i(run_upset || dma_upset[0]),
    .upset_status_window_set_i(dma_upset[1]),
    .upset_status_burst_set_i(dma_upset[2]),
    .upset_status_copy_set_i (dma_upset[3] || upset_i || reset_differs || stored_differs),
    .differs_o               (stored_differs),
    .ring_base_o             (ring_base),
    .ring_log2_size_o        (ring_log2_size),
    .ring_head_o             (ring_head),
    .ring_tail_i             (ring_tail),
    .result_base_o           (result_base),
    .result_size_o           (result_size),
    .result_count_i          (result_count),
    .read_window_base_o      (read_first),
    .read_window_limit_o     (read_last),
    .write_window_base_o     (write_first),
    .write_window_limit_o    (write_last),
    .window_lock_windows_o   (locked),
    .counter_vertices_event_i(vertex),
    .counter_vertices_second_i(second[0]),
    .counter_stalls_event_i  (stall),
    .counter_stalls_second_i (1'b0),
    .counter_busy_event_i    (busy),
    .counter_busy_second_i   (1'b0),
    .wait_input_i            (waits[0 +: 32]),
    .wait_memory_i           (waits[32 +: 32]),
    .wait_evaluator_i        (waits[64 +: 32]),
    .wait_read_i             (waits[96 +: 32]),
    .wait_write_i            (waits[128 +: 32]),
    .error_any_i             (error_any),
    .error_event_i           (error_event),
    .error_packet_i          (error_packet),
    .error_beat_i            (error_beat),
    .error_address_valid_i   (error_address_valid),
    .error_address_i         (error_address),
    .irq_enable_done_o       (irq_enable[0]),
    .irq_enable_error_o      (irq_enable[1]),
    .irq_enable_refused_o    (irq_enable[2]),
    .irq_enable_packet_o     (irq_enable[3]),
    .irq_enable_descriptor_o (irq_enable[4]),
    .irq_state_packet_set_i  (result_marked),
    .irq_state_descriptor_set_i(ring_marked),
    .irq_o                   (irq_o)
  );

  // ---- runs and their errors

  wire        dma_ring_start;
  wire [63:0] dma_ring_base;
  wire [3:0]  dma_ring_entries_log2;
  wire [15:0] dma_ring_head;
  wire        dma_result_start;
  wire        result_busy;
  wire        result_running;
  wire        result_overflow;
  wire        read_error;
  wire [3:0]  read_error_code;
  wire [63:0] read_error_address;
  wire        write_error;
  wire [2:0]  write_error_code;
  wire [63:0] write_error_address;
  wire        clearing;
  wire        halted;
  wire        fault;
  wire [4:0]  timeout;
  wire        dma_idle;
  wire        core_rst;
  wire        core_idle;
  reg         core_idle_q;
  wire [`FFD_EVENTS-1:0] core_event;
  wire [2:0]  core_wait;
  wire [31:0] core_packet;
  wire [31:0] core_beat;

  ffd_bus_run #(
    .HARDENED(HARDENED)
  ) u_run (
    .clk                (clk),
    .rst                (rst),
    .start_i            (start),
    .soft_reset_i       (soft_reset),
    .ring_base_i        (ring_base),
    .ring_log2_size_i   (ring_log2_size),
    .ring_head_i        (ring_head),
    .busy_o             (busy),
    .idle_o             (idle),
    .stopped_o          (stopped),
    .done_o             (done),
    .upset_o            (run_upset),
    .ring_start_o       (dma_ring_start),
    .ring_base_o        (dma_ring_base),
    .ring_entries_log2_o(dma_ring_entries_log2),
    .ring_head_o        (dma_ring_head),
    .result_start_o     (dma_result_start),
    .ring_running_i     (ring_running),
    .write_error_i      (write_error),
    .dma_fault_i        (fault),
    .dma_clearing_i     (clearing),
    .dma_halted_i       (halted),
    .dma_idle_i         (dma_idle),
    .core_rst_o         (core_rst),
    .core_idle_i        (core_idle_q)
  );

  ffd_bus_events u_events (
    .clk                  (clk),
    .rst                  (rst),
    .core_event_i         (core_event),
    .core_packet_i        (core_packet),
    .core_beat_i          (core_beat),
    .read_error_i         (read_error),
    .read_error_code_i    (read_error_code),
    .read_error_address_i (read_error_address),
    .write_error_i        (write_error),
    .write_error_code_i   (write_error_code),
    .write_error_address_i(write_error_address),
    .result_overflow_i    (result_overflow),
    .timeout_i            (timeout),
    .error_any_o          (error_any),
    .error_event_o        (error_event),
    .error_packet_o       (error_packet),
    .error_beat_o         (error_beat),
    .error_address_valid_o(error_address_valid),
    .error_address_o      (error_address)
  );

  // ---- memory

  wire         packet_valid;
  wire         packet_ready;
  wire [127:0] packet_data;
  wire         packet_last;
  wire         result_valid;
  wire         result_ready;
  wire [127:0] result_data;
  wire         result_last;
  wire         result_mark;

  ffd_dma_engine #(
    .MAX_BURST        (MAX_BURST),
    .READ_DEPTH       (READ_DEPTH),
    .WRITE_DEPTH      (WRITE_DEPTH),
    .READ_OUTSTANDING (READ_OUTSTANDING),
    .WRITE_OUTSTANDING(WRITE_OUTSTANDING),
    .FLUSH_CLOCKS     (FLUSH_CLOCKS),
    .TIMEOUT          (BUS_TIMEOUT),
    .DATA_WIDTH       (DATA_WIDTH),
    .MARKS            (`FFD_FEATURE_MARKS(FEATURES)),
    .HARDENED         (HARDENED)
  ) u_dma (
    .clk                  (clk),
    .rst                  (!aresetn),
    .soft_reset_i         (soft_reset),
    .clearing_o           (clearing),
    .halted_o             (halted),
    .fault_o              (fault),
    .timeout_o            (timeout),
    .windows_locked_i     (locked),
    .upset_o              (dma_upset),
    .idle_o               (dma_idle),
    .read_first_i         (read_first),
    .read_last_i          (read_last),
    .ring_start_i         (dma_ring_start),
    .ring_base_i          (dma_ring_base),
    .ring_entries_log2_i  (dma_ring_entries_log2),
    .ring_head_i          (dma_ring_head),
    .ring_tail_o          (ring_tail),
    .ring_running_o       (ring_running),
    .ring_marked_o        (ring_marked),
    .read_error_o         (read_error),
    .read_error_code_o    (read_error_code),
    .read_error_address_o (read_error_address),
    .write_first_i        (write_first),
    .write_last_i         (write_last),
    .result_start_i       (dma_result_start),
    .result_base_i        (result_base),
    .result_size_i        (result_size),
    .result_running_o     (result_running),
    .result_busy_o        (result_busy),
    .result_count_o       (result_count),
    .result_overflow_o    (result_overflow),
    .result_marked_o      (result_marked),
    .write_error_o        (write_error),
    .write_error_code_o   (write_error_code),
    .write_error_address_o(write_error_address),
    .m_packet_valid       (packet_valid),
    .m_packet_ready       (packet_ready),
    .m_packet_data        (packet_data),
    .m_packet_last        (packet_last),
    .s_result_valid       (result_valid),
    .s_result_ready       (result_ready),
    .s_result_data        (result_data),
    .s_result_last        (result_last),
    .s_result_mark        (result_mark),
    .m_axi_araddr         (read_address),
    .m_axi_awaddr         (write_address),
    .m_axi_arvalid (m_axi_arvalid),
    .m_axi_arready (m_axi_arready),
    .m_axi_arlen   (m_axi_arlen),
    .m_axi_arsize  (m_axi_arsize),
    .m_axi_arburst (m_axi_arburst),
    .m_axi_rvalid  (m_axi_rvalid),
    .m_axi_rready  (m_axi_rready),
    .m_axi_rdata   (m_axi_rdata),
    .m_axi_rresp   (m_axi_rresp),
    .m_axi_rlast   (m_axi_rlast),
    .m_axi_awvalid (m_axi_awvalid),
    .m_axi_awready (m_axi_awready),
    .m_axi_awlen   (m_axi_awlen),
    .m_axi_awsize  (m_axi_awsize),
    .m_axi_awburst (m_axi_awburst),
    .m_axi_wvalid  (m_axi_wvalid),
    .m_axi_wready  (m_axi_wready),
    .m_axi_wdata   (m_axi_wdata),
    .m_axi_wstrb   (m_axi_wstrb),
    .m_axi_wlast   (m_axi_wlast),
    .m_axi_bvalid  (m_axi_bvalid),
    .m_axi_bready  (m_axi_bready),
    .m_axi_bresp   (m_axi_bresp)
  );

  // ---- the core

  hwffd_stream #(
    `include "ffd_stream_arguments.vh"
  ) u_core (
    .aclk          (clk),
    .aresetn       (!core_rst),
    .s_axis_tvalid (packet_valid),
    .s_axis_tready (packet_ready),
    .s_axis_tdata  (packet_data),
    .s_axis_tlast  (packet_last),
    .m_axis_tvalid (result_valid),
    .m_axis_tready (result_ready),
    .m_axis_tdata  (result_data),
    .m_axis_tlast  (result_last),
    .m_axis_tuser  (result_mark),
    .grid_stop_i   (stop_grid),
    .event_o       (core_event),
    .event_packet_o(core_packet),
    .event_beat_o  (core_beat),
    .vertex_o      (vertex),
    .second_o      (second),
    .wait_o        (core_wait),
    .idle_o        (core_idle),
    .upset_o       (core_upset)
  );

  assign stall = result_valid && !result_ready;
  always @(posedge clk) core_idle_q <= core_idle;

  ffd_bus_sleep u_sleep (
    .clk    (clk),
    .rst    (rst),
    .calm_i (!awake_i && !busy && idle && !s_clearing && !error_any),
    .sleep_o(sleep_o)
  );

  // ---- why it is slow

  wire starved   = busy && packet_ready && !packet_valid;
  wire read_ends = m_axi_rvalid && m_axi_rlast
                && (DATA_WIDTH < 256 || m_axi_rready);  // else it is always ready

  ffd_bus_waits #(
    .COUNT_WIDTH(COUNT_WIDTH),
    .OPEN       (READ_OUTSTANDING > WRITE_OUTSTANDING ? READ_OUTSTANDING : WRITE_OUTSTANDING)
  ) u_waits (
    .clk           (clk),
    .rst           (rst),
    .open_rst_i    (core_rst),
    .clear_i       (clear_counters),
    .core_i        ({core_wait[1:0], starved}),
    .read_begins_i (m_axi_arvalid && m_axi_arready),
    .read_beat_i   (m_axi_rvalid),
    .read_ends_i   (read_ends),
    .write_begins_i(m_axi_wvalid && m_axi_wready && m_axi_wlast),
    .write_ends_i  (m_axi_bvalid),
    .counts_o      (waits)
  );

  wire unused_ok = &{1'b0, irq_enable, result_running, result_busy, read_address, write_address,
                     second, core_wait[2]};
endmodule

`default_nettype wire
