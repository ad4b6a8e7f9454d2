"""Commands that make files by Snakemake, which they start from what is imported already: its imports take a second.

SPDX-License-Identifier: Apache-2.0
"""

import os

try:
    from snakemake import cli
except ImportError:  # where it is one of the system
    cli = None

from tests.support import forked
from tools import project_root
from tools.synth import engine


class _Snakemake:
    """What engine.py wants of a process, for the words of a command line of Snakemake."""

    def __init__(self, words, **_):
        reading, writing = os.pipe()
        self.pid = os.fork()
        if self.pid == 0:
            os.setsid()
            forked.become(lambda: cli.main(words[1:]), ".", words, project_root.environment(), writing, writing)
        os.close(writing)
        self.stdout = open(reading, encoding="utf-8", errors="replace")  # pylint: disable=consider-using-with

    def wait(self):
        self.stdout.close()
        return os.waitstatus_to_exitcode(os.waitpid(self.pid, 0)[1])


def _instead():
    engine.start = _Snakemake


def module(root, name, *words, **environment):
    """(exit status, what it printed, its complaints) of a module of the checkout, run in a folder."""
    result = forked.run_module(root, name, *words, env={**os.environ, **environment}, instead=_instead if cli else None)
    return result.returncode, result.stdout, result.stderr
