"""Compares what yosys makes of some rows with synth/baseline.csv, or writes that file.

`check` fails, a line each, when area or depth has grown by more than 3 %, and says where one has
shrunk by as much. `write` maps the whole set `baseline` and keeps its figures.

SPDX-License-Identifier: Apache-2.0
"""

import sys

from tools import command_line, csv_table, whole_file
from tools.synth import baseline, engine, liberty, selection, synthesis

SET = "baseline"


def figures(mapping, wanted, jobs):
    """[(subject, result)], mapped now or before. Raises baseline.BaselineError."""
    failed = [f"{subject}: {complaint}"
              for subject, complaint in synthesis.run(mapping, wanted, jobs)]
    for line in failed[1:]:
        print(f"synth_baseline: {line}", file=sys.stderr)
    if failed:
        raise baseline.BaselineError(failed[0])
    return [(subject, mapping.result(subject)) for subject in wanted]


def check(mapping, path, results, everything):
    grown, notes, compared = baseline.compare(mapping.version, baseline.read(path), results, everything)
    for line in notes:
        print(f"synth_baseline: {line}")
    for line in grown:
        print(f"synth_baseline: {line}", file=sys.stderr)
    print(f"synth_baseline: {len(results)} rows, {compared} figures compared, "
          f"{len(grown)} more than {baseline.PERCENT} % above")
    return 1 if grown else 0


def work(options, root):
    path = root / "synth" / "baseline.csv"
    everything = synthesis.of_set(synthesis.of_checkout(root), SET)
    wanted = selection.chosen(everything, SET, options)
    if options.command == "write" and wanted != everything:
        raise command_line.Request("write maps the whole set: no TARGET=, ORG=, N=, FORMAT=")
    synthesis.require(wanted)
    mapping = synthesis.Synthesis(root)
    results = figures(mapping, wanted, options.jobs)
    if options.command == "check":
        return check(mapping, path, results, wanted == everything)
    whole_file.write(path, baseline.text(mapping.version, results))
    print(f"wrote synth/baseline.csv: {len(results)} rows")
    return 0


if __name__ == "__main__":
    parser = selection.Parser(prog="synth_baseline", description="Guards area and depth.")
    parser.add_argument("command", choices=("check", "write"))
    sys.exit(command_line.run(parser, work, (csv_table.TableError, engine.EngineError, liberty.LibertyError,
                                             baseline.BaselineError)))
