"""A bench in Icarus Verilog, with real X, and what it tells.

The longest take a quarter of an hour. So one that has run to its end leaves a key of all that it read
beside its files, and is not run again while that is the same.

SPDX-License-Identifier: Apache-2.0
"""

import json
import pathlib
import re
import time
from dataclasses import dataclass

from tools.rtl import digest, rtl_sources

_END = re.compile(r"^clocks (\d+)\b", re.MULTILINE)
_FOUND = re.compile(r"^(?:unknown|broken) .*$", re.MULTILINE)


class SimulationError(Exception):
    """A simulation that did not end, in one line."""


@dataclass(frozen=True)
class Bench:
    """The tops, the first of which is the bench; its parameters; files, folders of headers, macros."""

    tops: tuple
    parameters: dict
    files: tuple
    includes: tuple
    macros: tuple = ()


def command(line, folder, log):
    """What a program says. Raises SimulationError where it fails."""
    status, output = rtl_sources.run(list(map(str, line)), folder)
    (folder / log).write_text(output, encoding="utf-8")
    if status:
        raise SimulationError(f"{line[0]} ended with {status}: see {folder / log}")
    return output


def result_of(output):
    """(clocks, what was unknown or broken). Raises SimulationError unless the bench came to its end."""
    end = _END.search(output)
    if not end:
        raise SimulationError("the bench did not end")
    return int(end[1]), _FOUND.findall(output)


def _key(bench, folder):
    """Of the simulator, sources, headers, parameters, and what the bench reads in its folder."""
    read = [*bench.files, *(path for include in bench.includes
                            for path in sorted(pathlib.Path(include).glob("*.vh"))),
            *sorted(pathlib.Path(folder).glob("*.hex"))]
    simulator = rtl_sources.run(["iverilog", "-V"], folder)[1].partition("\n")[0]
    return digest.of(simulator, *bench.tops, *map(str, sorted(bench.parameters.items())), *bench.macros,
                     *(pathlib.Path(path).read_text(encoding="utf-8") for path in read))


def run(bench, folder):
    """result_of() of the bench, whose files lie in the folder, and the seconds that it took."""
    ended, key = folder / "ended.json", _key(bench, folder)
    cached = json.loads(ended.read_text(encoding="utf-8")) if ended.is_file() else {}
    if cached.get("key") != key:
        ended.unlink(missing_ok=True)
        begun = time.monotonic()
        _simulate(bench, folder)
        cached = {"key": key, "seconds": time.monotonic() - begun}
        ended.write_text(json.dumps(cached), encoding="utf-8")
    return *result_of((folder / "bench.log").read_text(encoding="utf-8")), cached["seconds"]


def _simulate(bench, folder):
    command(["iverilog", "-g2005", "-o", "bench.vvp",
             *(word for top in bench.tops for word in ("-s", top)),
             *(f"-P{bench.tops[0]}.{name}={value}" for name, value in bench.parameters.items()),
             *(f"-D{macro}" for macro in bench.macros),
             *(f"-I{include}" for include in bench.includes), *bench.files], folder, "icarus.log")
    result_of(command(["vvp", "-n", "bench.vvp"], folder, "bench.log"))
