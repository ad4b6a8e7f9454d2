"""The command tools/figures.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import importlib
import pathlib
import sys

from figures import check, measure, sources
from figures.catalogue import CHARTS
from figures.reports import COMMITTED, FRESH, Missing, Reports, RequestError

ROOT = pathlib.Path(__file__).resolve().parents[2]


def draw(root, source, target, names=None):
    """Every picture whose reports are in `source`, into `target`; the files written."""
    reports, written = Reports(root, source), []
    for name, needed in CHARTS.items():
        if (names is None or set(names) & set(needed)) and all(map(reports.has, needed)):
            written += importlib.import_module(f"figures.charts.{name}").draw(
                reports, root / target)
    return written


def fill(root):
    """Puts the figures into every text; (texts changed, what is wrong, what no report says yet)."""
    reports, changed, wrong, unmeasured = Reports(root), [], [], []
    for path in check.texts(root):
        before, after, faults, missing = check.examine(root, path, reports)
        wrong += faults
        unmeasured += missing
        if after != before:
            path.write_text(after, encoding="utf-8")
            changed.append(path)
    return changed, wrong, unmeasured


def do_all(options):
    """Pictures and figures in texts from the committed reports, pictures of fresh ones beside
    them.
    """
    shown = draw(options.root, COMMITTED, "docs")
    draw(options.root, FRESH, FRESH)
    print(f"drew {len(shown)} pictures in docs/")
    return do_fill(options)


def do_fill(options):
    changed, wrong, unmeasured = fill(options.root)
    for line in [*wrong, *unmeasured]:
        print(f"figures: {line}", file=sys.stderr)
    print(f"filled {len(check.texts(options.root))} texts, {len(changed)} changed")
    return 1 if wrong else 0


def do_check(options):
    _, wrong, stale = check.check(options.root)
    for line in [*wrong, *stale]:
        print(line)
    print(f"figures: {len(wrong)} wrong, {len(stale)} to be measured")
    return 1 if wrong or (stale and options.strict) else 0


def do_adopt(options):
    for name in options.names:
        written = measure.adopt(options.root, name, options.part)
        print(f"wrote {written.relative_to(options.root)}")
    return 0


def do_measure(options):
    names = options.names.split(",")
    status, changed = measure.run(options.root, names, options.command)
    if changed and options.show:
        measure.show(options.root, changed)
        try:
            written = draw(options.root, FRESH, FRESH, changed)
            if written:
                print("drew " + ", ".join(str(path.relative_to(options.root)) for path in written))
        except ImportError as error:
            print(f"no pictures: {error}: run tools/install figures", file=sys.stderr)
    return status


def main(arguments=None):
    parser = argparse.ArgumentParser(
        prog="figures", description="Draws what studies have measured and fills it into texts; "
        "without a command all of it, from docs/reports/.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to work on")
    parser.set_defaults(do=do_all)
    commands = parser.add_subparsers(title="commands")
    commands.add_parser("fill", help="the texts only").set_defaults(do=do_fill)
    checking = commands.add_parser("check", help="whether texts are what their reports say")
    checking.add_argument("--strict", action="store_true", help="a stale report is a fault too")
    checking.set_defaults(do=do_check)
    adopting = commands.add_parser("adopt", help="takes build/reports/NAME.json into docs/reports/")
    adopting.add_argument("names", nargs="+", metavar="NAME")
    adopting.add_argument("--part", action="store_true", help="also where rows are missing")
    adopting.set_defaults(do=do_adopt)
    measuring = commands.add_parser("measure", help="runs a study, stamps and prints its report")
    measuring.add_argument("--quiet", dest="show", action="store_false",
                           help="neither prints nor draws")
    measuring.add_argument("names", metavar="NAME,...", help="then -- and the command to run")
    measuring.set_defaults(do=do_measure)
    words = list(sys.argv[1:] if arguments is None else arguments)
    at = words.index("--") if "--" in words else len(words)
    options = parser.parse_args(words[:at])
    options.command = words[at + 1:]
    options.root = options.root.absolute()
    try:
        return options.do(options)
    except KeyboardInterrupt:
        return 130
    except Missing as missing:
        print(f"figures: there is no report yet: {missing}", file=sys.stderr)
    except (RequestError, sources.SourceError, OSError) as error:
        print(f"figures: {error}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    sys.exit(main())
