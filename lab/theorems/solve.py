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
    verdict = str(solver.check_sat()).rsplit(".", maxsplit=1)[-1].lower()
    words = {}
    if verdict == "sat":
        for symbol in parser.get_declared_funs():
            if symbol.sort().is_bv():
                words[str(symbol.symbol())] = int(solver.get_value(symbol).value(10))
    return verdict, words


def _z3(path):
    import z3  # pylint: disable=import-outside-toplevel
    solver = z3.Solver()
    solver.from_file(path)
    verdict = str(solver.check())
    words = {}
    if verdict == "sat":
        model = solver.model()
        words = {symbol.name(): model[symbol].as_long() for symbol in model if symbol.arity() == 0}
    return verdict, words


def main():
    ask = {"bitwuzla": _bitwuzla, "z3": _z3}[sys.argv[1]]
    for path in sys.argv[2:]:
        start = time.process_time()
        verdict, words = ask(path)
        print(json.dumps({"result": verdict, "words": words,
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
            out, errors = process.communicate(timeout=limit)
            fault = f"error: {(errors.strip().splitlines() or ['nothing said'])[-1]}"
        except subprocess.TimeoutExpired:
            process.kill()
            out, _ = process.communicate()
            fault = "unknown"
    replies = [json.loads(line) for line in out.splitlines() if line.endswith("}")]
    answers = [(reply["result"], reply["words"], reply["seconds"]) for reply in replies]
    return answers + [(fault, {}, float(limit))] * (len(paths) - len(answers))


if __name__ == "__main__":
    main()
