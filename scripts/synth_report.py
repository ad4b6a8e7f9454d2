"""build/reports/synth.json and synth.md: what the rows that have been mapped cost.

SPDX-License-Identifier: Apache-2.0
"""

import json

import mapped
import placement
import synthesis
import timing

FIELDS = ("lut", "lutram", "ff", "dsp", "bram", "cells", "area_um2", "depth", "power_mw",
          "critical_path", "kinds")
SHORT = ("lut", "lutram", "ff", "dsp", "bram", "cells", "area_um2", "depth", "fmax_mhz", "power_mw")
TITLES = {
    "generic": "Generic gates", "ecp5": "Lattice ECP5", "up5k": "Lattice iCE40 UltraPlus (UP5K)",
    "hx8k": "Lattice iCE40 HX8K", "xilinx7": "Xilinx 7 series",
    "osu018": "OSU 0.18 um standard cells",
}
HEADS = {
    "lut": "LUT", "lutram": "LUT as memory", "ff": "FF", "dsp": "multipliers", "bram": "memories",
    "cells": "cells", "area_um2": "area um2", "depth": "depth", "fmax_mhz": "MHz",
    "power_mw": f"mW at {1000 // timing.PERIOD_NS} MHz",
}
DSP = {"ecp5": "MULT18X18D", "up5k": "SB_MAC16", "hx8k": "none", "xilinx7": "DSP48E1"}
BRAM = {"ecp5": "DP16KD", "up5k": "SB_RAM40_4K", "hx8k": "SB_RAM40_4K", "xilinx7": "RAMB18E1"}
WIRED = "-bspline"


def clock(place, subject, result):
    """What is known of a row's clock: after routing where `make pnr` has been, of standard cells
    from their timing.
    """
    return place.clock(subject) or {"fmax_mhz": result.get("fmax_mhz"), "fmax_share": None,
                                    "routed": False, "seeds": []}


def collect(work, found):
    """One dictionary for each subject that has a result, in order."""
    shown, place = [], placement.Placement(work)
    for subject in found:
        result = work.result(subject)
        if result is not None:
            row = subject.row
            shown.append({
                "subject": subject, "name": row.name, "org": row.org, "n": row.n,
                "format": row.format, "schedule": row.schedule, "target": subject.target,
                "top": subject.top, **{field: result.get(field) for field in FIELDS},
                **clock(place, subject, result), "flat": subject.flat, "seconds": result["seconds"],
            })
    return shown


def columns(target):
    timed = ("fmax_mhz", "power_mw") if target == synthesis.CELLS else ()
    if target in placement.DEVICES:
        timed = ("fmax_mhz",)
    return (*mapped.FIELDS[target], "depth", *timed)


def head(target, field):
    return {"dsp": DSP, "bram": BRAM}.get(field, {}).get(target, HEADS[field])


def number(value):
    return "-" if value is None else f"{value:,}"


def table(heads, rows, left=1):
    """Markdown; the first `left` columns are words, the others numbers."""
    rules = ["---"] * left + ["--:"] * (len(heads) - left)
    lines = [heads, rules, *rows]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines)


def target_tables(shown, target):
    """The rows of one target: organizations in fixed point, in binary32, whole cores, units."""
    parts = []
    for title, tops, fixed in (
            ("Fixed and block floating point, `ffd_org_select`", (synthesis.ORGANIZATION,), True),
            ("Binary32, `ffd_org_select`", (synthesis.ORGANIZATION,), False),
            ("Whole cores, `hwffd_stream`", (synthesis.CORE,), None),
            ("With DMA and registers, `hwffd_axi`", (synthesis.SYSTEM,), None),
            ("Binary32 units by themselves", synthesis.FLOAT_UNITS, None)):
        rows = [row for row in shown if row["target"] == target and row["top"] in tops
                and fixed in (None, row["subject"].fixed)]
        if not rows:
            continue
        method = "flat" if rows[0]["flat"] else "units kept apart"
        parts.append(f"{title}, {method}:\n\n" + table(
            ["row", "N", *(head(target, field) for field in columns(target))],
            [[row["name"], row["n"], *(number(row[field]) for field in columns(target))]
             for row in rows]))
    return parts


def generality(shown):
    """The wired-in B-spline beside the general evaluator, target by target."""
    by_key = {(row["name"], row["top"], row["target"]): row for row in shown}
    parts = []
    for target in synthesis.TARGETS:
        lines = []
        for wired in shown:
            if wired["target"] != target or not wired["name"].endswith(WIRED):
                continue
            name = wired["name"][: -len(WIRED)]
            general = by_key.get((name, wired["top"], target))
            if general is None:
                continue
            for word, row in (("general", general), ("wired in", wired)):
                lines.append([f"{name}, `{row['top']}`", word,
                              *(number(row[field]) for field in columns(target))])
            lines.append(["", "general / wired in", *(
                f"{general[field] / wired[field]:.2f}" if wired[field] else "-"
                for field in columns(target))])
        if lines:
            heads = ["row", "evaluator", *(head(target, field) for field in columns(target))]
            parts.append(f"{TITLES[target]}:\n\n" + table(heads, lines, 2))
    return parts


