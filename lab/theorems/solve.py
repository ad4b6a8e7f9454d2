"""Runs a solver on scripts, in a process of its own: `python3 -m lab.theorems.solve SOLVER SCRIPT...`.

Prints a line for each: unsat, sat with a word for each variable, or unknown.

SPDX-License-Identifier: Apache-2.0
"""

import json
import subprocess
import sys
import time
from importlib import metadata

from tools import project_root


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
    ask = {"bitwuzla": _bitwuzla, "z3": _z3}[sys.argv[1]]
    for path in sys.argv[2:]:
        start = time.process_time()
        found, words = ask(path)
        print(json.dumps({"result": found, "words": words,
                          "seconds": round(time.process_time() - start, 2)}), flush=True)


def versions():
    return {name: metadata.version(name) for name in ("bitwuzla", "z3-solver")}


def run(solver, paths, limit):
    """For each script (unsat, sat, unknown or what went wrong, words of a counterexample, seconds of
    processor); the limit, in seconds of the clock, is of them together."""
    command = [sys.executable, "-B", "-m", "lab.theorems.solve", solver, *paths]
    with subprocess.Popen(command, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                          env=project_root.environment()) as process:
        try:
            out, said = process.communicate(timeout=limit)
            fault = f"error: {(said.strip().splitlines() or ['nothing said'])[-1]}"
        except subprocess.TimeoutExpired:
            process.kill()
            out, _ = process.communicate()
            fault = "unknown"
    found = [json.loads(line) for line in out.splitlines() if line.endswith("}")]
    answers = [(one["result"], one["words"], one["seconds"]) for one in found]
    return answers + [(fault, {}, float(limit))] * (len(paths) - len(answers))


if __name__ == "__main__":
    main()
