"""The data sheet of a standalone core, and the protocol of its streams beside it.

What a port means stands in docs/datasheet.md, what a packet is in rtl/stream/fields.csv, what an event is in
rtl/bus/registers.csv, and what a row of the table of configurations takes of a chip in docs/results/.

SPDX-License-Identifier: Apache-2.0
"""

import json
import re

from tools.project_root import ROOT
from tools.reports.text_table import Table
from tools.rtl import memories
from tools.standalone import templates
from tools.tables import configurations, features, register_texts, registers, stream_words

# Packets by the feature that brings them, of rtl/stream/fields.csv; all cores take coefficients.
_PACKETS = {"coefficients": None, "lattice": "resident", "vertices": "resident", "interleaved": "interleaved",
            "page": "pages", "points": "pages", "page_vertices": "pages", "grid": "grids", "spans": "spans"}
_PAYLOADS = {"coefficients": "12 beats", "lattice": "a beat for each control point",
             "vertices": "a beat for each vertex", "interleaved": "49 beats for each vertex",
             "page": "a beat for each control point", "points": "a beat for each control point",
             "page_vertices": "a beat for each vertex", "grid": "3 beats",
             "spans": "4 beats for each span"}
# What is added to a payload by what a core has besides.
_BESIDES = {"coefficients": ("derivatives", ", or 24 with derivatives"), "spans": ("derivatives", ", or 8 with derivatives"),
            "vertices": ("packed", ", or for two"), "page_vertices": ("packed", ", or for two")}
_WORDS = {
    "float": ("binary32", "binary32", "binary32"),
    "block": ("binary32", "Q2.30 times 2^-k", "binary32, at most 2^exponent of the packet"),
    "fixed": ("unsigned Q1.31, 0x80000000 is 1", "Q2.30 times 2^-k", "Q1.31, from -1 to below 1"),
}
# Of the buses, whose ports docs/datasheet.md does not list one by one.
_BUS_PORTS = (("s_axil_", "AXI4-Lite slave: the registers"), ("m_axi_", "AXI4 master: commands, descriptors, results"),
              ("s_wb_", "Wishbone B4 slave: the registers"), ("irq_o", "interrupt, high while an enabled bit is set"),
              ("sleep_o", "the clock may stop while it is 1"), ("s_axis_tkeep", "which bytes of a beat are there"),
              ("m_axis_tkeep", "which bytes of a beat are there"))
_SIZE = ("lut", "ff", "dsp", "bram")
# How names of measured rows end, by what is built.
_VARIANTS = {features.USUAL: "", "resident+interleaved": "+positions", "resident": "+resident"}
_RESULTS = ROOT / "docs" / "results"


def _meanings():
    """Port of hwffd_stream -> what it means."""
    text = (ROOT / "docs" / "datasheet.md").read_text(encoding="utf-8")
    block = text.split("<!-- sources: rtl.ports hwffd_stream -->")[1].split("<!-- end sources -->")[0]
    meanings = {}
    for line in block.splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("| `"):
            meanings.update(dict.fromkeys(re.findall(r"`(\w+)`", cells[0]), cells[-1]))
    return meanings


def _ports(design):
    """A row for the ports of a direction that have one meaning."""
    known, rows = _meanings(), {}
    for name, (direction, width) in design.ports.items():
        meaning = next((text for start, text in _BUS_PORTS if name.startswith(start)), known.get(name, ""))
        rows.setdefault((direction, meaning), []).append((name, width))
    return Table(["port", "direction", "width", "meaning"], [
        [", ".join(f"`{name}`" for name, _ in ports), direction, ", ".join(str(width) for _, width in ports), meaning]
        for (direction, meaning), ports in rows.items()]).markdown()


def _packets(core):
    described = {field.name: field.description for field in stream_words.read() if field.word == "packet"}
    rows = []
    for name, feature in _PACKETS.items():
        if feature is None or feature in core.has:
            opcode, meaning = re.fullmatch(r"opcode (\d+): (.*)", described[name]).groups()
            besides, text = _BESIDES.get(name, (None, ""))
            rows.append([opcode, meaning, _PAYLOADS[name] + (text if besides in core.has else "")])
    return Table(["opcode", "packet", "payload"], rows).markdown()


def _results(core):
    names = ["0 position"]
    names += ["1 position and its derivatives"] if "derivatives" in core.has else []
    names += ["2 position and det J", "3 det J"] if "determinant" in core.has else []
    return ", ".join(names)


def _events(core):
    """Bits that can come: of event_o, or of ERROR_STATUS, which has those of the buses too."""
    resident = "resident" in core.has
    comes = {"no_lattice": resident, "lattice_size": resident, "cell_outside": resident, "page_points": "pages" in core.has,
             "span_beyond": "spans" in core.has, "no_fourth": "fourth" in core.has,
             "grid_count": "grids" in core.has or "packed" in core.has, "page_overflowed": False,
             "coordinate_nan": core.number_format.words != "fixed", "saturated": core.number_format.words != "float",
             "functions_sum": core.organization.of_form.completes and core.evaluator != "powers",
             **{f"timeout_{channel}": core.parameters.get("BUS_TIMEOUT", 0) != 0 for channel in ("ar", "r", "aw", "w", "b")}}
    fields = [field for field in register_texts.events(registers.read())
              if core.has_registers or not field.name.startswith(("dma_", "timeout_", "result_"))]
    rows = [[str(field.low if core.has_registers else bit), field.description]
            for bit, field in enumerate(fields) if comes.get(field.name, True)]
    return Table(["bit", "event"], rows).markdown()