def _plain(row):
    """A row that differs from the others of its format by its organization and N only."""
    suffix = row["name"].split("-")[2:]
    return suffix == ["overlapped"] and row["top"] == synthesis.ORGANIZATION


def matrix(shown, target, fields):
    """Organizations down, formats across: sums of `fields`."""
    rows = [row for row in shown if row["target"] == target and _plain(row)]
    formats = list(dict.fromkeys(row["format"] for row in rows))
    names = list(dict.fromkeys(row["name"].split("-")[0] for row in rows))
    value = {(row["name"].split("-")[0], row["format"]): sum(row[field] for field in fields)
             for row in rows}
    return table(["organization", *formats], [
        [name, *(number(value.get((name, form))) for form in formats)] for name in names])


def totals(shown):
    parts = []
    for target in synthesis.TARGETS:
        wanted = {
            "generic": [(("cells",), "cells")],
            "hx8k": [(("lut",), "LUT")],
            synthesis.CELLS: [((field,), head(target, field)) for field in ("area_um2", "fmax_mhz")],
        }.get(target, [(("lut", "lutram"), "LUT, memory included"), (("dsp",), head(target, "dsp"))])
        if not any(row["target"] == target and _plain(row) for row in shown):
            continue
        parts += [f"{TITLES[target]}, {title}:\n\n" + matrix(shown, target, fields)
                  for fields, title in wanted]
    return parts


def cells_by_kind(shown):
    """Kinds of cells down, organizations in fx18 across, target by target."""
    parts = []
    for target in synthesis.TARGETS:
        rows = [row for row in shown
                if row["target"] == target and row["format"] == "fx18" and _plain(row)]
        kinds = sorted({kind for row in rows for kind in row["kinds"]})
        if rows:
            parts.append(f"{TITLES[target]}:\n\n" + table(
                ["cell", *(row["name"].split("-")[0] for row in rows)],
                [[f"`{kind}`", *(number(row["kinds"].get(kind, 0)) for row in rows)]
                 for kind in kinds]))
    return parts


def critical_paths(shown):
    """Where the longest paths of standard cells begin and end."""
    return table(["row", "top", "MHz", "critical path"], [
        [row["name"], f"`{row['top']}`", number(row["fmax_mhz"]), row["critical_path"]]
        for row in shown if row["critical_path"]], 2)


def markdown(work, found, shown, failed):
    parts = ["# Mapped by yosys",
             f"{work.version}, OpenSTA {work.sta_version or 'not here'}. Mapped, not placed: clocks and "
             "power are of standard cells without wires. What each number counts is in "
             "synth/README.md."]
    absent = len(found) - len(shown)
    if absent:
        parts.append(f"{absent} of {len(found)} rows have not been mapped from the present "
                     "sources and are not shown; `make synth` maps them.")
    parts += [f"Failed: {subject}: {complaint} (`{work.log(subject)}`)"
              for subject, complaint in failed]
    for target in synthesis.TARGETS:
        tables = target_tables(shown, target)
        if tables:
            parts += [f"## {TITLES[target]}", *tables]
    price = generality(shown)
    if price:
        parts += ["## The price of generality",
                  "`basic` with the general evaluator, whose blending functions are loaded, and "
                  "with the uniform cubic B-spline wired in.", *price]
    sums = totals(shown)
    if sums:
        parts += ["## Organizations side by side", *sums]
    kinds = cells_by_kind(shown)
    if kinds:
        parts += ["## Cells by kind", *kinds]
    if any(row["critical_path"] for row in shown):
        parts += ["## Critical paths of standard cells",
                  "A name is that of the register in the sources, or of a port.",
                  critical_paths(shown)]
    return "\n\n".join(parts) + "\n"


def write(work, found, failed, folder):
    """Writes both reports and returns the rows that they show."""
    shown = collect(work, found)
    rows = [{key: value for key, value in row.items() if key != "subject"} for row in shown]
    text = ",\n".join("    " + json.dumps(row) for row in rows)
    broken = json.dumps([{"name": s.row.name, "top": s.top, "target": s.target, "error": why}
                         for s, why in failed])
    synthesis.write(folder / "synth.json",
                    f'{{\n  "yosys": {json.dumps(work.version)},\n'
                    f'  "sta": {json.dumps(work.sta_version)},\n  "wanted": {len(found)},\n'
                    f'  "failed": {broken},\n  "rows": [\n{text}\n  ]\n}}\n')
    synthesis.write(folder / "synth.md", markdown(work, found, shown, failed))
    return shown


def short(shown):
    """The rows for a terminal, in columns that some row fills."""
    fields = [field for field in SHORT if any(row[field] is not None for row in shown)]
    heads = ["lut ram" if field == "lutram" else HEADS[field] for field in fields]
    lines = [("row", "top", "target", *heads)]
    lines += [(row["name"], row["top"], row["target"], *(number(row[field]) for field in fields))
              for row in shown]
    widths = [max(len(line[i]) for line in lines) for i in range(len(lines[0]))]
    return "\n".join("  ".join(
        word.ljust(width) if i < 3 else word.rjust(width)
        for i, (word, width) in enumerate(zip(line, widths))).rstrip() for line in lines)
