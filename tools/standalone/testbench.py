"""The testbench of a standalone core, in plain Verilog: commands in, and every result compared.

SPDX-License-Identifier: Apache-2.0
"""

from tools.standalone import templates, words
from tools.standalone.configuration import Refused
from tools.tables import registers

PATIENCE = 50_000  # clocks: one unit in the paper's schedule takes some 7,000 for a vertex with its derivatives
# The same on a bus, to which results may go in bursts of 256, each when it is full or FLUSH_CLOCKS are over.
BUS_PATIENCE = 2_000_000
MOST_PACKETS = (1 << 15) - 1  # of a ring
UNIT = words.UNIT // 8  # bytes


def files(core, design, sample, version):
    """name -> text. Raises Refused."""
    texts = _axi(core, design, sample, version) if core.has_registers else _stream(core, sample, version)
    return {f"{core.prefix}_{name}": text for name, text in texts.items()}


def _width(core):
    return core.parameters.get("DATA_WIDTH", words.UNIT)


def _stream(core, sample, version):
    width, bus = _width(core), core.top == "hwffd_stream_bus"
    compared = f"m_data === wanted[{width - 1}:0]"
    keep = ""
    if bus:
        keep = f"{{{width // 8}{{1'b1}}}}"
        compared += f" && m_keep === {keep}"
    if bus and width == 256:
        keep = "{{16{!s_half}}, 16'hFFFF}"
        compared = ("m_data[127:0] === wanted[127:0] && m_keep === {{16{!wanted[258]}}, 16'hFFFF} &&\n"
                    "                (wanted[258] || m_data[255:128] === wanted[255:128])")
    commands, results = words.on_bus(sample.commands, width), words.on_bus(sample.results, width)
    text = templates.text(
        "testbench_stream.v", core=core, sample=sample, version=version, width=width, keep=keep,
        halves=bus and width == 256, compared=compared, commands=commands, results=results,
        first=len(words.on_bus(sample.commands[:sample.first], width)), patience=PATIENCE, zeros=f"{width}'d0")
    return {"tb.v": text, "commands.hex": words.hexadecimal(commands, width),
            "results.hex": words.hexadecimal(results, width)}


class _Memory:
    """What lies where: a ring, packets behind it, and an area for results, each from a multiple of its size or of 4 KB."""

    def __init__(self, sample):
        self.packets = list(words.packets(sample.commands))
        if len(self.packets) > MOST_PACKETS:
            raise Refused(f"--vertices {sample.vertices}: {len(self.packets)} packets, of which a ring has room for {MOST_PACKETS}")
        self.ring_log2 = max(1, len(self.packets).bit_length())
        at = self.begin = (UNIT << self.ring_log2) + 4095 & ~4095
        self.descriptors = []
        for packet in self.packets:
            self.descriptors.append(at | len(packet) * UNIT << 64)
            at += len(packet) * UNIT
        self.end = at + 31 & ~31
        self.area = at + 4095 & ~4095
        self.bytes = self.area + max(1, len(sample.results)) * UNIT

    def text(self, width):
        """For $readmemh: all in front of the results."""
        units = self.descriptors + [0] * (self.begin // UNIT - len(self.descriptors))
        units += [unit.data for packet in self.packets for unit in packet]
        units += [0] * (self.area // UNIT - len(units))
        beats = words.on_bus([words.Beat(unit, 0) for unit in units], width)
        return "".join(f"{beat.data:0{width // 4}x}\n" for beat in beats), len(beats)


def _axi(core, design, sample, version):
    width, memory = _width(core), _Memory(sample)
    image, words_of_image = memory.text(width)
    shift = (width // 8).bit_length() - 1
    offsets = {register.name: register.offset for register in registers.read()}
    buses = {name: port for name, port in design.ports.items()
             if name not in ("aclk", "aresetn", "irq_o", "sleep_o")}
    wires = {"m_axi_arready", "m_axi_awready", "m_axi_wready", "m_axi_rresp", "m_axi_bresp"}
    used = wires | {"m_axi_arvalid", "m_axi_arlen", "m_axi_rready", "m_axi_awvalid", "m_axi_awlen", "m_axi_wvalid",
                    "m_axi_wdata", "m_axi_wstrb", "m_axi_wlast", "m_axi_bready"}
    unused = [name for name, (direction, _) in buses.items()
              if direction == "output" and name.startswith("m_axi") and name not in used]
    settings = [
        ("READ_WINDOW_BASE_LO", "32'd0"), ("READ_WINDOW_BASE_HI", "32'd0"),
        ("READ_WINDOW_LIMIT_LO", f"32'd{memory.end - 1}"), ("READ_WINDOW_LIMIT_HI", "32'd0"),
        ("WRITE_WINDOW_BASE_LO", "AREA"), ("WRITE_WINDOW_BASE_HI", "32'd0"),
        ("WRITE_WINDOW_LIMIT_LO", "AREA + SIZE - 1"), ("WRITE_WINDOW_LIMIT_HI", "32'd0"), ("WINDOW_LOCK", "32'd1"),
        ("RING_BASE_LO", "32'd0"), ("RING_BASE_HI", "32'd0"), ("RING_LOG2_SIZE", f"32'd{memory.ring_log2}"),
        ("RING_HEAD", f"32'd{len(memory.packets)}"), ("RESULT_BASE_LO", "AREA"), ("RESULT_BASE_HI", "32'd0"),
        ("RESULT_SIZE", "SIZE"), ("IRQ_ENABLE", "32'd1"), ("CONTROL", "32'd1")]
    base = memory.area // (width // 8)
    unit = {64: f"{{memory[{base + 1} + 2 * checked], memory[{base} + 2 * checked]}}",
            128: f"memory[{base} + checked]",
            256: f"checked % 2 == 0 ? memory[{base} + checked / 2][127:0] : memory[{base} + checked / 2][255:128]"}[width]
    depth = 128
    text = templates.text(
        "testbench_axi.v", core=core, sample=sample, version=version, width=width, image=words_of_image,
        index=max(9, (memory.bytes // (width // 8) + 1).bit_length()), shift=shift, patience=BUS_PATIENCE, area=memory.area,
        registers=offsets, buses=buses, wires=wires, wishbone=core.top == "hwffd_wishbone", settings=settings, unit=unit,
        packets=len(memory.packets), depth=depth, depth_bits=depth.bit_length() - 1,
        initial={"s_axil_wstrb": "4'hF", "s_axil_bready": "1'b1", "s_axil_rready": "1'b1", "s_wb_sel": "4'hF"},
        unused="".join(f", {name}" for name in unused))
    return {"tb.v": text, "memory.hex": image, "results.hex": words.hexadecimal(sample.results, words.UNIT)}
