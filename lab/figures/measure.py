"""Runs a study and stamps its report; takes a report into the folder that is committed.

SPDX-License-Identifier: Apache-2.0
"""

import json
import signal
import subprocess
import sys

from figures import sources
from figures.catalogue import REPORTS, missing, module, printed
from figures.reports import COMMITTED, FRESH, Reports, RequestError

STAMP = "measured"


def dump(report):
    """JSON with a line for each row."""
    parts = []
    for key, value in report.items():
        if isinstance(value, list) and value and all(isinstance(row, dict) for row in value):
            text = "[\n" + ",\n".join("    " + json.dumps(row) for row in value) + "\n  ]"
        else:
            text = json.dumps(value)
        parts.append(f"  {json.dumps(key)}: {text}")
    return "{\n" + ",\n".join(parts) + "\n}\n"


def stamped(report, name, key):
    """The report with where it comes from, first."""
    rest = {key: value for key, value in report.items() if key != STAMP}
    return {STAMP: {"command": REPORTS[name].command, "sources": key}, **rest}


def _written(path):
    return path.stat().st_mtime_ns if path.is_file() else None


def _sources(root, name):
    """None where they cannot be hashed: a study runs without that."""
    try:
        return sources.key(root, REPORTS[name].sources)
    except sources.SourceError as error:
        print(f"figures: the report gets no stamp: {error}", file=sys.stderr)
        return None


def _ended(command):
    """Its exit status. An interrupt is the command's to answer, which has its own order to restore: a
    terminal interrupts both, what ends this program is passed on, and then the command is awaited."""
    with subprocess.Popen(command) as process:
        signal.signal(signal.SIGINT, lambda *_: None)
        signal.signal(signal.SIGTERM, lambda *_: process.terminate())
        return process.wait()


def run(root, names, command):
    """Runs a command that measures; (its exit status, reports that it wrote). What it wrote is
    finished, and stamped with the sources as they were before if it ended well; or if all was measured
    and the report itself says in `short` which aims were missed.
    """
    fresh = Reports(root, FRESH)
    before = {name: (_written(fresh.path(name)), _sources(root, name)) for name in names}
    status = _ended(command)
    status = status if status >= 0 else 128 - status  # as a shell has it
    changed = []
    for name, (written, key) in before.items():
        path = fresh.path(name)
        getattr(module(name), "collect", lambda _: None)(root)
        if _written(path) in (None, written):
            continue
        changed.append(name)
        report = getattr(module(name), "finished", lambda reports: reports.get(name))(fresh)
        if key and (status == 0 or report.get("short")):
            report = stamped(report, name, key)
        path.write_text(dump(report), encoding="utf-8")
    return status, changed


def _without(value, volatile):
    if isinstance(value, dict):
        return {key: _without(one, volatile) for key, one in value.items() if key not in volatile}
    if isinstance(value, list):
        return [_without(one, volatile) for one in value]
    return value


def with_older(report, kept, name):
    """The report with those rows of the one committed before that it has none for, marked `older`,
    in the order of that one; what was not there comes last. A figure beside the rows that was not
    measured stays as it was.
    """
    field, identity = REPORTS[name].rows, REPORTS[name].identity
    new = {tuple(row[one] for one in identity): row for row in report[field]}
    old = {tuple(row[one] for one in identity): {**row, "older": True} for row in kept[field]}
    beside = {key: {**value, **{one: found for one, found in report[key].items() if found is not None}}
              for key, value in kept.items()
              if key != STAMP and isinstance(value, dict) and isinstance(report.get(key), dict)}
    return {**report, **beside, field: list({**old, **new}.values())}


def committed_form(report, name):
    """What of a report is committed: all but what differs from run to run."""
    return dump(_without(report, REPORTS[name].volatile))


def adopt(root, name, part=False):
    """Takes build/reports/NAME.json into docs/reports/. Raises RequestError where it is not of the
    present sources, or not whole and a part is not asked for. Beside a part stay the committed rows
    that it lacks, if rows have an identity.
    """
    if name not in REPORTS:
        raise RequestError(f"no report '{name}': one of {', '.join(REPORTS)}")
    fresh = Reports(root, FRESH)
    path = fresh.path(REPORTS[name].written or name)
    report, cure = fresh.get(name), REPORTS[name].command
    if STAMP not in report:
        raise RequestError(f"{path} is not of a run that ended well: {cure}")
    if report[STAMP]["sources"] != sources.key(root, REPORTS[name].sources):
        raise RequestError(f"{path} is older than its sources: {cure}")
    absent = missing(fresh, name)
    if absent and not part:
        raise RequestError(f"{path} is not whole: {absent}: {cure}; or adopt --part")
    committed = Reports(root, COMMITTED)
    if part and REPORTS[name].identity and committed.has(name):
        report = with_older(report, committed.get(name), name)
    kept = committed.path(name)
    kept.parent.mkdir(parents=True, exist_ok=True)
    kept.write_text(committed_form(stamped(report, name, report[STAMP]["sources"]), name),
                    encoding="utf-8")
    return kept


def show(root, names):
    """Prints fresh reports as tables."""
    fresh = Reports(root, FRESH)
    for name in names:
        sys.stdout.write(printed(fresh, name).rstrip("\n") + "\n\n")
    sys.stdout.flush()
