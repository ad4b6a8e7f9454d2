"""Runs a solver on a script, in a process of its own: `python solve.py SOLVER SCRIPT`.

Prints unsat, sat with a word for each variable, or unknown.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import subprocess
import sys
import time
from importlib import metadata


def _bitwuzla(path):
    import bitwuzla  # pylint: disable=import-outside-toplevel
    manager, options = bitwuzla.TermManager(), bitwuzla.Options()
    options.set(bitwuzla.Option.PRODUCE_MODELS, True)
    parser = bitwuzla.Parser(manager, options)
    parser.parse(path, True)
    solver = parser.bitwuzla()
    found = str(solver.check_sat()).rsplit(".", maxsplit=1)[-1].lower()
    words = {}
    if found == "sat":
        for one in parser.get_declared_funs():
            if one.sort().is_bv():
                words[str(one.symbol())] = int(solver.get_value(one).value(10))
    return found, words


def _z3(path):
    import z3  # pylint: disable=import-outside-toplevel
    solver = z3.Solver()
    solver.from_file(path)
    found = str(solver.check())
    words = {}
    if found == "sat":
        model = solver.model()
        words = {one.name(): model[one].as_long() for one in model if one.arity() == 0}
    return found, words


def main():
    found, words = {"bitwuzla": _bitwuzla, "z3": _z3}[sys.argv[1]](sys.argv[2])
    print(json.dumps({"result": found, "words": words, "seconds": round(time.process_time(), 2)}))


def versions():
    return {name: metadata.version(name) for name in ("bitwuzla", "z3-solver")}


def run(solver, path, limit):
    """(unsat, sat, unknown or what went wrong, words of a counterexample, seconds of processor)."""
    try:
        done = subprocess.run([sys.executable, "-B", pathlib.Path(__file__), solver, path], check=False,
                              capture_output=True, text=True, timeout=limit)
    except subprocess.TimeoutExpired:
        return "unknown", {}, float(limit)
    if done.returncode:
        return "error: " + (done.stderr.strip().splitlines() or ["nothing said"])[-1], {}, 0.0
    said = json.loads(done.stdout)
    return said["result"], said["words"], said["seconds"]


if __name__ == "__main__":
    main()
