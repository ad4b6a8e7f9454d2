"""What `make synth` maps: the rows, the steps of yosys for each, and what its result depends on.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import shutil
from dataclasses import dataclass

from tools import csv_table
from tools.rtl import digest, elaboration, rtl_sources
from tools.synth import chips, engine, liberty, mapped_netlist, timing, variants
from tools.tables import configurations, features

ORGANIZATION, CORE, SYSTEM = "ffd_org_select", "hwffd_stream", "hwffd_axi"
BUS, SCATTER, ADJOINT = "hwffd_stream_bus", "hwffd_scatter", "hwffd_adjoint"
TOPS = (CORE, BUS, SYSTEM, SCATTER, ADJOINT)  # of variants
# What scatter has of the parameters of a row.
OF_SCATTER = ("FORMAT", "EVALUATOR", "MUL_LATENCY", "ADD_LATENCY", "AXIS", "PAGES", "WAITING", "ROWS")
TARGETS = (*mapped_netlist.TARGETS, *chips.TARGETS)
CELLS = liberty.TARGET
ICE40 = ("up5k", "hx8k")
SETS = ("all", "ci", "baseline")
# binary32 units by themselves: module -> (word, column of the table with its latency).
FLOAT_UNITS = {"ffd_fp_add": ("add", "add_latency"), "ffd_fp_mul": ("mul", "mul_latency"),
               "ffd_fp_fma": ("fma", "fma_latency")}
UNIT_TARGETS = ("ecp5", CELLS)

# Mapped once each where a row keeps its units apart; the rest of the design is flattened.
UNITS = ("ffd_eval_poly", "ffd_num_mul", "ffd_num_term", "ffd_num_add",
         "ffd_num_mac")
# Targets whose multipliers take in registers and adders of other units, which only a flat fixed-
# point design lets them do, and those where a chain of registers lies around what is routed.
FLAT = (*ICE40, "xilinx7", *chips.TARGETS)
# On which targets whole cores are mapped only to be routed: of those of chips.py nothing else is.
CORE_TARGETS = ("up5k", *chips.TARGETS)
# What is routed.
CLOCKS = "synth/clocks.csv"
CLOCK_COLUMNS = ("name", "top", "target", "placer", "aim_share", "aim_mhz")
# Where a module of synth/TARGET names cells of the target.
BLACK_BOXES = {"ecp5": "synth/ecp5/cells.v"}
# Of standard cells: gates and flip-flops become cells of the library.
CELL_STEPS = (f"read_liberty -lib {liberty.PATH}", f"dfflibmap -liberty {liberty.PATH}",
              f"abc -liberty {liberty.PATH} -constr synth/osu018.constr -script synth/osu018.abc",
              "opt_clean -purge")


@dataclass(frozen=True)
class Unit:
    """A binary32 unit by itself; it stands where a row of the table stands."""

    word: str
    latency: int

    org, n, format, schedule, stream, tier = "unit", 1, "fp32", "overlapped", 0, "all"

    @property
    def name(self):
        return f"{self.word}-fp32-latency{self.latency}"

    @property
    def parameters(self):
        return {"LATENCY": self.latency}


@dataclass(frozen=True)
class Subject:
    """One run: a row of the table or a unit, the module that is its top, and the target."""

    row: object
    top: str
    target: str

    @property
    def name(self):
        return f"{self.row.name}.{self.top}.{self.target}"

    def __str__(self):
        return f"{self.row.name}, {self.top}, {self.target}"

    def __hash__(self):
        return hash(self.name)

    @property
    def variant(self):
        """The word of a variant, and what that means; None of a row as it stands."""
        is_one = isinstance(self.row, variants.Variant)
        return (self.row.variant, self.row.meaning) if is_one else (None, None)

    @property
    def parameters(self):
        known = features.of_top(self.top, self.row.parameters)
        return {name: known[name] for name in OF_SCATTER if name in known} if self.top == SCATTER else known

    @property
    def clocks(self):
        """Clocks from a vertex, or of the transpose from a gradient, to the next: in any order, and along rows of a
        grid that are long enough."""
        if self.top == SCATTER:
            return (12, 1) if self.parameters.get("ROWS") else (3, 3)
        organization, own = self.row.organization, self.parameters
        lanes = organization.lanes if own.get("GRIDS") and own.get("HALVES") else 1
        return self.row.interval, 1 / lanes if organization.walks else self.row.interval

    @property
    def fixed(self):
        return self.row.format != "fp32"

    @property
    def flat(self):
        return self.fixed and self.target in FLAT

    @property
    def effort(self):
        """A guess of its time, to begin with the longest."""
        wide = self.row.format in ("fx32", "bfp32")
        size = {"fp32": 40}.get(self.row.format, 10 if wide else 4)
        size += self.row.n * (4 if self.flat else 0.1) * (3 if wide else 1)
        return size * {"ecp5": 1, "generic": 1}.get(self.target, 2)


def makes_sense(row, target):
    """Whether an organization is mapped on a target: on ECP5 every one; on iCE40 those of one unit
    in fixed point, on HX8K, which has no multipliers, in 16 bits only; elsewhere as the table of
    organizations says, where also stands of how many units at all.
    """
    organization = row.organization
    if target == "ecp5":
        return True
    if row.n not in organization.mapped_n:
        return False
    if target in ICE40:
        wide = target == "up5k" and row.n == 1 and row.format in ("fx18", "fx32")
        return wide or row.format == "fx16"
    return organization.mapped in ("every", row.format)


def subjects(rows, changed=()):
    """The runs that are worth their time, of overlapped rows: on ECP5 those with streams as whole
    cores, outside fixed point of `basic` only, and those with DMA and registers, or of `basic` with
    the pipelined evaluator, with these; the variants, pairs of one and its top; the organization of
    every row on each target where it makes sense; and the binary32 units.
    """
    overlapped = [row for row in rows if row.schedule == "overlapped"]
    collected = [Subject(row, SYSTEM, "ecp5") for row in overlapped
                 if row.top == "axi" or (row.stream and row.organization.mapped == "every"
                                         and row.evaluator == "pipelined")]
    collected += [Subject(row, CORE, "ecp5") for row in overlapped
                  if row.stream and (row.format.startswith("fx") or row.organization.mapped == "every")]
    collected += [Subject(variant, top, "ecp5") for variant, top in changed]
    collected += [Subject(row, ORGANIZATION, target) for row in overlapped for target in mapped_netlist.TARGETS
                  if makes_sense(row, target)]
    return collected + units(overlapped)


def of_checkout(root):
    """All that the tables of a checkout give. Raises TableError."""
    rows = configurations.read(root / "rtl" / "configurations.csv")
    changed = variants.read(root / "synth" / "variants.csv", rows, TOPS)
    return subjects(rows, changed) + routed(root / CLOCKS, rows, changed)


def routed(path, rows, changed):
    """Cores of the table of clocks on targets other than ECP5. Raises TableError."""
    known = {row.name: row for row in [*(row for row in rows if row.stream),
                                       *(variant for variant, top in changed if top == CORE)]}
    return [Subject(known[line["name"]], CORE, line["target"])
            for _, line in csv_table.read(path, CLOCK_COLUMNS)
            if line["target"] in CORE_TARGETS and line["name"] in known and line["top"] == CORE]


def units(rows):
    """The binary32 units with one register, and with the latencies that rows of the table have."""
    collected = []
    for top, (word, column) in FLOAT_UNITS.items():
        latencies = {getattr(row, column) for row in rows if row.format == "fp32"} - {0}
        collected += [Subject(Unit(word, latency), top, target)
                      for latency in sorted(latencies | {1}) if latencies for target in UNIT_TARGETS]
    return collected


def of_set(everything, name):
    """Those of a set; `ci` is every organization in fx18 on ECP5, and `basic` where it is mapped;
    `baseline` those and the binary32 units.
    """
    if name == "all":
        return everything
    return [s for s in everything if (isinstance(s.row, Unit) and name == "baseline")
            or (s.row.format == "fx18" and s.top == ORGANIZATION
                and (s.target == "ecp5" or s.row.tier == "sim"))]


def require(wanted):
    """Raises EngineError where this machine lacks what the chosen subjects need."""
    if not shutil.which("yosys"):
        raise engine.EngineError("yosys not found: run tools/install engine")
    if not any(subject.target == CELLS for subject in wanted):
        return
    if not shutil.which(timing.PROGRAM):
        raise engine.EngineError(f"{timing.PROGRAM} not found: install Debian's {timing.PACKAGE}, or "
                                 "choose another TARGET=")
    liberty.path()


class Synthesis:
    """The subjects of one checkout. Results lie in build/synth/; the name of each has its key, so
    that one that is there is good."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.folder = self.root / "build" / "synth"
        self.sources = rtl_sources.Sources(self.root)
        self.version = rtl_sources.run(["yosys", "-V"])[1].strip()
        self.sta_version = rtl_sources.run([timing.PROGRAM, "-version"])[1].strip() if shutil.which(
            timing.PROGRAM) else ""
        self._keys = {}
        self._elaborations = elaboration.Elaborations(self.root, self.version)

    def files(self, top, target):
        """The files that a module needs: a target has modules of its own, synth/TARGET/*.v, that take
        the place of those of the same name."""
        own = {path.name: path for path in (self.root / "synth" / target).glob("*.v")}
        return [own.get(pathlib.Path(path).name, path) for path in self.sources.needed(top)]

    def read(self, top, target):
        """The step that reads a module and all that it needs, cells of the target that have no logic
        among it."""
        files, folders = ([os.path.relpath(path, self.root) for path in paths]
                          for paths in (self.files(top, target), self.sources.includes))
        cells = f"read_verilog -lib {BLACK_BOXES[target]}; " if target in BLACK_BOXES else ""
        return (f"{cells}read_verilog " + "".join(f"-I {folder} " for folder in folders)
                + " ".join(files))

    @staticmethod
    def _steps(subject):
        """What follows, up to the netlist."""
        parameters = "".join(
            f" -chparam {name} {value}" for name, value in subject.parameters.items())
        patterns = " ".join(f"*{unit}" for unit in UNITS)
        return [
            f"hierarchy -check -top {subject.top}{parameters}",
            *([] if subject.flat else [f"setattr -mod -set keep_hierarchy 1 {patterns}"]),
            "script synth/prepare.ys",
            f"script synth/{subject.target}.ys",
            *(CELL_STEPS if subject.target == CELLS else []),
            "script synth/verify.ys",
        ]

    def script(self, subject):
        """The steps of yosys, with files named from the root. They end before the netlist."""
        return [self.read(subject.top, subject.target), *self._steps(subject)]

    def _elaborated(self, top, target, steps):
        cells = [self.root / BLACK_BOXES[target]] if target in BLACK_BOXES else []
        return elaboration.Design(self.read(top, target), steps[0], digest.of(
            digest.tokens(tuple(self.files(top, target)), tuple(self.sources.includes), "YOSYS",
                          "SYNTHESIS"), digest.lines(*cells)))

    def design(self, top, target, steps):
        """The key of a netlist: of yosys, of the design that is elaborated below its top, and of the
        steps that follow with the scripts that they name."""
        scripts = [self.root / step.split()[1] for step in steps if step.startswith("script ")]
        if target in chips.TARGETS:
            scripts += chips.files(self.root, target)
        return digest.of(self.version, *steps, digest.lines(*scripts),
                         self._elaborations.key(self._elaborated(top, target, steps)))

    def prepare(self, chosen, jobs):
        """What the keys of subjects need, `jobs` at a time."""
        self._elaborations.prepare(
            [self._elaborated(s.top, s.target, self._steps(s)) for s in chosen], jobs)

    def netlist_key(self, subject):
        return self.design(subject.top, subject.target, self._steps(subject))

    def key(self, subject):
        """Of a result: of its netlist and of what counts it."""
        if subject not in self._keys:
            dependencies = [self.netlist_key(subject), digest.statements(mapped_netlist)]
            if subject.target in chips.TARGETS:
                dependencies.append(digest.statements(chips))
            if subject.target == CELLS:
                texts = [path for path in (liberty.PATH, *sorted((self.root / "synth").glob(
                    f"{CELLS}.[!y]*"))) if path.is_file()]
                dependencies += [self.sta_version, digest.lines(*texts),
                                 digest.statements(liberty, timing)]
            self._keys[subject] = digest.of(*dependencies)
        return self._keys[subject]

    def file(self, subject):
        return self.folder / f"{subject.name}.{self.key(subject)}.json"

    def result(self, subject):
        """The counts, if these sources have been mapped; else None."""
        if not any(self.folder.glob(f"{subject.name}.*.json")):  # its key takes an elaboration
            return None
        try:
            return json.loads(self.file(subject).read_text())
        except FileNotFoundError:
            return None

    def effort(self, subject):
        """The seconds that it took with other sources, or a guess."""
        times = [json.loads(path.read_text())["seconds"]
                 for path in self.folder.glob(f"{subject.name}.*.json")]
        return times[-1] if times else subject.effort


def run(work, wanted, jobs):
    """Maps what has no result yet: [(subject, complaint)]."""
    work.prepare(wanted, jobs)
    files = {subject: [] if work.result(subject) else [work.file(subject)] for subject in wanted}
    return list(engine.run(work.root, "synth", files, jobs).items())


