"""What `make synth` maps, how one row is run, and how long its result stays good.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import json
import os
import pathlib
import re
import time
from dataclasses import dataclass

import configurations
import mapped
import rtl
from processes import Processes

ORGANIZATION, CORE = "ffd_org_select", "hwffd_stream"
TARGETS = mapped.TARGETS
SETS = ("all", "ci")

# Mapped once each where a row keeps its units apart; the rest of the design is flattened.
UNITS = ("ffd_eval_poly", "ffd_eval_horner", "ffd_num_mul", "ffd_num_term", "ffd_num_add",
         "ffd_num_mac")
# Targets whose multipliers take in registers and adders of other units, which only a flat fixed-
# point design lets them do.
ABSORBING = ("ice40", "xilinx7")


class SynthesisError(Exception):
    """A row that could not be mapped, in one line."""


@dataclass(frozen=True)
class Subject:
    """One run: a row of the table, the module that is its top, and what it is mapped on."""

    row: configurations.Configuration
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
        return size * {"xilinx7": 2, "ice40": 2}.get(self.target, 1)


def subjects(rows):
    """The runs that are worth their time, in the table's order: of every overlapped row the
    organization on each target, on iCE40 the smallest only; on ECP5 the whole core as well where the
    row has streams.
    """
    found = []
    for row in rows:
        if row.schedule != "overlapped":
            continue
        for target in TARGETS:
            if target == "ice40" and (row.n > 1 or row.format == "fp32"):
                continue
            found.append(Subject(row, ORGANIZATION, target))
            if row.stream and target == "ecp5":
                found.append(Subject(row, CORE, target))
    return found


def of_set(found, name):
    """Those of a set; `ci` is every organization in fx18 on ECP5, and `basic` on all targets."""
    if name == "all":
        return found
    return [s for s in found if s.row.format == "fx18" and s.top == ORGANIZATION
            and (s.target == "ecp5" or s.row.tier == "sim")]


class Synthesis:
    """Runs subjects of one checkout; results lie in build/synth/, one file each."""

    def __init__(self, root, yosys="yosys"):
        self.root, self.yosys = pathlib.Path(root), yosys
        self.folder = self.root / "build" / "synth"
        self.sources = rtl.Sources(self.root)
        self.version = rtl.run([yosys, "-V"])[1].strip()
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
            "script synth/verify.ys",
        ]

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
            except (OSError, ValueError, KeyError, mapped.NetlistError) as error:
                raise SynthesisError(str(error)) from error
        finally:
            netlist.unlink(missing_ok=True)
        result = {"key": key, "seconds": round(time.monotonic() - start, 1), **counts}
        write(self._file(subject, "json"), json.dumps(result) + "\n")
        return result

    def _call(self, steps, log):
        with open(log, "w", encoding="utf-8") as out:
            return self.processes.call([self.yosys, "-Q", "-T", "-p", "; ".join(steps)], out)

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