def _clocks(core):
    """Sentences: clocks from a vertex to the next."""
    own, n, width = core.organization, core.parameters["N"], core.parameters.get("DATA_WIDTH", 128)
    start = 3 if core.evaluator == "iterative" else 1
    if core.schedule == "overlapped":
        text = f"{_clocks_of(own.formulas['overlapped'].value(n=n, start=start))} from a vertex to the next"
        if own.walks:
            text += ", and one along a row, where only s changes and consecutive vertices lie in a cell or the next"
    else:
        fused = core.parameters["FMA_LATENCY"] > 0
        clocks = own.formulas["paper"].value(n=n, poly=3 if fused else 6, add=0 if fused else 1, start=start)
        text = f"{_clocks_of(clocks)} from a vertex to the next, with units of one clock"
    if "derivatives" in core.has:
        least = "three" if core.top == "hwffd_stream_bus" and width == 256 else "four"
        text += (f"; {least} at least with derivatives" if own.jacobian else
                 f"; {'three' if own.walks else 'four'} times that with derivatives")
    if width == 64:
        text += "; and two at least for each 16 bytes in or out, on a bus of 64 bits"
    return text + "."


def _clocks_of(number):
    return "a clock" if number == 1 else f"{number:g} clocks"


def _is_row(core, row):
    """Whether a row of the table of configurations has the arithmetic of the core, and its latencies."""
    return all(core.parameters[name] == value for name, value in row.parameters.items())


def mapped(core):
    """Rows of the table of sizes: where a release has measured this very core."""
    usual = {name: value for name, value in core.defaults.items()
             if name not in ("ORG", "N", "FORMAT", "SCHEDULE", "EVALUATOR", *configurations.NUMBERS, *features.PARAMETERS.values())
             and not name.endswith("_LATENCY")}
    built = "+".join(core.has)
    if built not in _VARIANTS or any(core.parameters[name] != value for name, value in usual.items()):
        return []
    names = [row.name + _VARIANTS[built] for row in configurations.read() if _is_row(core, row)]
    found = []
    for release in sorted(path.name for path in _RESULTS.iterdir() if (path / "synth.json").is_file()):
        report = json.loads((_RESULTS / release / "synth.json").read_text(encoding="utf-8"))
        found = [[row["target"], *("-" if row[size] is None else str(row[size]) for size in _SIZE), release]
                 for row in report["rows"] if row["name"] in names and row["top"] == core.top
                 and not row["flat"]] or found
    return found


def _size(core, target, here):
    rows = mapped(core)
    if here:
        counts, version = here
        rows.append([target, *(str(counts[size]) for size in _SIZE), version])
    if not rows:
        return "No release has mapped this configuration."
    return Table(["target", "LUT", "flip-flops", "multipliers", "block memories", "measured with"], rows).markdown() + "\n\n"


def _memories(design):
    rows = [[str(count), str(shape.width), str(shape.depth), memories.READS[shape.read_latency]]
            for shape, count in sorted(design.memories.items(), reverse=True)]
    return Table(["memories", "bits of a word", "words", "read"], rows).markdown()


def _latency(core, run):
    """A sentence: what a run of the testbench said, or that it says it."""
    if run is None and core.has_registers:
        return "The testbench prints the clocks that all of its packets take; `--simulate` writes them here."
    if run is None:
        return ("The testbench prints the latency of a vertex by itself, in clocks from the beat that completes it to its "
                "result; `--simulate` writes it here.")
    text = f"In {run.simulator} the testbench takes {run.clocks:,} clocks for {run.vertices:,} vertices, pauses included"
    return text + (f"; the result of a vertex by itself comes {run.latency} clocks after the beat that completes it."
                   if run.latency else ".")


def files(core, design, sample, version, target=None, here=None, run=None):
    """name -> text; `here`: what mapping.of counted on that target; `run`: of simulation.of"""
    words = dict(zip(("coordinate", "coefficient", "point"), _WORDS[core.number_format.words]))
    return {"README.md": templates.text(
        "datasheet.md", core=core, version=version, ports=_ports(design), packets=_packets(core),
        results=_results(core), events=_events(core), clocks=_clocks(core), latency=_latency(core, run), size=_size(core, target, here), memories=_memories(design), words=words,
        sample=sample, modules=len(design.modules)), "interface.md": _interface()}


def _interface():
    """The page of the protocol, without links, since the pages that they name are not there."""
    text = (ROOT / "docs" / "interface.md").read_text(encoding="utf-8")
    return re.sub(r"\[([^\]]+)\]\((?!https?:)[^)]+\)", r"\1", text)
