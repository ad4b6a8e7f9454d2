"""Proves the properties of lab/formal/properties.csv, and that each proof finds a planted bug.

Writes build/reports/formal.json and formal.md. What has been proved here before, of the same sources, is
kept in build/formal/ and not proved again. The exit status is 1 if one is not proved or its planted bug
is not found, 2 if the request makes no sense.

SPDX-License-Identifier: Apache-2.0
"""

import fnmatch
import shutil
import sys
import time

from lab.figures.studies import formal as properties
from lab.formal import proofs, report
from tools import command_line
from tools.synth import engine

# Properties between two looks at the clock, where there is a time.
AT_ONCE = 6


def portions(groups, everything, minutes):
    """What to prove next, with its lemmas: all of it, or where there is a time a few at once until it is up."""
    if minutes is None:
        groups = [[prop for group in groups for prop in group]]
    end, tried = time.monotonic() + 60 * (minutes or 0), set()
    for group in groups:
        at_once = AT_ONCE if minutes is not None else len(group) or 1
        for place in range(0, len(group), at_once):
            if minutes is not None and tried and time.monotonic() >= end:
                return
            portion = group[place:place + at_once]
            lemmas = {(prop.module, name) for prop in portion for name in prop.lemmas.split()}
            portion = [prop for prop in everything
                       if prop not in tried and (prop in portion or (prop.module, prop.name) in lemmas)]
            tried.update(portion)
            yield portion


def run(proving, wanted, jobs):
    """Proves what has no verdict yet: verdicts and complaints by property. Only clear verdicts are
    kept; the others depend on how much time there was. Raises EngineError."""
    files, failed = {}, {}
    for prop in wanted:
        try:
            files[prop] = [] if proving.result(prop) else proving.files(prop)
            for path in files[prop]:
                if not path.with_suffix(".seconds").is_file():  # of a run that was broken off
                    path.unlink(missing_ok=True)
        except proofs.ProofError as error:
            failed[prop] = str(error)
    complaints = engine.run(proving.root, "formal", files, jobs, (f"limit={proving.limit}",), "properties",
                            "lab/formal/Snakefile")
    failed.update((prop, proofs.in_words(complaint)) for prop, complaint in complaints.items())
    verdicts = {prop: proving.result(prop) for prop in files if prop not in failed}
    for prop, verdict in verdicts.items():
        if proofs.UNDECIDED in verdict.values():
            for path in proving.files(prop):
                path.unlink()
    return verdicts, failed


def work(options, root):
    for tool in ("yosys", "yosys-abc"):
        if not shutil.which(tool):
            raise engine.EngineError(f"{tool} not found: run tools/install engine")
    everything = proofs.read(root / proofs.TABLE)
    wanted = [prop for prop in everything
              if fnmatch.fnmatchcase(prop.full_name, options.only or "*")]
    proving = proofs.Proofs(root, options.limit)
    groups = [wanted]
    if options.since:
        groups = proofs.changed_since(proving, wanted, options.since)
        if not groups:
            print(f"formal: nothing under proof has changed since {options.since}")
            return 0
    if not wanted:
        raise command_line.Request(f"no property matches '{options.only}'")
    verdicts, failed, wanted = {}, {}, []
    for portion in portions(groups, everything, options.minutes):
        for whole, part in zip((verdicts, failed), run(proving, portion, options.jobs)):
            whole.update(part)
        wanted += portion
    shown = report.write(proving, everything, verdicts, failed, root / "build" / "reports")
    complaints = {(row["module"], row["name"]): (properties.complaint(row), row) for row in shown}
    bad = 0
    for prop in wanted:
        complaint, row = complaints[prop.module, prop.name]
        if complaint:
            bad += 1
            print(f"formal: {prop}: {complaint}" + (
                "" if row["result"] == "error" else f": see {proving.log(prop)}"), file=sys.stderr)
    print(f"formal: {len(wanted) - bad} of {len(wanted)} properties proved, each with its planted"
          " bug found")
    left = len({prop for group in groups for prop in group} - set(wanted))
    if left:
        print(f"formal: {left} that changed earlier were not tried: {options.minutes:g} minutes were up")
    print("wrote build/reports/formal.json and build/reports/formal.md")
    return 1 if bad else 0


if __name__ == "__main__":
    parser = command_line.Parser(prog="formal", description="Proves properties of the RTL.")
    parser.add_argument("--only", help="a pattern of MODULE.NAME; lemmas that are needed come too")
    parser.add_argument("--since", metavar="COMMIT", help="only what has changed since that commit")
    parser.add_argument("--minutes", type=float,
                        help="with --since: what changed last is proved first, and nothing begun after that time")
    parser.add_argument("--limit", type=int, default=600, help="seconds a proof may take")
    sys.exit(command_line.run(parser, work, (proofs.ProofError, engine.EngineError)))
