"""What `make synth` maps, how one row is run, and how long its result stays good.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import json
import os
import pathlib
import re
import shutil
import time
from dataclasses import dataclass

import configurations
import liberty
import mapped
import pool
import rtl
import timing
from processes import Processes

ORGANIZATION, CORE, SYSTEM = "ffd_org_select", "hwffd_stream", "hwffd_axi"
TARGETS = mapped.TARGETS
CELLS = liberty.TARGET
ICE40 = ("up5k", "hx8k")
SETS = ("all", "ci", "baseline")
# binary32 units by themselves: module -> (word, column of the table with its latency).
FLOAT_UNITS = {"ffd_fp_add": ("add", "add_latency"), "ffd_fp_mul": ("mul", "mul_latency"),
               "ffd_fp_fma": ("fma", "fma_latency")}
UNIT_TARGETS = ("ecp5", CELLS)

# Mapped once each where a row keeps its units apart; the rest of the design is flattened.
UNITS = ("ffd_eval_poly", "ffd_eval_horner", "ffd_num_mul", "ffd_num_term", "ffd_num_add",
         "ffd_num_mac", "ffd_fx_block")
# Targets whose multipliers take in registers and adders of other units, which only a flat fixed-
# point design lets them do.
ABSORBING = (*ICE40, "xilinx7")


class SynthesisError(Exception):
    """A row that could not be mapped, in one line."""


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

    @property
    def fixed(self):
        return self.row.format != "fp32"

    @property
    def flat(self):
        return self.fixed and self.target in ABSORBING

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


def subjects(rows):
    """The runs that are worth their time, in the table's order: of every overlapped row the
    organization on each target where it makes sense, and on ECP5 the whole core where the row has
    streams, outside fixed point of `basic` only, with DMA and registers where it has those; then the
    binary32 units.
    """
    found = []
    overlapped = [row for row in rows if row.schedule == "overlapped"]
    for row in overlapped:
        found += [Subject(row, ORGANIZATION, target) for target in TARGETS
                  if makes_sense(row, target)]
        if row.stream and (row.format.startswith("fx") or row.organization.mapped == "every"):
            found.append(Subject(row, CORE, "ecp5"))
        if row.top == "axi":
            found.append(Subject(row, SYSTEM, "ecp5"))
    return found + units(overlapped)


def units(rows):
    """The binary32 units with one register, and with the latencies that rows of the table have."""
    found = []
    for top, (word, column) in FLOAT_UNITS.items():
        latencies = {getattr(row, column) for row in rows if row.format == "fp32"} - {0}
        found += [Subject(Unit(word, latency), top, target)
                  for latency in sorted(latencies | {1}) if latencies for target in UNIT_TARGETS]
    return found


def of_set(found, name):
    """Those of a set; `ci` is every organization in fx18 on ECP5, and `basic` where it is mapped;
    `baseline` those and the binary32 units.
    """
    if name == "all":
        return found
    return [s for s in found if (isinstance(s.row, Unit) and name == "baseline")
            or (s.row.format == "fx18" and s.top == ORGANIZATION
                and (s.target == "ecp5" or s.row.tier == "sim"))]


def missing(wanted):
    """What the chosen subjects lack on this machine, in one line; None if nothing."""
    if not shutil.which("yosys"):
        return "yosys not found: run scripts/install"
    if not any(subject.target == CELLS for subject in wanted):
        return None
    if not shutil.which(timing.PROGRAM):
        return (f"{timing.PROGRAM} not found: install Debian's {timing.PACKAGE}, or choose another "
                "TARGET=")
    try:
        liberty.path()
    except liberty.LibertyError as error:
        return str(error)
    return None


class Synthesis:
    """Runs subjects of one checkout; results lie in build/synth/, one file each."""

    def __init__(self, root, yosys="yosys"):
        self.root, self.yosys = pathlib.Path(root), yosys
        self.folder = self.root / "build" / "synth"
        self.sources = rtl.Sources(self.root)
        self.version = rtl.run([yosys, "-V"])[1].strip()
        self.sta_version = rtl.run([timing.PROGRAM, "-version"])[1].strip() if shutil.which(
            timing.PROGRAM) else ""
        self.processes = Processes(self.root)
        self._texts = {}

    def script(self, subject):
        """The steps of yosys, with files named from the root. They end before the netlist."""
        files = [os.path.relpath(path, self.root) for path in self.sources.needed(subject.top)]
        folders = [os.path.relpath(path, self.root) for path in self.sources.includes]
        parameters = "".join(
            f" -chparam {name} {value}" for name, value in subject.row.parameters.items())
        kept = " ".join(f"*{unit}" for unit in UNITS)
        return [
            "read_verilog " + "".join(f"-I {folder} " for folder in folders) + " ".join(files),
            f"hierarchy -check -top {subject.top}{parameters}",
            *([] if subject.flat else [f"setattr -mod -set keep_hierarchy 1 {kept}"]),
            "script synth/prepare.ys",
            f"script synth/{subject.target}.ys",
            *(self._cells() if subject.target == CELLS else []),
            "script synth/verify.ys",
        ]

    @staticmethod
    def _cells():
        """Gates and flip-flops become cells of the library."""
        return [f"read_liberty -lib {liberty.PATH}", f"dfflibmap -liberty {liberty.PATH}",
                f"abc -liberty {liberty.PATH} -constr synth/osu018.constr "
                "-script synth/osu018.abc",
                "opt_clean -purge"]

    def _text(self, path):
        if path not in self._texts:
            self._texts[path] = pathlib.Path(path).read_bytes()
        return self._texts[path]

    def key(self, subject):
        """Changes with whatever the result depends on: yosys, steps, sources, headers, counting."""
        steps = self.script(subject)
        paths = [self.root / path for step in steps if step.startswith("script ")
                 for path in step.split()[1:]]
        paths += [pathlib.Path(path) for path in self.sources.needed(subject.top)]
        paths += sorted(self.sources.rtl.glob("*/*.vh"))
        paths.append(pathlib.Path(mapped.__file__))
        if subject.target == CELLS:
            paths += sorted((self.root / "synth").glob(f"{CELLS}.*"))
            paths += [liberty.PATH, *(pathlib.Path(m.__file__) for m in (liberty, timing))]
            steps.append(self.sta_version)
        digest = hashlib.sha256("\n".join([self.version, *steps]).encode())
        for path in paths:
            digest.update(hashlib.sha256(self._text(path)).digest())
        return digest.hexdigest()

    def _file(self, subject, suffix):
        return self.folder / f"{subject.name}.{suffix}"

    def log(self, subject):
        return str(self._file(subject, "log").relative_to(self.root))

    def last(self, subject):
        """The newest result, of these sources or of others; {} if there is none."""
        try:
            found = json.loads(self._file(subject, "json").read_text())
        except (OSError, ValueError):
            return {}
        return found if isinstance(found, dict) else {}

    def result(self, subject):
        """The counts, if these sources have been mapped; else None."""
        if subject.target == CELLS and not liberty.PATH.is_file():
            return None
        found = self.last(subject)
        return found if found.get("key") == self.key(subject) else None

    def run(self, subject):
        """Maps a subject, keeps its result and returns it. Raises SynthesisError."""
        self.folder.mkdir(parents=True, exist_ok=True)
        key, start = self.key(subject), time.monotonic()
        netlist = self._file(subject, "netlist")
        try:
            steps = [*self.script(subject), f"json -o {os.path.relpath(netlist, self.root)} *"]
            status = self._call(steps, self._file(subject, "log"))
            if status != 0:
                raise SynthesisError(self._complaint(subject, status))
            try:
                text = json.loads(netlist.read_text())
                counts = mapped.count(subject.target, text, subject.top)
                counts["depth"] = mapped.depth(subject.target, text, subject.top)
                counts["kinds"] = mapped.kinds(text, subject.top)
                if subject.target == CELLS:
                    counts.update(self._time(subject, text))
            except (OSError, ValueError, KeyError, mapped.NetlistError,
                    timing.TimingError) as error:
                raise SynthesisError(str(error)) from error
        finally:
            netlist.unlink(missing_ok=True)
        result = {"key": key, "seconds": round(time.monotonic() - start, 1), **counts}
        write(self._file(subject, "json"), json.dumps(result) + "\n")
        return result

    def _call(self, steps, log):
        with open(log, "w", encoding="utf-8") as out:
            return self.processes.call([self.yosys, "-Q", "-T", "-p", "; ".join(steps)], out)

    def _time(self, subject, netlist):
        """Clock and power of a netlist of standard cells. Raises TimingError."""
        text, steps, log = (self._file(subject, suffix) for suffix in ("v", "tcl", "sta"))
        try:
            text.write_text(timing.verilog(netlist, subject.top))
            steps.write_text(timing.script(text, subject.top, self.root / f"synth/{CELLS}.tcl"))
            with open(log, "w", encoding="utf-8") as out:
                self.processes.call([timing.PROGRAM, "-no_init", "-no_splash", "-exit", str(steps)],
                                    out)
            return timing.parse(log.read_text(errors="replace"))
        finally:
            for path in (text, steps):
                path.unlink(missing_ok=True)

    def _complaint(self, subject, status):
        text = self._file(subject, "log").read_text(errors="replace")
        errors = re.findall(r"^(?:[^ ]+: )?ERROR: (.*)$", text, re.MULTILINE)
        warnings = re.findall(r"^Warning: (.*)$", text, re.MULTILINE)
        if not errors:
            return f"yosys ended with status {status}"
        if "problems in 'check" in errors[0]:  # it has warned of each; the worst first
            for problem in ("multiple conflicting drivers", "has no driver", "logic loop"):
                for warning in warnings:
                    if problem in warning:
                        return warning.rstrip(":.")
        return errors[0]


def run_all(work, wanted, jobs):
    """Maps what has no result yet, the longest first: [(subject, complaint)]."""
    waiting = [subject for subject in wanted if work.result(subject) is None]
    waiting.sort(key=lambda s: work.last(s).get("seconds", s.effort), reverse=True)
    print(f"synth: {len(wanted)} rows, {len(wanted) - len(waiting)} of them unchanged", flush=True)
    return pool.complaints(work.run, waiting, jobs, work.processes, (SynthesisError, OSError))


def write(path, text):
    """Whole or not at all."""
    path = pathlib.Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    draft = path.with_name(f"{path.name}.{os.getpid()}.draft")
    try:
        draft.write_text(text, encoding="utf-8")
        os.replace(draft, path)
    finally:
        draft.unlink(missing_ok=True)
