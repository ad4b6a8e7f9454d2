"""Maps rows of the table of configurations with yosys and reports what they cost.

Writes build/reports/synth.json and synth.md: every row whose present sources have been mapped, in
this run or before. Rows whose sources have not changed are not run again. The exit status is 1 if a
row fails, 2 if the request makes no sense.

SPDX-License-Identifier: Apache-2.0
"""

import sys

from tools import command_line, csv_table
from tools.reports import synth_tables
from tools.synth import engine, liberty, selection, synth_report, synthesis


def work(options, root):
    subjects = synthesis.of_checkout(root)
    left = selection.chosen(subjects, options.set, options)
    synthesis.require(left)
    mapping = synthesis.Synthesis(root)
    failed = synthesis.run(mapping, left, options.jobs)
    shown = synth_report.write(mapping, subjects, failed, root / "build" / "reports")
    print(synth_tables.listed(None, [row for row in shown if row["subject"] in left]).text())
    for subject, complaint in failed:
        print(f"synth: {subject}: {complaint}", file=sys.stderr)
    print("wrote build/reports/synth.json and build/reports/synth.md")
    return 1 if failed else 0


if __name__ == "__main__":
    parser = selection.Parser(prog="synth", description="Maps rows of the table.")
    parser.add_argument("--set", default="all", help="all; ci, a subset of two minutes; baseline")
    sys.exit(command_line.run(parser, work, (csv_table.TableError, engine.EngineError, liberty.LibertyError)))
