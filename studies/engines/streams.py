"""The engines: how each takes the recorded commands of a row, and what it leaves.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import time
from dataclasses import dataclass

import answers
import icarus
import planted
import registers
import rtl

HERE = pathlib.Path(__file__).resolve().parent
TOP, BENCH, WATCHED = "hwffd_stream", "ffd_bench_stream", "ffd_bench_registers"
# Programs with the core inside, of studies/engines/CMakeLists.txt; Icarus reads the sources.
PROGRAMS = ("verilator", "cxxrtl", "ecp5")
ENGINES = (PROGRAMS[0], "icarus", *PROGRAMS[1:])


@dataclass(frozen=True)
class Stream:
    """Commands for a row, in a folder with the model's answers."""

    row: object
    folder: pathlib.Path
    beats: int
    wanted: answers.Answers


@dataclass(frozen=True)
class Unknown:
    """What Icarus saw of X: in how many clocks, of how many bits that must be known, which names."""

    clocks: int
    checked: int
    names: tuple


def prepare(programs, row, folder, beats=None):
    """The Stream of a row: all of the recording, or so many beats of it at least."""
    folder.mkdir(parents=True, exist_ok=True)
    icarus.command([programs / "hwffd-engines-words", "--row", row.name, "--folder", folder,
                    *(["--beats", beats] if beats else [])], folder, "words.log")
    return Stream(row, folder, len(answers.beats(folder / "beats.hex")), answers.read(folder / "model"))


def simulate(programs, engine, stream, suffix=""):
    """(Answers, seconds) of a program with a core inside; the suffix names one with a fault."""
    folder = stream.folder / (engine + suffix)
    folder.mkdir(exist_ok=True)
    begun = time.monotonic()
    icarus.command([programs / f"hwffd-engine-{engine}-{stream.row.name}{suffix}", "--row",
                    stream.row.name, "--folder", stream.folder, "--output", folder], folder, "run.log")
    return answers.read(folder), time.monotonic() - begun


def _sources(sources, faults, folder):
    """The files of the core, those with faults in copies."""
    own = {path.name: path for path in (planted.copy(fault, folder) for fault in faults)}
    return [own.get(pathlib.Path(path).name, path) for path in sources.needed(TOP)]


OUTPUTS = 1 + 1 + 15 + 1 + 3 + 1 + 130 + 64  # bits that ffd_bench_stream watches itself


def simulate_with_x(stream, faults=(), suffix=""):
    """(Answers, seconds, Unknown) of Icarus."""
    folder, sources = stream.folder / f"icarus{suffix}", rtl.Sources()
    folder.mkdir(exist_ok=True)
    (folder / "beats.hex").write_bytes((stream.folder / "beats.hex").read_bytes())
    found = registers.find(sources, TOP, stream.row.parameters, folder)
    watch = folder / f"{WATCHED}.v"
    watch.write_text(registers.watch(found, f"{BENCH}.u_core", f"{BENCH}.aclk", f"{BENCH}.watched"),
                     encoding="utf-8")
    parameters = {**stream.row.parameters, "BEATS": stream.beats, "RESULTS": len(stream.wanted.results)}
    begun = time.monotonic()
    clocks, names = icarus.run(icarus.Bench(
        (BENCH, WATCHED), parameters,
        (*_sources(sources, faults, folder), HERE / f"{BENCH}.v", HERE / "ffd_bench_known.v", watch),
        tuple(sources.includes), (rtl.SIMULATION,)), folder)
    checked = OUTPUTS + sum(map(len, found.values()))
    return answers.read(folder), time.monotonic() - begun, Unknown(clocks, checked, tuple(names))
