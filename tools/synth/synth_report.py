"""build/reports/synth.json and synth.md: what the rows that have been mapped cost.

SPDX-License-Identifier: Apache-2.0
"""

import json

from tools import whole_file
from tools.reports import synth_tables
from tools.reports.results import Results
from tools.synth import placement

FIELDS = ("lut", "lutram", "ff", "dsp", "bram", "cells", "area_um2", "depth", "power_mw",
          "critical_path", "kinds")


def clock(place, subject, result):
    """What is known of a row's clock: after routing where `make pnr` has been, with what the router
    does not know, of standard cells from their timing; and the vertices a second of what is routed, in
    any order and along rows of a grid.
    """
    routed = place.clock(subject)
    if not routed:
        return {"fmax_mhz": result.get("fmax_mhz"), "fmax_share": None, "routed": False, "seeds": [],
                "vertices_per_s": None, "row_vertices_per_s": None}
    unknown = placement.unknown(subject.target)
    any_order, rows = (round(routed["fmax_mhz"] * 1e6 / clocks) for clocks in subject.clocks)
    return {**routed, "vertices_per_s": any_order, "row_vertices_per_s": rows, **({"remark": unknown} if unknown else {})}


def collect(work, subjects):
    """One dictionary for each subject that has a result, in order."""
    shown, place = [], placement.Placement(work)
    for subject in subjects:
        result = work.result(subject)
        if result is not None:
            row, (variant, meaning) = subject.row, subject.variant
            shown.append({
                "subject": subject, "name": row.name, "variant": variant, "meaning": meaning,
                "org": row.org, "n": row.n,
                "format": row.format, "schedule": row.schedule, "target": subject.target,
                "top": subject.top, **{field: result.get(field) for field in FIELDS},
                **clock(place, subject, result), "flat": subject.flat, "seconds": result.get("seconds"),
            })
    return shown


def write(work, subjects, failed, folder):
    """Writes both reports and returns the rows that they show."""
    shown = collect(work, subjects)
    rows = [{key: value for key, value in row.items() if key != "subject"} for row in shown]
    text = ",\n".join("    " + json.dumps(row) for row in rows)
    broken = json.dumps([{"name": s.row.name, "top": s.top, "target": s.target, "error": why}
                         for s, why in failed])
    whole_file.write(folder / "synth.json",
                     f'{{\n  "yosys": {json.dumps(work.version)},\n'
                     f'  "sta": {json.dumps(work.sta_version)},\n  "wanted": {len(subjects)},\n'
                     f'  "failed": {broken},\n  "rows": [\n{text}\n  ]\n}}\n')
    whole_file.write(folder / "synth.md", synth_tables.document(Results(work.root)))
    return shown
