"""The engines: how each takes the recorded commands of a row, and what comes of it.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import shutil
import time
from dataclasses import dataclass

from lab.engines import answers, axi, icarus, unknown

TOP, BENCH = "hwffd_stream", "ffd_bench_stream"
AXI_TOP, AXI_BENCH = "hwffd_axi", "ffd_bench_axi"
# Programs with the core inside, of lab/engines/CMakeLists.txt; Icarus reads the sources itself.
PROGRAMS = ("verilator", "cxxrtl", "ecp5")
# The word behind those of cores with a fault, and behind folders.
PLANTED = "-planted"


@dataclass(frozen=True)
class Stream:
    """Commands for a row, in a folder with the model's answers."""

    row: object
    folder: pathlib.Path
    beats: int
    wanted: answers.Answers


def prepare(programs, row, folder, beats=None):
    """The Stream of a row: all of the recording, or so many beats of it at least."""
    folder.mkdir(parents=True, exist_ok=True)
    icarus.command([programs / "hwffd-engines-words", "--row", row.name, "--folder", folder,
                    *(["--beats", beats] if beats else [])], folder, "words.log")
    return Stream(row, folder, len(answers.beats(folder / "beats.hex")), answers.read(folder / "model"))


def simulate(programs, engine, stream, suffix=""):
    """(results that differ from the model's, seconds) of a program with a core inside; the suffix names
    one with a fault."""
    folder = stream.folder / (engine + suffix)
    folder.mkdir(exist_ok=True)
    begun = time.monotonic()
    icarus.command([programs / f"hwffd-engine-{engine}-{stream.row.name}{suffix}", "--row",
                    stream.row.name, "--folder", stream.folder, "--output", folder], folder, "run.log")
    return answers.mismatches(answers.read(folder), stream.wanted), time.monotonic() - begun


def _subject(stream, faults, suffix, gates=False):
    """A folder with the beats, and the core between its streams."""
    folder = stream.folder / (("gates" if gates else "icarus") + suffix)
    folder.mkdir(exist_ok=True)
    shutil.copyfile(stream.folder / "beats.hex", folder / "beats.hex")
    return unknown.Subject(TOP, BENCH, stream.row, {
        "BEATS": stream.beats, "RESULTS": len(stream.wanted.results)}, folder, faults)


def simulate_with_x(stream, faults=(), suffix=""):
    """(results that differ from the model's, Unknown) of the sources in Icarus."""
    subject = _subject(stream, faults, suffix)
    unknowns = unknown.in_sources(subject)
    return answers.mismatches(answers.read(subject.folder), stream.wanted), unknowns


def simulate_gates(stream, faults=(), suffix=""):
    """(results that differ from the model's, Unknown) of gates in Icarus."""
    subject = _subject(stream, faults, suffix, gates=True)
    unknowns = unknown.in_gates(subject)
    return answers.mismatches(answers.read(subject.folder), stream.wanted), unknowns


def simulate_in_memory(stream, faults=(), suffix=""):
    """(results that differ from the model's, Unknown) of the core behind its buses, in Icarus."""
    folder = stream.folder / f"axi{suffix}"
    folder.mkdir(exist_ok=True)
    wanted = stream.wanted.results
    job = axi.job(answers.beats(stream.folder / "beats.hex"), len(wanted))
    for name, lines in (("steps", job.steps), ("memory", job.memory)):
        (folder / f"{name}.hex").write_text("\n".join([*lines, ""]), encoding="ascii")
    unknowns = unknown.in_sources(unknown.Subject(AXI_TOP, AXI_BENCH, stream.row, {
        "STEPS": len(job.steps), "WORDS": job.words, "RESULTS": len(wanted), "FIRST": job.first},
        folder, faults))
    got = answers.beats(folder / "results.txt")
    return answers.differing(got, ["0" + beat[1:] for beat in wanted]), unknowns
