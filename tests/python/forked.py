"""A program of the package as a process of its own, but with what this one has imported: its start takes most of its time.

SPDX-License-Identifier: Apache-2.0
"""

import io
import os
import runpy
import subprocess
import sys
import tempfile
import traceback
import warnings


def run(folder, program, *words):
    """What the program, a file of Python, did there: its status, and all that it wrote, as text."""
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
        child = os.fork()
        if child == 0:
            _become(folder, program, words, (out, errors))
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        texts = []
        for file in out, errors:
            file.seek(0)
            texts.append(file.read().decode(errors="surrogateescape"))
    return subprocess.CompletedProcess([program, *words], status, *texts)


def _become(folder, program, words, files):
    """The program, in a child; does not come back."""
    status = 1
    try:
        os.chdir(folder)
        for number, file in enumerate(files, 1):
            os.dup2(file.fileno(), number)
        sys.stdin = open(os.devnull, encoding="utf-8")  # pylint: disable=consider-using-with
        sys.stdout, sys.stderr = (
            io.TextIOWrapper(io.FileIO(number, "w", closefd=False), errors=stream.errors, write_through=True)
            for number, stream in ((1, sys.__stdout__), (2, sys.__stderr__)))
        sys.argv = [str(program), *map(str, words)]
        with warnings.catch_warnings():  # as in a process that begins
            warnings.resetwarnings()
            warnings.simplefilter("default")
            status = _ended(program)
    finally:
        os._exit(status)


def _ended(program):
    try:
        runpy.run_path(str(program), run_name="__main__")
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
            return 1
        return end.code or 0
    except BaseException:  # pylint: disable=broad-exception-caught
        traceback.print_exc()
        return 1
    return 0
