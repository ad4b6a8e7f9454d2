"""make figures and what studies print: tables, pictures and the blocks of the texts.

    python3 -m lab.figures [write [--version VERSION] | check | run NAME,... -- COMMAND | show NAME,...]

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import importlib
import json
import pathlib
import signal
import subprocess
import sys
import traceback

from lab.figures.modules import CHARTS, MODULES, TEXTS
from tools import venv_packages, whole_file
from tools.project_root import ROOT
from tools.reports import report_modules, results, text_blocks


def draw(reports, folder, names=None):
    """Every picture whose reports are there, or those of these reports; the files written."""
    written = []
    for name, needed in CHARTS.items():
        if (names is None or set(names) & set(needed)) and all(map(reports.has, needed)):
            written += importlib.import_module(f"lab.figures.charts.{name}").draw(reports, folder)
    return written


def write(options):
    """The pictures in docs/ of a release, and the blocks of all texts."""
    released = results.released(options.root, options.version, MODULES)
    print(f"drew {len(draw(released, options.root / 'docs'))} pictures in docs/")
    blocks = text_blocks.Blocks(options.root, MODULES, TEXTS, cure="make -C lab figures")
    changed, wrong = blocks.write(options.version)
    for line in wrong:
        print(f"figures: {line}", file=sys.stderr)
    print(f"wrote the blocks of {len(blocks.texts())} texts, {len(changed)} changed")
    return 1 if wrong else 0


def check(options):
    """Whether texts are what the results of the versions say that they name, and folders are of one commit."""
    count, wrong = text_blocks.Blocks(options.root, MODULES, TEXTS, cure="make -C lab figures").check()
    wrong += text_blocks.releases(options.root)
    for line in wrong:
        print(line)
    print(f"figures: {count} texts, {len(wrong)} wrong")
    return 1 if wrong else 0


def show(options):
    """Prints reports of build/reports and draws them there."""
    fresh = results.Results(options.root, modules=MODULES)
    names = options.names.split(",")
    report_modules.show(fresh, names)
    try:
        drawn = draw(fresh, fresh.folder, names)
        if drawn:
            print("drew " + ", ".join(str(path.relative_to(options.root)) for path in drawn))
    except ImportError as error:
        print(f"no pictures: {error}: make -C lab figures installs what draws", file=sys.stderr)
    except (results.Missing, results.RequestError) as error:  # of another report that a picture needs
        print(f"no pictures: {error}", file=sys.stderr)
    return 0


def run(options):
    """Runs a command that measures, finishes the reports that it has written, and shows them. Its exit status,
    also where no table can be made of a report: what was measured is there."""
    fresh = results.Results(options.root, modules=MODULES)
    names = options.names.split(",")
    before = {name: _written(fresh.path(name)) for name in names}
    status = _ended(options.command)
    changed = [name for name in names if _written(fresh.path(name)) not in (None, before[name])]
    for name in changed:
        if hasattr(MODULES.get(name), "finished"):
            whole_file.write(fresh.path(name), json.dumps(MODULES[name].finished(fresh)) + "\n")
    try:
        if changed and options.show:
            options.names = ",".join(changed)
            show(options)
    except Exception:  # pylint: disable=broad-exception-caught
        traceback.print_exc()
        print(f"figures: {', '.join(changed)}: measured, but not shown: see above", file=sys.stderr)
    return status


def _written(path):
    return path.stat().st_mtime_ns if path.is_file() else None


def _ended(command):
    """Its exit status. An interrupt is the command's to answer, which has its own order to restore: a
    terminal interrupts both, what ends this program is passed on, and then the command is awaited."""
    with subprocess.Popen(command) as process:
        signal.signal(signal.SIGINT, lambda *_: None)
        signal.signal(signal.SIGTERM, lambda *_: process.terminate())
        status = process.wait()
    return status if status >= 0 else 128 - status  # as a shell has it


def main(arguments=None):
    parser = argparse.ArgumentParser(prog="figures", description="Tables and pictures of what has been measured, "
                                     "and the blocks of the texts; without a command it writes these.")
    parser.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to work on")
    parser.set_defaults(do=write, version="")
    commands = parser.add_subparsers(title="commands")
    writing = commands.add_parser("write", help="pictures in docs/ and the blocks of the texts")
    writing.add_argument("--version", default="", help="makes all blocks and pictures those of this release")
    writing.set_defaults(do=write)
    commands.add_parser("check", help="whether texts are what the results say").set_defaults(do=check)
    showing = commands.add_parser("show", help="prints and draws reports of build/reports")
    running = commands.add_parser("run", help="runs a study and shows its reports")
    running.add_argument("--quiet", dest="show", action="store_false", help="neither prints nor draws")
    for command, do in ((showing, show), (running, run)):
        command.add_argument("names", metavar="NAME,...", help="of reports; of run then -- and the command")
        command.set_defaults(do=do)
    words = list(sys.argv[1:] if arguments is None else arguments)
    at = words.index("--") if "--" in words else len(words)
    options = parser.parse_args(words[:at])
    options.command = words[at + 1:]
    options.root = options.root.absolute()
    try:
        return options.do(options)
    except KeyboardInterrupt:
        return 130
    except (results.Missing, results.RequestError, OSError) as error:
        print(f"figures: {error}", file=sys.stderr)
    return 1


if __name__ == "__main__":
    venv_packages.enter("requirements-figures.txt")
    sys.exit(main())
