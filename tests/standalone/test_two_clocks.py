"""The example in which a core has a clock of its own (examples/two_clocks): the testbench of a core with a DMA engine, and
a queue by itself.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from tests.standalone import bench
from tools.project_root import ROOT
from tools.rtl import module_header, rtl_sources
from tools.standalone import configuration
from tools.tables import parameter_space

EXAMPLE = sorted((ROOT / "examples" / "two_clocks").glob("*.v"))
PARAMETERS = {"ORG": 1, "FORMAT": 18, "EVALUATOR": 1, "AXIS": 4}
VERTICES = 12
# Half periods of the core's clock; that of the bus is 5.
HALF_PERIODS = (2, 5, 7, 23)

# Words through a queue, each side waiting as a shift register says.
QUEUE = """
module bench;
  reg write_clk = 1'b0, read_clk = 1'b0, rst = 1'b1;
  reg [31:0] a = 32'h1234567, b = 32'h7654321;
  reg [15:0] next = 16'd0, wanted = 16'd0;
  integer full = 0;
  wire write_ready, read_valid;
  wire [15:0] data;
  wire write_valid = a[1:0] != 2'd0;
  wire read_ready = b[{bit}];
  always #{write} write_clk = !write_clk;
  always #{read} read_clk = !read_clk;
  async_fifo #(.WIDTH(16), .DEPTH_LOG2(2)) u_fifo (
    .write_clk(write_clk), .write_rst(rst), .write_valid_i(write_valid), .write_ready_o(write_ready), .write_data_i(next),
    .read_clk(read_clk), .read_rst(rst), .read_valid_o(read_valid), .read_ready_i(read_ready), .read_data_o(data));
  initial begin #200; @(negedge write_clk) rst = 1'b0; end
  always @(posedge write_clk) begin
    a <= {{a[30:0], a[31] ^ a[21] ^ a[1] ^ a[0]}};
    if (!rst && write_valid && write_ready) next <= next + 1'b1;
    if (!rst && write_valid && !write_ready) full <= full + 1;
  end
  always @(posedge read_clk) begin
    b <= {{b[30:0], b[31] ^ b[21] ^ b[1] ^ b[0]}};
    if (!rst && read_valid && read_ready) begin
      if (data !== wanted) begin $display("FAIL %0d", wanted); $stop; end
      wanted <= wanted + 1'b1;
      if (wanted == 16'd5000) begin $display("PASS %0d full %0d", wanted, full); $finish; end
    end
  end
endmodule
"""


@pytest.fixture(scope="module")
def core(tmp_path_factory):
    defaults = module_header.parameters(rtl_sources.Sources(), "hwffd_axi")
    parameters = {**defaults, **PARAMETERS}
    of = configuration.of_parameters(parameter_space.Space(), "hwffd_axi", "hwffd_axi", parameters, "two clocks")
    return bench.Folder(of, tmp_path_factory.mktemp("two") / "hwffd_axi", VERTICES)


@pytest.fixture(scope="module")
def example(tmp_path_factory):
    """Its sources, with the parameters of that core."""
    queue, top = EXAMPLE
    text, before = top.read_text(encoding="utf-8"), "  hwffd_axi #(\n"
    assert text.count(before) == 1
    changed = tmp_path_factory.mktemp("example") / top.name
    values = "".join(f"    .{name}({value}),\n" for name, value in PARAMETERS.items())
    changed.write_text(text.replace(before, before + values), encoding="utf-8")
    return [*bench.whole_tree(), queue, changed]


@pytest.mark.parametrize("half", HALF_PERIODS)
def test_results_and_registers_with_another_clock(core, example, half):
    text = core.text("_tb.v")
    before = "  hwffd_axi u_core (\n"
    assert text.count(before) == 1
    text = text.replace(before, f"""  reg core_clk;
  reg core_resetn;
  initial begin
    core_clk = 1'b0;
    forever #{half} core_clk = !core_clk;
  end
  initial core_resetn = 1'b0;
  always @(posedge core_clk) core_resetn <= aresetn;

  two_clocks u_core (
    .core_clk(core_clk),
    .core_resetn(core_resetn),
""").replace("repeat (4) @(negedge aclk);\n    aresetn = 1'b1;", "repeat (40) @(negedge aclk);\n    aresetn = 1'b1;\n"
             "    repeat (200) @(negedge aclk);")
    status, output = core.simulated(testbench=text, sources=example, name=f"half{half}")
    assert status == 0 and f"PASS {VERTICES} vertices" in output, output


@pytest.mark.parametrize("write, read, bit", ((5, 5, 0), (5, 7, 0), (3, 11, 3), (11, 3, 2), (7, 8, 5)))
def test_queue(tmp_path, write, read, bit):
    (tmp_path / "bench.v").write_text(QUEUE.format(write=write, read=read, bit=bit))
    assert bench.run("iverilog", "-g2005", "-Wall", "-o", "bench", "bench.v", EXAMPLE[0], cwd=tmp_path)[0] == 0
    status, output = bench.run("vvp", "-n", "-N", "bench", cwd=tmp_path)
    assert status == 0 and "PASS 5000 full " in output, output
    if read >= write:
        assert int(output.split()[-1]) > 100


def test_a_queue_that_is_overrun_is_seen(tmp_path):
    text = EXAMPLE[0].read_text()
    assert text.count("{2'b11, {") == 1
    (tmp_path / "async_fifo.v").write_text(text.replace("{2'b11, {", "{2'b01, {"))
    (tmp_path / "bench.v").write_text(QUEUE.format(write=3, read=11, bit=3))
    assert bench.run("iverilog", "-g2005", "-o", "bench", "bench.v", "async_fifo.v", cwd=tmp_path)[0] == 0
    status, output = bench.run("vvp", "-n", "-N", "bench", cwd=tmp_path)
    assert status != 0 and "FAIL" in output


def test_it_is_clean():
    sources = bench.whole_tree()
    for language in ("--default-language", "1364-2005"), ():
        assert bench.run("verilator_bin", "--lint-only", "-Wall", *language, "-F", ROOT / "rtl" / "hwffd.f", *EXAMPLE,
                         "--top-module", "two_clocks") == (0, "")
    assert bench.run("iverilog", "-g2005", "-t", "null", "-s", "two_clocks", *sources, *EXAMPLE)[0] == 0
