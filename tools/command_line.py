"""How a command that runs long begins and ends: its options, its complaint of one line, its status.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import os
import pathlib
import re
import signal
import sys

from tools.project_root import ROOT


class Request(Exception):
    """A request that makes no sense, in one line."""


class Parser(argparse.ArgumentParser):
    """Complains in one line."""

    def __init__(self, **more):
        super().__init__(**more)
        self.add_argument("--root", type=pathlib.Path, default=ROOT, help="checkout to look at")
        self.add_argument("-j", "--jobs", type=int, default=os.cpu_count() or 1)

    def error(self, message):
        print(f"{self.prog}: {message}", file=sys.stderr)
        sys.exit(2)


def assignments(words):
    """{name: number} of words NAME=NUMBER. Raises Request."""
    for word in words:
        if not re.fullmatch(r"[A-Z_]+=\d+", word):
            raise Request(f"'{word}': NAME=NUMBER wanted")
    return {name: int(value) for name, value in (word.split("=") for word in words)}


def run(parser, work, faults):
    """As `ended`, of work(options, root)."""
    options = parser.parse_args()
    return ended(parser.prog, lambda: work(options, options.root.absolute()), faults)


def ended(prog, work, faults):
    """work() and its exit status; 1 where it raises one of `faults`, 2 where the request makes no sense,
    130 where it was interrupted: what had been made by then is kept."""
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        return work()
    except Request as error:
        print(f"{prog}: {error}", file=sys.stderr)
        return 2
    except (*faults, OSError) as error:
        print(f"{prog}: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(f"{prog}: interrupted; what had been finished is kept", file=sys.stderr)
        return 130


def measured(prog, work, faults):
    """As `ended`, of what measures: work() says what does not hold, a line each, and 1 is for any."""
    def status():
        faults = work()
        for line in faults:
            print(f"{prog}: {line}", file=sys.stderr)
        return 1 if faults else 0

    return ended(prog, status, faults)
