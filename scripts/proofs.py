"""What `make formal` proves, how one property is run, and how long its verdict stays good.

A property is one labelled assertion of a harness in tests/formal/ (INSTANCE.LABEL below its top).
yosys makes an AIGER circuit of harness and RTL, all other assertions taken out, and ABC proves it
for every length of run or finds a run that breaks it: by pdr, which finds its own invariant, or,
where that is arithmetic on wide words, by induction over an assertion that is written as one. Other
properties of the same harness, proved by themselves, may then be used as lemmas. A planted bug must
be found by the same method; lemmas are not used there, since they need not hold.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import hashlib
import json
import os
import pathlib
import re
import shutil
import time
from dataclasses import dataclass

import rtl
from processes import Processes
from synthesis import write

COLUMNS = ("module", "name", "harness", "parameters", "method", "lemmas", "file", "original",
           "mutant", "statement")
PDR, INDUCTION = "pdr", "induction"
BASE, STEPS = 6, 2    # clocks searched from reset; clocks of the step, the last of which is proved
SEARCH = 12           # clocks from reset in which induction must find a planted bug
PROVED, REFUTED, UNDECIDED = "proved", "refuted", "undecided"


class ProofError(Exception):
    """A table or a property that makes no sense, in one line."""


@dataclass(frozen=True)
class Property:
    """A row of the table."""

    module: str
    name: str
    harness: str
    parameters: str  # NAME=VALUE, blanks between
    method: str  # pdr or induction
    lemmas: str  # names of properties that may be assumed, blanks between
    file: str  # the module that the planted bug is in
    original: str
    mutant: str
    statement: str

    @property
    def full_name(self):
        return f"{self.module}.{self.name}"

    def __str__(self):
        return f"{self.module}, {self.name}"


def read(path):
    """The properties of a table. Raises ProofError."""
    path, found = pathlib.Path(path), []
    try:
        with open(path, newline="", encoding="utf-8") as text:
            rows = list(csv.reader(text))
    except OSError as error:
        raise ProofError(f"{path.name}: {error.strerror}") from error
    if not rows or tuple(rows[0]) != COLUMNS:
        raise ProofError(f"{path.name}: the first line must be {','.join(COLUMNS)}")
    for number, row in enumerate(rows[1:], 2):
        where = f"{path.name}, row {number}"
        if len(row) != len(COLUMNS):
            raise ProofError(f"{where}: {len(row)} columns, not {len(COLUMNS)}")
        one = Property(*row)
        for column in ("module", "name", "harness", "file"):
            if not re.fullmatch(r"[a-z]\w*(\.\w+)*", getattr(one, column)):
                raise ProofError(f"{where}: {column} '{getattr(one, column)}' is not a name")
        if not all(re.fullmatch(r"[A-Z]\w*=\d+", word) for word in one.parameters.split()):
            raise ProofError(f"{where}: parameters '{one.parameters}' are not NAME=NUMBER")
        if one.method not in (PDR, INDUCTION):
            raise ProofError(f"{where}: method '{one.method}' is neither {PDR} nor {INDUCTION}")
        if not one.original or one.original == one.mutant:
            raise ProofError(f"{where}: the planted bug changes nothing")
        if not one.statement:
            raise ProofError(f"{where}: no statement")
        if one.full_name in [other.full_name for other in found]:
            raise ProofError(f"{where}: {one.full_name} is there twice")
        found.append(one)
    for one in found:
        for lemma in one.lemmas.split():
            if not any(other.name == lemma and other.module == one.module and not other.lemmas
                       and other.harness == one.harness and other.parameters == one.parameters
                       for other in found):
                raise ProofError(f"{path.name}: {one.full_name}: lemma '{lemma}' is no property of"
                                 " this harness with these parameters and without lemmas")
    return found


class Proofs:
    """Runs properties of one checkout; verdicts lie in build/formal/, one file each."""

    def __init__(self, root, limit=300, yosys="yosys", abc="yosys-abc"):
        self.root, self.limit = pathlib.Path(root), limit
        self.yosys, self.abc = yosys, abc
        self.folder = self.root / "build" / "formal"
        self.harnesses = self.root / "tests" / "formal"
        self.sources = rtl.Sources(self.root)
        self.version = rtl.run([yosys, "-V"])[1].strip()
        self.processes = Processes(self.root)

    def files(self, one):
        """(the modules under proof by name, the harness and what it shares). Raises ProofError."""
        for module in (one.module, one.file):
            if module not in self.sources.files:
                raise ProofError(f"module {module} is not in rtl/hwffd.f")
        harness = self.harnesses / f"{one.harness}.v"
        if not harness.is_file():
            raise ProofError(f"no harness tests/formal/{one.harness}.v")
        words = set(re.findall(r"\w+", rtl.strip_comments(harness.read_text())))
        needed = {}
        for module in self.sources.modules():
            if module in words or module == one.module:
                for path in self.sources.needed(module):
                    needed[pathlib.Path(path).stem] = pathlib.Path(path)
        if one.file not in needed:
            raise ProofError(f"the planted bug is in {one.file}, which is not under proof")
        shared = sorted(path for path in self.harnesses.glob("*.v")
                        if path.stem in words and path != harness)
        return needed, [*shared, harness]

    def mutated(self, one, path):
        """The text of a module with its bug. Raises ProofError."""
        text = path.read_text()
        count = text.count(one.original)
        if count != 1:
            raise ProofError(
                f"the text that the planted bug replaces is {count} times in {path.name}, not once")
        return text.replace(one.original, one.mutant)

    def script(self, one, lemmas, needed, harness, circuit):
        """The steps of yosys; they end with the circuit."""
        folders = "".join(f"-I {folder} " for folder in self.sources.includes)
        values = "".join(f" -chparam {word.replace('=', ' ')}" for word in one.parameters.split())

        def assertion(name):
            return f"t:$assert n:{name} n:*.{name} %u %i"

        words = []  # a harness may name words of small memories, which then must be registers
        if any("memory_q[" in path.read_text() for path in harness):
            words = ["memory_collect", "memory_map r:SIZE<=8"]
        wanted, assumed = assertion(one.name), []
        for lemma in lemmas:
            assumed += [f"select -assert-count 1 {assertion(lemma)}",
                        f"chtype -set $assume {assertion(lemma)}"]
        return [
            f"read_verilog {folders}" + " ".join(map(str, needed.values())),
            f"read_verilog -formal {folders}" + " ".join(map(str, harness)),
            f"hierarchy -check -top {one.harness}{values}",
            "proc",
            *words,
            "flatten",
            "check -assert",
            f"select -assert-count 1 {wanted}",
            *assumed,
            f"select t:$assert {wanted} %d",
            "delete",
            "select -clear",
            "opt -full",
            "memory_map",
            "opt -full",
            "techmap",
            "dffunmap",
            "simplemap",
            "opt -fast -nodffe -nosdff",
            "abc -g AND -fast",
            "opt_clean",
            f"write_aiger -I -B -zinit {circuit}",
        ]

    def key(self, one):
        """Changes with whatever a verdict depends on. Raises ProofError."""
        needed, harness = self.files(one)
        digest = hashlib.sha256("\n".join([
            self.version, one.module, one.name, one.harness, one.parameters, one.method, one.lemmas,
            one.file, one.original, one.mutant]).encode())
        headers = sorted(self.sources.rtl.glob("*/*.vh"))
        for path in (*needed.values(), *harness, *headers, pathlib.Path(__file__)):
            digest.update(hashlib.sha256(path.read_bytes()).digest())
        return digest.hexdigest()

    def last(self, one):
        """The newest verdict, of these sources or of others; {} if there is none."""
        try:
            found = json.loads((self.folder / f"{one.full_name}.json").read_text())
        except (OSError, ValueError):
            return {}
        return found if isinstance(found, dict) else {}

    def result(self, one):
        """The verdict on these sources, if there is one; else None. Raises ProofError."""
        found = self.last(one)
        return found if found.get("key") == self.key(one) else None

    def log(self, one):
        return f"build/formal/{one.full_name}.*.log"

    def run(self, one):
        """Proves a property and refutes its planted bug. Keeps the verdict where both are clear,
        and returns it. Raises ProofError."""
        self.folder.mkdir(parents=True, exist_ok=True)
        key = self.key(one)
        needed, harness = self.files(one)
        bug = self.mutated(one, needed[one.file])
        work = self.folder / f"{one.full_name}.{os.getpid()}"
        work.mkdir(exist_ok=True)
        try:
            start = time.monotonic()
            result, note = self._decide(
                one, one.lemmas.split(), needed, harness, work, "proof")
            middle = time.monotonic()
            changed = work / f"{one.file}.v"
            changed.write_text(bug)
            control, frame = self._decide(
                one, [], {**needed, one.file: changed}, harness, work, "control")
        finally:
            shutil.rmtree(work, ignore_errors=True)
        verdict = {
            "key": key, "result": result, "negative_control": control,
            "seconds": round(middle - start, 1),
            "control_seconds": round(time.monotonic() - middle, 1),
            "clocks_to_counterexample": frame if control == REFUTED else None,
        }
        if result == REFUTED:
            verdict["broken_at_clock"] = note
        if UNDECIDED not in (result, control):
            write(self.folder / f"{one.full_name}.json", json.dumps(verdict) + "\n")
        return verdict

    def _decide(self, one, lemmas, needed, harness, work, what):
        """(verdict, the clock of the counterexample or None)."""
        log = self.folder / f"{one.full_name}.{what}.log"
        circuit = work / f"{what}.aig"
        steps = "; ".join(self.script(one, lemmas, needed, harness, circuit))
        with open(log, "w", encoding="utf-8") as out:
            status = self.processes.call([self.yosys, "-Q", "-T", "-p", steps], out)
            if status != 0:
                raise ProofError(f"{what}: {self._complaint(log, status)}")
            out.flush()
            clocks = SEARCH if what == "control" else BASE
            steps = (f"pdr -T {self.limit}" if one.method == PDR else
                     f"bmc3 -F {clocks} -T {self.limit}; ind -F {STEPS} -T {self.limit}")
            self.processes.call([self.abc, "-c", f"read_aiger {circuit}; fold; strash; {steps}"], out)
        text = log.read_text(errors="replace")
        broken = re.search(r"was asserted in frame (\d+)", text)
        if broken:
            return REFUTED, int(broken.group(1))
        proved = ("Property proved." in text if one.method == PDR else
                  f"No output asserted in {BASE} frames" in text
                  and "Networks are equivalent" in text)
        return (PROVED if proved else UNDECIDED), None

    @staticmethod
    def _complaint(log, status):
        text = log.read_text(errors="replace")
        errors = re.findall(r"^(?:[^ ]+: )?ERROR: (.*)$", text, re.MULTILINE)
        if not errors:
            return f"yosys ended with status {status}"
        if "Assertion failed" in errors[0] or "select" in errors[0]:
            return "the harness has not exactly one assertion of this name"
        if "problems in 'check" in errors[0]:
            found = re.findall(r"^Warning: (.*)$", text, re.MULTILINE)
            return found[-1].rstrip(":.") if found else errors[0]
        return errors[0]
