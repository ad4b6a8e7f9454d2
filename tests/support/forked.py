"""Programs as processes of their own, but with what this one has imported: the start of one takes most of its time.

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
    """What a program, a file of Python, did in a folder: its status, and all that it wrote, as text."""
    return _run(lambda: runpy.run_path(str(program), run_name="__main__"), folder, [str(program), *map(str, words)])


def run_module(folder, name, *words, env, instead=None):
    """The same of a module that is a command, with another environment; `instead` is called before it."""
    def begin():
        if instead:
            instead()
        runpy.run_module(name, run_name="__main__", alter_sys=True)
    return _run(begin, folder, [name, *map(str, words)], env)


def _run(begin, folder, words, env=None):
    with tempfile.TemporaryFile() as out, tempfile.TemporaryFile() as errors:
        child = os.fork()
        if child == 0:
            become(begin, folder, words, env, out.fileno(), errors.fileno())
        status = os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
        texts = []
        for file in out, errors:
            file.seek(0)
            texts.append(file.read().decode(errors="surrogateescape"))
    return subprocess.CompletedProcess(words, status, *texts)


def become(begin, folder, words, env, out, errors):
    """The program that `begin` is, in a child; does not come back."""
    status = 1
    try:
        os.chdir(folder)
        if env is not None:
            os.environ.clear()
            os.environ.update(env)
        for number, file in enumerate((out, errors), 1):
            os.dup2(file, number)
        os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
        sys.stdin = open(0, encoding="utf-8", closefd=False)  # pylint: disable=consider-using-with
        sys.stdout, sys.stderr = (
            io.TextIOWrapper(io.FileIO(number, "w", closefd=False), errors=stream.errors, write_through=True)
            for number, stream in ((1, sys.__stdout__), (2, sys.__stderr__)))
        sys.argv = words
        with warnings.catch_warnings():  # as in a process that begins
            warnings.resetwarnings()
            warnings.simplefilter("default")
            status = _ended(begin)
    finally:
        os._exit(status)


def _ended(begin):
    try:
        begin()
    except SystemExit as end:
        if isinstance(end.code, str):
            print(end.code, file=sys.stderr)
            return 1
        return end.code or 0
    except BaseException:  # pylint: disable=broad-exception-caught
        traceback.print_exc()
        return 1
    return 0
