// formal_wb_slave: ffd_wb_slave between a Wishbone master and any words
//
// With PATIENT 1 the master keeps to the rules: an access stays as it is until it is answered. With
// 0 it does what it likes.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module formal_wb_slave #(
  parameter ADDRESS_W = 6,
  parameter PATIENT   = 1
) (
  input wire                 clk,
  input wire                 rst,
  input wire                 cyc,
  input wire                 stb,
  input wire                 we,
  input wire [ADDRESS_W-1:0] adr,
  input wire [31:0]          dat,
  input wire [3:0]           sel,
  input wire                 write_error,
  input wire [31:0]          read_data,
  input wire                 read_error
);
  wire [31:0]          dat_r;
  wire                 ack;
  wire                 err;
  wire                 write;
  wire [ADDRESS_W-3:0] write_word;
  wire [31:0]          write_data;
  wire [3:0]           write_strobe;
  wire                 read;
  wire [ADDRESS_W-3:0] read_word;

  ffd_wb_slave #(
    .ADDRESS_W(ADDRESS_W)
  ) u_dut (
    .clk           (clk),
    .rst           (rst),
    .s_wb_cyc      (cyc),
    .s_wb_stb      (stb),
    .s_wb_we       (we),
    .s_wb_adr      (adr),
    .s_wb_dat_w    (dat),
    .s_wb_sel      (sel),
    .s_wb_dat_r    (dat_r),
    .s_wb_ack      (ack),
    .s_wb_err      (err),
    .m_write_valid (write),
    .m_write_word  (write_word),
    .m_write_data  (write_data),
    .m_write_strobe(write_strobe),
    .m_write_error (write_error),
    .m_read_valid  (read),
    .m_read_word   (read_word),
    .m_read_data   (read_data),
    .m_read_error  (read_error)
  );

  wire asked    = cyc && stb;
  wire answered = ack || err;

  reg                  first_q = 1'b1;
  reg                  rst_q;
  reg                  asked_q;
  reg                  waiting_q;    // an access that was not answered
  reg [ADDRESS_W+36:0] access_q;
  reg                  write_q;
  reg                  read_q;
  reg                  error_q;
  reg [31:0]           data_q;
  reg [ADDRESS_W-3:0]  write_word_q;
  reg [ADDRESS_W-3:0]  read_word_q;
  reg                  handed_q;     // the access that waits was handed on
  reg [2:0]            late_q;       // clocks for which it has waited
  wire [ADDRESS_W+36:0] access = {we, adr, dat, sel};
  always @(posedge clk) begin
    first_q      <= 1'b0;
    rst_q        <= rst;
    asked_q      <= asked;
    waiting_q    <= asked && !answered && !rst;
    access_q     <= access;
    write_q      <= write && !rst;
    read_q       <= read && !rst;
    error_q      <= write ? write_error : read_error;
    data_q       <= read_data;
    write_word_q <= write_word;
    read_word_q  <= read_word;
    handed_q     <= !rst && !answered && (handed_q || write || read);
    late_q       <= rst || !asked || answered ? 0 : late_q + (late_q != 7);
  end
  always @* if (first_q) assume (rst);
  generate
    if (PATIENT != 0) begin : gen_patient
      always @* if (waiting_q && !rst) assume (asked && access == access_q);
    end
  endgenerate

  always @* if (!first_q && !rst && !rst_q) begin
    written: assert (!write || (asked && we && !read && write_data == dat && write_strobe == sel
                                && write_word == adr[ADDRESS_W-1:2]));
    read_on: assert (!read || (asked && !we && !write && read_word == adr[ADDRESS_W-1:2]));
    early: assert ((!write || write_word == write_word_q) && (!read || read_word == read_word_q));
    once: assert (!((write || read) && handed_q));
    answer: assert (answered == (write_q || read_q) && !(ack && err));
    truth: assert (!answered || (err == error_q && (write_q || dat_r == (error_q ? 32'd0 : data_q))));
    live: assert (!asked || answered || late_q < 3);
    quiet: assert (!answered || (asked_q && !(ack && err)));
  end
  always @* if (!first_q) begin
    closed: assert (!rst_q || (!ack && !err && !write && !read));
  end
endmodule

`default_nettype wire
