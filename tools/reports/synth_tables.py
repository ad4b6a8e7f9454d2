"""make synth: what the rows that have been mapped cost.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

ORGANIZATION, CORE, SYSTEM = "ffd_org_select", "hwffd_stream", "hwffd_axi"
BUS = "hwffd_stream_bus"  # that core on streams of other widths
SCATTER, ADJOINT = "hwffd_scatter", "hwffd_adjoint"
TITLES = {
    "generic": "Generic gates", "ecp5": "Lattice ECP5", "up5k": "Lattice iCE40 UltraPlus (UP5K)",
    "hx8k": "Lattice iCE40 HX8K", "nexus": "Lattice CrossLink-NX", "gowin": "Gowin GW2A",
    "gw5a": "Gowin GW5A", "gatemate": "Cologne Chip GateMate",
    "xilinx7": "Xilinx 7 series",
    "osu018": "OSU 0.18 um standard cells",
}
# Fields in their order; a table has those that its rows have.
HEADS = {
    "lut": "LUT", "lutram": "LUT as memory", "ff": "FF", "dsp": "multipliers", "bram": "memories",
    "cells": "cells", "area_um2": "area um2", "depth": "depth", "fmax_mhz": "MHz",
    "power_mw": "mW at 100 MHz", "remark": "remark",
}
DSP = {"ecp5": "MULT18X18D", "up5k": "SB_MAC16", "hx8k": "none", "xilinx7": "DSP48E1",
       "nexus": "MULT18X18", "gowin": "MULT18X18", "gw5a": "MULTALU27X18", "gatemate": "CC_MULT"}
BRAM = {"ecp5": "DP16KD", "up5k": "SB_RAM40_4K", "hx8k": "SB_RAM40_4K", "xilinx7": "RAMB18E1",
        "nexus": "PDPSC16K", "gowin": "SDPB, SDPX9B", "gw5a": "SDPB, SDPX9B",
        "gatemate": "CC_BRAM_20K"}


def head(target, field):
    return {"dsp": DSP, "bram": BRAM}.get(field, {}).get(target, HEADS[field])


def columns(rows):
    """The fields that some row has."""
    return [field for field in HEADS if any(row.get(field) is not None for row in rows)]


def is_plain(row):
    """A row that differs from the others of its format by its organization and N only."""
    return row["name"].split("-")[2:] == ["overlapped"] and row["top"] == ORGANIZATION


def number(value):
    return value if isinstance(value, str) else shown(value, ",")


def mapped(rows, target, name=lambda row: f"`{row['name']}`"):
    """Rows of one target with what they cost."""
    fields = columns(rows)
    return Table(["row", *(head(target, field) for field in fields)],
                 [[name(row), *(number(row.get(field)) for field in fields)] for row in rows])


def organizations(reports, target="ecp5"):
    """Organizations in fx18, overlapped, on one target."""
    rows = [row for row in reports.rows("synth", target=target, format="fx18") if is_plain(row)]
    table = mapped(rows, target, lambda row: f"`{row['name'].split('-')[0]}`")
    table.heads[0] = "organization"
    return table


def cores(reports, target="ecp5", top=CORE, formats="fx18"):
    """Whole cores, overlapped, as their rows say, in fx18 or in formats that commas part."""
    return mapped([row for row in reports.rows("synth", target=target, top=top, format=formats)
                   if not row.get("variant")], target)


def transposes(reports, target="ecp5"):
    """The transpose, by itself and with an evaluator, as its variants say."""
    rows = reports.rows("synth", target=target, top=f"{SCATTER},{ADJOINT}")
    table = mapped(rows, target)
    return Table(["row", "module", *table.heads[1:], "built with"],
                 [[line[0], f"`{row['top']}`", *line[1:], row["meaning"]] for row, line in zip(rows, table.rows)])


def systems(reports, target="ecp5"):
    """Those with DMA and registers, in every format."""
    return mapped([row for row in reports.rows("synth", target=target, top=SYSTEM)
                   if not row.get("variant")], target)


def prices(reports, target="ecp5", *names):
    """Cores, all or those named ROW/TOP, with a feature more or less than their row, beside that row: what it costs."""
    rows, lines, shown_last = reports.rows("synth", target=target), [], None
    plain = {(row["name"], row["top"]): row for row in rows if not row.get("variant")}
    fields = [field for field in ("lut", "lutram", "ff", "dsp", "bram")
              if field in columns(rows)]
    for row in (row for row in rows if row.get("variant")):
        name = row["name"].split("+")[0]
        base = plain.get((name, CORE if row["top"] == BUS else row["top"]))
        if base is None or names and f"{name}/{base['top']}" not in names:
            continue
        if base is not shown_last:
            lines.append([f"`{name}`, `{base['top']}`", "as in the table",
                          *(number(base[field]) for field in fields)])
        shown_last = base
        lines.append(["", row["meaning"], *(
            f"{number(row[field])} ({row[field] - base[field]:+,})" for field in fields)])
    return Table(["core", "built with", *(head(target, field) for field in fields)], lines)


def _rows_of(title, tops, fixed):
    def keep(row):
        return row["top"] in tops and fixed in (None, row["format"] != "fp32")
    return title, keep


GROUPS = (
    _rows_of("With DMA and registers, `hwffd_axi`", (SYSTEM,), None),
    _rows_of("Whole cores, `hwffd_stream`", (CORE, BUS), None),
    _rows_of("Fixed and block floating point, `ffd_org_select`", (ORGANIZATION,), True),
    _rows_of("Binary32, `ffd_org_select`", (ORGANIZATION,), False),
    _rows_of("The transpose, `hwffd_scatter`", (SCATTER,), None),
    _rows_of("An evaluator with the transpose, `hwffd_adjoint`", (ADJOINT,), None),
    ("Binary32 units by themselves",
     lambda row: row["top"] not in (ORGANIZATION, CORE, BUS, SYSTEM, SCATTER, ADJOINT)),
)


def _targets(rows):
    present = {row["target"] for row in rows}
    return [target for target in TITLES if target in present]


def _target_parts(rows, target):
    sections = [f"## {TITLES[target]}"]
    for title, keep in GROUPS:
        mapped_rows = [row for row in rows if row["target"] == target and keep(row)]
        if mapped_rows:
            method = "flat" if mapped_rows[0]["flat"] else "units kept apart"
            sections += [f"{title}, {method}:", mapped(mapped_rows, target).markdown()]
    return sections


def matrix(reports, target, *fields):
    """Organizations down, formats across: sums of fields."""
    rows = [row for row in reports.rows("synth", target=target) if is_plain(row)]
    formats = list(dict.fromkeys(row["format"] for row in rows))
    value = {(row["name"].split("-")[0], row["format"]): sum(row[field] for field in fields)
             for row in rows}
    return Table(["organization", *(f"`{word}`" for word in formats)], [
        [f"`{name}`", *(number(value.get((name, word))) for word in formats)]
        for name in dict.fromkeys(name for name, _ in value)])


def _matrix_parts(reports, target):
    wanted = {
        "generic": [(("cells",), "cells")], "hx8k": [(("lut",), "LUT")],
        "osu018": [((field,), HEADS[field]) for field in ("area_um2", "fmax_mhz")],
    }.get(target, [(("lut", "lutram"), "LUT, memory included"), (("dsp",), head(target, "dsp"))])
    if not any(is_plain(row) for row in reports.rows("synth", target=target)):
        return []
    return [part for fields, title in wanted
            for part in (f"{TITLES[target]}, {title}:", matrix(reports, target, *fields).markdown())]


def kinds(reports, target):
    """Kinds of cells down, organizations in fx18 across."""
    rows = [row for row in reports.rows("synth", target=target, format="fx18")
            if is_plain(row) and row.get("kinds")]
    return Table(["cell", *(f"`{row['name'].split('-')[0]}`" for row in rows)],
                 [[f"`{kind}`", *(number(row["kinds"].get(kind, 0)) for row in rows)]
                  for kind in sorted({kind for row in rows for kind in row["kinds"]})])


def critical_paths(reports):
    """Where the longest paths of standard cells begin and end."""
    return Table(["row", "top", "MHz", "critical path"], [
        [f"`{row['name']}`", f"`{row['top']}`", number(row["fmax_mhz"]), row["critical_path"]]
        for row in reports.rows("synth") if row.get("critical_path")])


def document(reports):
    """build/reports/synth.md"""
    report, rows = reports.get("synth"), reports.get("synth")["rows"]
    sections = ["# Mapped by yosys",
                f"{report['yosys']}, OpenSTA {report['sta'] or 'not here'}. Mapped, not placed: clocks "
                "and power are of standard cells without wires. What each number counts is in "
                "synth/README.md."]
    if len(rows) < report["wanted"]:
        sections.append(f"{report['wanted'] - len(rows)} of {report['wanted']} rows have not been "
                        "mapped from the present sources and are not shown; `make synth` maps them.")
    sections += [f"Failed: {failure['name']}, {failure['top']}, {failure['target']}: {failure['error']}"
                 for failure in report["failed"]]
    targets = _targets(rows)
    for target in targets:
        sections += _target_parts(rows, target)
    if any(row.get("variant") for row in rows):
        sections += ["## What features cost", "Cores of `synth/variants.csv` on ECP5, with the "
                     "difference to their rows.", prices(reports).markdown()]
    sections.append("## Organizations side by side")
    sections += [part for target in targets for part in _matrix_parts(reports, target)]
    sections.append("## Cells by kind")
    sections += [part for target in targets if kinds(reports, target).rows
              for part in (f"{TITLES[target]}:", kinds(reports, target).markdown())]
    if any(row.get("critical_path") for row in rows):
        sections += ["## Critical paths of standard cells",
                     "A name is that of the register in the sources, or of a port.",
                     critical_paths(reports).markdown()]
    return "\n\n".join(sections) + "\n"


def listed(_, rows):
    """Rows of any target, for a terminal."""
    fields = columns(rows)
    return Table(["row", "top", "target", *(HEADS[field] for field in fields)],
                 [[row["name"], row["top"], row["target"],
                   *(number(row.get(field)) for field in fields)] for row in rows])


def printed(reports):
    return listed(reports, reports.rows("synth")).text()


def missing(reports):
    report = reports.get("synth")
    absent = report["wanted"] - len(reports.rows("synth"))
    return f"{absent} rows" if absent or report["failed"] else ""


TABLES = {"organizations": organizations, "cores": cores, "transposes": transposes, "systems": systems, "prices": prices,
          "matrix": matrix, "critical_paths": critical_paths}
FIGURES = {"rows": lambda reports: len(reports.rows("synth"))}
