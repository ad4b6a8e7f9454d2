"""Places and routes the rows of synth/clocks.csv and reports the clocks that they reach.

Writes build/reports/pnr.json and pnr.md, and puts the clocks into synth.json and synth.md. What has
been routed from the present sources is not routed again. The exit status is 1 if something could
not be routed, 2 if the request makes no sense; a clock that falls short is reported, not a failure.

SPDX-License-Identifier: Apache-2.0
"""

import json
import sys

from tools import command_line, csv_table, whole_file
from tools.reports import pnr_tables
from tools.reports.results import Results
from tools.synth import engine, nextpnr, placement, selection, synth_report, synthesis


def chosen(aims, options):
    """The aims asked for. Raises Request where there are none."""
    left = aims
    for name, (value, column) in selection.columns(options).items():
        known = list(dict.fromkeys(column(aim.subject) for aim in left))
        left = [aim for aim in left if value is None or column(aim.subject) == value]
        if not left:
            raise command_line.Request(f"no row of synth/clocks.csv for {name}={value}: one of "
                                       f"{', '.join(known)}")
    return left


def report(place, aims):
    """One dictionary for each row that has been routed."""
    rows = []
    for aim in aims:
        subject = aim.subject
        results = place.results(subject)
        if not results:
            continue
        clocks = [result["fmax_mhz"] for result in results]
        clock = place.clock(subject)
        slowest = min(results, key=lambda result: result["fmax_mhz"])
        rows.append({
            "name": subject.row.name, "top": subject.top, "target": subject.target,
            "device": placement.DEVICES[subject.target].name, "fmax_mhz": clock["fmax_mhz"],
            "fmax_min": min(clocks), "fmax_max": max(clocks), "fmax_share": clock["fmax_share"],
            "aim_share": aim.share, "aim_mhz": aim.mhz, "reached": aim.reached(clock),
            "seeds": clock["seeds"], "critical_path": slowest["critical_path"],
            **place.remarks(subject)})
    return rows


def work(options, root):
    subjects, reports = synthesis.of_checkout(root), root / "build" / "reports"
    aims = placement.read(root / placement.TABLE, subjects)
    left = chosen(aims, options)
    place = placement.Placement(synthesis.Synthesis(root))
    place.work.prepare([aim.subject for aim in left], options.jobs)
    failed = engine.run(root, "pnr", place.wanted(left), options.jobs)
    rows = report(place, aims)
    measures = {target: None if device.unknown else place.median(placement.Measure(target))
                for target, device in placement.DEVICES.items()}
    whole_file.write(reports / "pnr.json", json.dumps(
        {"multiplier_mhz": measures, "rows": rows,
         "short": [f"{subject.name}: {complaint}" for subject, complaint in failed.items()]}, indent=1) + "\n")
    whole_file.write(reports / "pnr.md", pnr_tables.document(Results(root)))
    synth_report.write(place.work, subjects, [], reports)
    print(pnr_tables.listed(None, rows).text())
    for subject, complaint in failed.items():
        print(f"pnr: {subject.name}: {complaint}", file=sys.stderr)
    print("wrote build/reports/pnr.json and build/reports/pnr.md")
    return 1 if failed else 0


if __name__ == "__main__":
    parser = selection.Parser(prog="pnr", description="Routes the rows of synth/clocks.csv.")
    sys.exit(command_line.run(parser, work, (csv_table.TableError, engine.EngineError,
                                             nextpnr.NextpnrError)))
