// {{ core.prefix }}_tb: {{ sample.vertices }} vertices through {{ core.prefix }}, from a memory and back, every result compared
//
// {{ core.prefix }}_memory.hex, in the folder where it runs, is the memory: a ring of descriptors, and the packets
// that they name. The testbench sets the registers, starts the core, and waits for its interrupt; then it
// compares the results with {{ core.prefix }}_results.hex, which are the words of the bit-true model of hwffd
// {{ version }}, and the errors told with the model's. The memory pauses as a shift register says. At the end it
// prints PASS, or FAIL, and then its exit status is not 0.
//
// SPDX-License-Identifier: Apache-2.0
`default_nettype none

module {{ core.prefix }}_tb;
  localparam WORDS    = {{ 2 ** index }};  // of {{ width // 8 }} bytes, of the memory
  localparam IMAGE    = {{ image }};  // of these, what is read from the file
  localparam RESULTS  = {{ sample.results | length }};
  localparam VERTICES = {{ sample.vertices }};
  localparam PATIENCE = {{ patience }};  // clocks without a beat on the bus, at most
  localparam [31:0] AREA   = 32'd{{ area }};  // address of the results
  localparam [31:0] SIZE   = 32'd{{ 16 * sample.results | length }};  // bytes of them
  localparam [31:0] ERRORS = 32'h{{ "%08x" % sample.errors }};  // ERROR_STATUS at the end

  reg                aclk;
  reg                aresetn;
  wire               irq;
  wire               sleep;
{% for name, (direction, bits) in buses.items() %}
  {{ "reg " if direction == "input" and name not in wires else "wire" }} {{ "%-15s" % ("[%d:0]" % (bits - 1) if bits > 1 else "") }} {{ name }};
{% endfor %}

  {{ core.prefix }} u_core (
    .aclk   (aclk),
    .aresetn(aresetn),
{% for name in buses %}
    .{{ name }}({{ name }}),
{% endfor %}
    .irq_o  (irq),
    .sleep_o(sleep)
  );

  reg  [{{ width - 1 }}:0]  memory [0:WORDS-1];
  reg  [131:0]  expected [0:RESULTS-1];
  reg  [31:0]   shifted;
  integer       clocks;
  integer       still;

  initial begin
    aclk = 1'b0;
    forever #5 aclk = !aclk;
  end

  // The memory: bursts in their order, up to {{ depth - 1 }} of either kind.
  reg  [31:0]   read_address [0:{{ depth - 1 }}];
  reg  [7:0]    read_length  [0:{{ depth - 1 }}];
  reg  [31:0]   write_address[0:{{ depth - 1 }}];
  reg  [7:0]    write_length [0:{{ depth - 1 }}];
  reg  [{{ depth_bits - 1 }}:0]    read_in, read_out, write_in, write_out, answers;
  reg  [7:0]    read_beat, write_beat;
  wire [31:0]   read_from   = read_address[read_out];
  wire [31:0]   write_to    = write_address[write_out];
  wire [{{ index - 1 }}:0]   read_word   = read_from[{{ shift }} +: {{ index }}] + {{ "{%d'd0, read_beat}" % (index - 8) }};
  wire [{{ index - 1 }}:0]   write_word  = write_to[{{ shift }} +: {{ index }}] + {{ "{%d'd0, write_beat}" % (index - 8) }};
  wire          answered    = m_axi_bvalid && m_axi_bready;
  wire          wrote       = m_axi_wvalid && m_axi_wready;
  wire          wrote_last  = wrote && m_axi_wlast;
  wire [{{ depth_bits - 1 }}:0]    read_next   = read_in + 1'b1;
  wire [{{ depth_bits - 1 }}:0]    write_next  = write_in + 1'b1;
  integer       b;

  assign m_axi_arready = shifted[1:0] != 2'd0 && read_next != read_out;
  assign m_axi_awready = shifted[3:2] != 2'd0 && write_next != write_out;
  assign m_axi_wready  = shifted[6:4] != 3'd0 && write_in != write_out;
  assign m_axi_rresp   = 2'd0;
  assign m_axi_bresp   = 2'd0;

  always @(posedge aclk) begin
    clocks  <= clocks + 1;
    shifted <= {shifted[30:0], shifted[31] ^ shifted[21] ^ shifted[1] ^ shifted[0]};
    if (aresetn) begin
      still <= still + 1;
      if (m_axi_arvalid && m_axi_arready) begin
        read_address[read_in] <= m_axi_araddr[31:0];
        read_length[read_in]  <= m_axi_arlen;
        read_in               <= read_next;
        still                 <= 0;
      end
      if (!m_axi_rvalid || m_axi_rready) begin
        m_axi_rvalid <= 1'b0;
        if (read_in != read_out && shifted[9:7] != 3'd0) begin
          m_axi_rvalid <= 1'b1;
          m_axi_rdata  <= memory[read_word];
          m_axi_rlast  <= read_beat == read_length[read_out];
          read_beat    <= read_beat == read_length[read_out] ? 8'd0 : read_beat + 1'b1;
          read_out     <= read_beat == read_length[read_out] ? read_out + 1'b1 : read_out;
        end
      end
      if (m_axi_awvalid && m_axi_awready) begin
        write_address[write_in] <= m_axi_awaddr[31:0];
        write_length[write_in]  <= m_axi_awlen;
        write_in                <= write_next;
      end
      if (wrote) begin
        for (b = 0; b < {{ width // 8 }}; b = b + 1) begin
          if (m_axi_wstrb[b]) memory[write_word][8*b +: 8] <= m_axi_wdata[8*b +: 8];
        end
        write_beat <= m_axi_wlast ? 8'd0 : write_beat + 1'b1;
        write_out  <= m_axi_wlast ? write_out + 1'b1 : write_out;
        still      <= 0;
        if (m_axi_wlast != (write_beat == write_length[write_out])) begin
          $display("FAIL wlast in beat %0d of a burst of %0d", write_beat, write_length[write_out]);
          $stop;
        end
      end
      if (!m_axi_bvalid || m_axi_bready) m_axi_bvalid <= answers > {{ "{%d'd0, answered}" % (depth_bits - 1) }} && shifted[10];
      answers <= answers + {{ "{%d'd0, wrote_last} - {%d'd0, answered}" % (depth_bits - 1, depth_bits - 1) }};
      if (still == PATIENCE) begin
        $display("FAIL nothing moves");
        $stop;
      end
    end
  end

  // An access to the registers: what is asked for changes at falling edges, and its signals at rising ones.
  reg         asked;
  reg         asked_write;
  reg  [11:0] asked_address;
  reg  [31:0] asked_data;
  reg         busy_q;
  reg         done_q;
  reg         refused_q;
  reg  [31:0] read_q;
  reg  [31:0] value;  // that was read last
{% if wishbone %}
  wire        write_answer = s_wb_ack || s_wb_err;
  wire        read_answer  = write_answer;
  wire        refused      = s_wb_err;
  wire [31:0] read_data    = s_wb_dat_r;
{% else %}
  wire        write_answer = s_axil_bvalid;
  wire        read_answer  = s_axil_rvalid;
  wire        refused      = asked_write ? s_axil_bresp != 2'd0 : s_axil_rresp != 2'd0;
  wire [31:0] read_data    = s_axil_rdata;
{% endif %}

  always @(posedge aclk) begin
    if (!aresetn || !asked) begin
      busy_q <= 1'b0;
      done_q <= 1'b0;
    end else if (!busy_q && !done_q) begin
      busy_q <= 1'b1;
{% if wishbone %}
      s_wb_cyc   <= 1'b1;
      s_wb_stb   <= 1'b1;
      s_wb_we    <= asked_write;
      s_wb_adr   <= asked_address;
      s_wb_dat_w <= asked_data;
{% else %}
      s_axil_awvalid <= asked_write;
      s_axil_wvalid  <= asked_write;
      s_axil_arvalid <= !asked_write;
      s_axil_awaddr  <= asked_address;
      s_axil_araddr  <= asked_address;
      s_axil_wdata   <= asked_data;
{% endif %}
    end else if (busy_q) begin
{% if not wishbone %}
      if (s_axil_awready) s_axil_awvalid <= 1'b0;
      if (s_axil_wready) s_axil_wvalid <= 1'b0;
      if (s_axil_arready) s_axil_arvalid <= 1'b0;
{% endif %}
      if (asked_write ? write_answer : read_answer) begin
        busy_q    <= 1'b0;
        done_q    <= 1'b1;
        refused_q <= refused;
        read_q    <= read_data;
{% if wishbone %}
        s_wb_cyc  <= 1'b0;
        s_wb_stb  <= 1'b0;
{% endif %}
      end
    end
  end

  task access(input write, input [11:0] address, input [31:0] data);
    begin
      asked_write   = write;
      asked_address = address;
      asked_data    = data;
      asked         = 1'b1;
      @(negedge aclk);
      while (!done_q) @(negedge aclk);
      value = read_q;
      asked = 1'b0;
      @(negedge aclk);
      if (refused_q) begin
        $display("FAIL register %h is refused", address);
        $stop;
      end
    end
  endtask
  task put(input [11:0] address, input [31:0] data);
    access(1'b1, address, data);
  endtask

  task must_be(input [11:0] address, input [31:0] wanted);
    begin
      access(1'b0, address, 32'd0);
      if (value !== wanted) begin
        $display("FAIL register %h is %h, %h wanted", address, value, wanted);
        $stop;
      end
    end
  endtask

  initial begin
    shifted      = 32'h2545F491;
    clocks       = 0;
    still        = 0;
    read_in      = 0;
    read_out     = 0;
    write_in     = 0;
    write_out    = 0;
    answers      = 0;
    read_beat    = 8'd0;
    write_beat   = 8'd0;
{% for name, (direction, bits) in buses.items() if direction == "input" and name not in wires %}
    {{ "%-12s" % name }} = {{ initial.get(name, "%d'd0" % bits) }};
{% endfor %}
    busy_q        = 1'b0;
    done_q        = 1'b0;
    refused_q     = 1'b0;
    read_q        = 32'd0;
  end

  integer     checked;
  reg [127:0] got;
  initial begin
    $readmemh("{{ core.prefix }}_memory.hex", memory, 0, IMAGE - 1);
    $readmemh("{{ core.prefix }}_results.hex", expected);
    if (^memory[0] === 1'bx || ^expected[0] === 1'bx) begin
      $display("FAIL {{ core.prefix }}_memory.hex and {{ core.prefix }}_results.hex must be in the folder where this runs");
      $stop;
    end
    aresetn       = 1'b0;
    got           = 128'd0;
    value         = 32'd0;
    asked         = 1'b0;
    asked_write   = 1'b0;
    asked_address = 12'd0;
    asked_data    = 32'd0;
    repeat (4) @(negedge aclk);
    aresetn = 1'b1;
    must_be(12'h{{ "%03x" % registers.ID }}, 32'h48464644);
{% for register, data in settings %}
    put(12'h{{ "%03x" % registers[register] }}, {{ data }});  // {{ register }}
{% endfor %}
    while (!irq) @(negedge aclk);
    must_be(12'h{{ "%03x" % registers.ERROR_STATUS }}, ERRORS);
    must_be(12'h{{ "%03x" % registers.RESULT_COUNT }}, RESULTS);
    must_be(12'h{{ "%03x" % registers.COUNTER_VERTICES_LO }}, VERTICES);
    for (checked = 0; checked < RESULTS; checked = checked + 1) begin
      got = {{ unit }};
      if (got !== expected[checked][127:0]) begin
        $display("FAIL result %0d of %0d: got %h, wanted %h", checked, RESULTS, got, expected[checked][127:0]);
        $stop;
      end
    end
    $display("PASS %0d vertices, %0d results, %0d clocks, %0d packets", VERTICES, RESULTS, clocks, {{ packets }});
    $finish;
  end

  wire unused_ok = &{1'b0, sleep, read_from, write_to{{ unused }}};
endmodule

`default_nettype wire
