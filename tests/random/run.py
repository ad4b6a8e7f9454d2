"""A configuration of the legal space, built and run on a stream of any packets; and one that is illegal,
refused by name.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import subprocess
from dataclasses import dataclass

from tools.rtl import rtl_sources
from tools.tables import features
from tools.tables.configurations import SCHEDULES, evaluator_of

HERE = pathlib.Path(__file__).resolve().parent
BENCH = "ffd_bench_random"
TOP = "hwffd_stream_bus"
BENCHES = (*(HERE / f"{name}.v" for name in (BENCH, "ffd_bench_units_to", "ffd_bench_units_from")),
           HERE.parents[1] / "tb" / "rtl" / "ffd_bench_known.v")
LIMIT = 600  # seconds of a process: one that hangs has failed
_TOLD = re.compile(r"^(?:unknown|broken) .*$", re.MULTILINE)
_GUARD = re.compile(r"\bERROR_(\w+)")


class Failure(Exception):
    """What is wrong with a configuration, in one line."""


def text(configuration):
    return " ".join(f"{name}={value}" for name, value in configuration.items())


def process(command, folder, what):
    """What a program prints; Failure where it fails."""
    try:
        status, output = rtl_sources.run(["timeout", str(LIMIT), *map(str, command)], folder)
    except subprocess.SubprocessError as error:
        raise Failure(f"{what}: {error}") from error
    if status:
        lines = output.strip().splitlines() or [f"exit status {status}"]
        raise Failure(f"{what}: {lines[0]}")
    return output


@dataclass(frozen=True)
class Stream:
    """How a stream is made: the program for its words, its seed and about how many parts it has."""

    program: pathlib.Path
    seed: int
    parts: int


class Legal:
    """A configuration that must work."""

    def __init__(self, space, sources, configuration, folder, modelled):
        """modelled(organization) says whether there is a model of it with the rest of the configuration."""
        self.space, self.sources, self.configuration, self.folder = space, sources, configuration, folder
        self.organization, self.modelled = space.organizations[configuration["ORG"]], modelled

    def same_bits(self):
        """(organization, N) with the same bits, or None: of the form, and in binary32 with the same order."""
        form, n = self.organization.form, self.configuration["N"]
        words = self.space.formats[self.configuration["FORMAT"]].words
        others = [other for other in self.space.organizations.values()
                  if other.form == form and other is not self.organization and self.modelled(other)]
        if form == "product" and words == "float":
            others = [other for other in others if (other.n or n) == n]
        others = [(other.name, other.n or n) for other in others]
        return others[self.configuration["AXIS"] % len(others)] if others else None

    def words(self, stream):
        p = self.configuration
        other = self.same_bits()
        interval = 64 // p["N"] if self.organization.in_turn else self.organization.fold
        process([stream.program, "--org", self.organization.name, "--n", p["N"],
                 "--format", self.space.formats[p["FORMAT"]].name, "--schedule", SCHEDULES[p["SCHEDULE"]],
                 "--evaluator", evaluator_of(p["EVALUATOR"]), "--fma", p["FMA_LATENCY"],
                 "--features", features.number_of(p), "--axis", p["AXIS"], "--pages", p["PAGES"], "--spans", p["SPANS"],
                 "--interval", interval * (8 if p["SCHEDULE"] else 1), "--parts", stream.parts,
                 "--seed", stream.seed, "--folder", ".",
                 *(("--other", other[0], "--other-n", other[1]) if other else ())], self.folder, "words")
        if other and self._lines("other.txt") != self._lines("model.txt"):
            raise Failure(f"the model of {other[0]} has other bits")

    def lint(self):
        """Without a warning."""
        process([word for word in rtl_sources.verilator(
            self.sources, TOP, self.sources.needed(TOP), [f"{n}={v}" for n, v in self.configuration.items()])],
            self.folder, "verilator")

    def simulate(self, seed):
        """In Icarus. What the bench tells, or Failure."""
        beats = len(self._lines("beats.hex"))
        process(["iverilog", "-g2005", "-o", "bench.vvp", "-s", BENCH, f"-D{rtl_sources.SIMULATION}", f"-D{rtl_sources.ASSERTIONS}",
                 *(f"-P{BENCH}.{name}={value}" for name, value in
                   {**self.configuration, "BEATS": beats, "SEED": seed}.items()),
                 *(f"-I{folder}" for folder in self.sources.includes), *self.sources.needed(TOP), *BENCHES],
                self.folder, "iverilog")
        return process(["vvp", "-n", "bench.vvp"], self.folder, "vvp")

    def _lines(self, name):
        return (self.folder / name).read_text(encoding="ascii").splitlines()

    def compare(self, output):
        """Counts of results and clocks; Failure at the first difference."""
        complaints = _TOLD.findall(output)
        model, got = self._lines("model.txt"), self._lines("results.txt")
        part = 0
        for number, (wanted, line) in enumerate(zip(model, got)):
            wrong = _difference(wanted, line)
            if wrong:
                raise Failure(f"line {number + 1} of results.txt, part {part}: {wrong}"
                              + "".join(f"; {complaint}" for complaint in complaints[:3]))
            part += line.startswith("=")
        if complaints:
            raise Failure("; ".join(complaints[:3]))
        if len(model) != len(got):
            raise Failure(f"{len(got)} lines of results, {len(model)} wanted")
        clocks = re.search(r"^clocks (\d+)", output, re.MULTILINE)
        return len(got) - part, int(clocks[1])


def _difference(wanted, line):
    """What differs between a line of the model and one of the bench, or nothing."""
    if line.startswith("=") != wanted.startswith(("any", "memory")):
        return f"'{line}', the model has '{wanted}'"
    if not line.startswith("="):
        return "" if wanted == line else f"'{line}', the model has '{wanted}'"
    purpose, *counts = wanted.split()
    _, *had = line.split()
    of_core, waits = had[:len(counts)], had[len(counts):]
    if counts != of_core:
        return f"events and vertices {' '.join(of_core)}, the model has {' '.join(counts)}"
    if purpose == "memory" and waits[1] != "0":
        return f"{waits[1]} clocks of waiting for the evaluator where it has room"
    return ""


def refused(sources, configuration, guard, others, folder):
    """Failure unless each tool refuses it at a guard of that name. yosys tells of the first that it meets, and
    that may be one of these others."""
    assignments = [f"{name}={value}" for name, value in configuration.items()]
    files = sources.needed(TOP)
    top = f"; hierarchy -check -top {TOP}"
    top += "".join(f" -chparam {name} {value}" for name, value in configuration.items())
    if min(configuration.values()) < 0:  # which yosys does not take for a parameter of its top
        parameters = ", ".join(f".{name}({value})" for name, value in configuration.items())
        (folder / "top.v").write_text(f"module top;\n  {TOP} #({parameters}) u_core ();\nendmodule\n")
        top = "top.v; hierarchy -check -top top"
    headers = " ".join(f"-I {name}" for name in sources.includes)
    commands = {
        "icarus": [word for word in rtl_sources.icarus(sources, TOP, files, assignments) if word != "-Wall"],
        "verilator": [*(word for word in rtl_sources.verilator(sources, TOP, files, assignments) if word != "-Wall"),
                      "-Wno-fatal", "-Wno-lint"],
        "yosys": ["yosys", "-Q", "-T", "-q", "-p", f"read_verilog {headers} {' '.join(files)} {top}"],
    }
    for tool, command in commands.items():
        status, output = rtl_sources.run(["timeout", str(LIMIT), *command], folder)
        met = sorted(set(_GUARD.findall(output)))
        wanted = [guard, *others] if tool == "yosys" else [guard]
        if status == 0 or not any(re.fullmatch(pattern, guard) for pattern in wanted for guard in met):
            raise Failure(f"{tool} does not refuse it by {guard}: "
                          + (f"exit status {status}, guards {' '.join(met) or 'none'}"))
