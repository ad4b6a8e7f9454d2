"""What `make formal` proves, by which steps, and what a verdict depends on.

A property is one labelled assertion of a harness in lab/formal/ (INSTANCE.LABEL below its top).
yosys makes an AIGER circuit of harness and RTL, all other assertions taken out, and ABC proves it
for every length of run or finds a run that breaks it: by pdr, which finds its own invariant, or,
where that is arithmetic on wide words, by induction over an assertion that is written as one. Other
properties of the same harness, proved by themselves, may then be used as lemmas. A planted bug must
be found in so many clocks from reset; lemmas are not used there, since they need not hold.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import dataclasses
import pathlib
import re

from tools.csv_table import write_if_changed
from tools.rtl import digest, rtl_sources
from tools.synth import engine
from tools.tables import register_rtl, registers

TABLE = "lab/formal/properties.csv"
COLUMNS = ("module", "name", "harness", "parameters", "method", "lemmas", "file", "original",
           "mutant", "statement")
PDR, SCORR, INDUCTION = METHODS = "pdr", "scorr", "induction"
BASE, STEPS = 6, 2    # clocks searched from reset; clocks of the step, the last of which is proved
SEARCH = 120          # clocks from reset in which a planted bug must be found
STAND_INS = re.compile(r"^// Stand-ins: (.*)$", re.MULTILINE)  # files with modules in the place of others
PROOF, CONTROL = "proof", "control"
PROVED, REFUTED, UNDECIDED = "proved", "refuted", "undecided"


class ProofError(Exception):
    """A table or a property that makes no sense, in one line."""


@dataclasses.dataclass(frozen=True)
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
    path, properties = pathlib.Path(path), []
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
        prop = Property(*row)
        for column in ("module", "name", "harness", "file"):
            if not re.fullmatch(r"[a-z]\w*(\.\w+)*", getattr(prop, column)):
                raise ProofError(f"{where}: {column} '{getattr(prop, column)}' is not a name")
        if not all(re.fullmatch(r"[A-Z]\w*=\d+", word) for word in prop.parameters.split()):
            raise ProofError(f"{where}: parameters '{prop.parameters}' are not NAME=NUMBER")
        if prop.method not in METHODS:
            raise ProofError(f"{where}: method '{prop.method}' is none of {', '.join(METHODS)}")
        if not prop.original or prop.original == prop.mutant:
            raise ProofError(f"{where}: the planted bug changes nothing")
        if not prop.statement:
            raise ProofError(f"{where}: no statement")
        if prop.full_name in [other.full_name for other in properties]:
            raise ProofError(f"{where}: {prop.full_name} is there twice")
        properties.append(prop)
    for prop in properties:
        for lemma in prop.lemmas.split():
            if not any(other.name == lemma and other.module == prop.module and not other.lemmas
                       and other.harness == prop.harness and other.parameters == prop.parameters
                       for other in properties):
                raise ProofError(f"{path.name}: {prop.full_name}: lemma '{lemma}' is no property of"
                                 " this harness with these parameters and without lemmas")
    return properties


def registers_at_rest(of_table):
    """Connections of ffd_bus_registers: what software only reads is 0, but for STATUS, of which harnesses say more."""
    ports = {}
    for field in (field for register in of_table for field in register.fields):
        if field.access == "ro" and field.register != "STATUS":
            name, half = register_rtl.signal_name(field)
            ports[name] = 64 if half else field.width
    return "".join(f".{name}_i({width}'d0),\n" for name, width in ports.items())


class Proofs:
    """The properties of one checkout as steps of yosys and ABC; verdicts lie in build/formal/, their
    keys in their names."""

    def __init__(self, root, limit=300):
        self.root, self.limit = pathlib.Path(root), limit
        self.folder = self.root / "build" / "formal"
        self.harnesses = self.root / "lab" / "formal"
        self.sources = rtl_sources.Sources(self.root)
        self.version = rtl_sources.run(["yosys", "-V"])[1].strip()
        made = self.folder / "headers"
        self.includes = [*self.sources.includes, str(made)]
        if (self.root / registers.TABLE).is_file():
            write_if_changed(made / "registers_at_rest.vh", registers_at_rest(registers.read(self.root)))

    def sources_of(self, prop):
        """(the modules under proof by name, the harness and what it shares). Raises ProofError."""
        for module in (prop.module, prop.file):
            if module not in self.sources.files:
                raise ProofError(f"module {module} is not in rtl/hwffd.f")
        harness = self.harnesses / f"{prop.harness}.v"
        if not harness.is_file():
            raise ProofError(f"no harness lab/formal/{prop.harness}.v")
        there = {path.stem: path for path in sorted(self.harnesses.glob("*.v"))}
        words, files, own = set(), [harness], set()
        for path in files:  # grows by what the files before it name, in their code or as stand-ins
            text = path.read_text()
            mentioned = set(re.findall(r"(\w+)\.v\b", " ".join(STAND_INS.findall(text))))
            text = rtl_sources.strip_comments(text)
            mentioned |= set(re.findall(r"\w+", text))
            own |= set(re.findall(r"^module (\w+)", text, re.MULTILINE))  # also in a module's place
            files += [there[stem] for stem in there if stem in mentioned and there[stem] not in files]
            words |= mentioned
        needed = {}
        for module in self.sources.modules():
            if module in words or module == prop.module:
                for path in self.sources.needed(module):
                    needed[pathlib.Path(path).stem] = pathlib.Path(path)
        needed = {stem: path for stem, path in needed.items() if stem not in own}
        if prop.file not in needed:
            raise ProofError(f"the planted bug is in {prop.file}, which is not under proof")
        return needed, [*sorted(files[1:]), harness]

    def mutated(self, prop):
        """The text of a module with its bug. Raises ProofError."""
        path = self.sources.files[prop.file]
        try:
            return rtl_sources.changed(path.read_text(), prop.original, prop.mutant, path.name)
        except ValueError as error:
            raise ProofError(str(error)) from error

    def script(self, prop, planted=None):
        """The steps of yosys up to the circuit of the proof, or of its control: with the file in which
        a bug is planted, and without lemmas. Raises ProofError."""
        needed, harness = self.sources_of(prop)
        hierarchical = any("keep_hierarchy" in path.read_text() for path in needed.values())
        lemmas = [] if planted else prop.lemmas.split()
        if planted:
            needed[prop.file] = planted
        folders = "".join(f"-I {folder} " for folder in self.includes)
        values = "".join(f" -chparam {word.replace('=', ' ')}" for word in prop.parameters.split())

        def assertion(name):
            return f"t:$assert n:{name} n:*.{name} %u %i"

        words = []  # a harness may name words of small memories, which then must be registers
        if any("memory_q[" in path.read_text() for path in harness):
            words = ["memory_collect", "memory_map r:SIZE<=8"]
        wanted, assumed = assertion(prop.name), []
        for lemma in lemmas:
            assumed += [f"select -assert-count 1 {assertion(lemma)}",
                        f"chtype -set $assume {assertion(lemma)}"]
        return [
            f"read_verilog {folders}" + " ".join(map(str, needed.values())),
            f"read_verilog -formal {folders}" + " ".join(map(str, harness)),
            f"hierarchy -check -top {prop.harness}{values}",
            "proc",
            *words,
            *(rtl_sources.FLATTEN if hierarchical else ["flatten"]),  # so that kept proofs of the others stay good
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
        ]

    def prover(self, prop, what):
        """The steps of ABC on a circuit that has been read."""
        if what == CONTROL:
            steps = f"bmc3 -F {SEARCH} -T {self.limit}"
        elif prop.method == PDR:
            steps = f"pdr -T {self.limit}"
        elif prop.method == SCORR:
            steps = f"scorr; dc2; pdr -T {self.limit}"
        else:
            steps = f"bmc3 -F {BASE} -T {self.limit}; ind -F {STEPS} -T {self.limit}"
        return f"fold; strash; {steps}"

    def key(self, prop):
        """Changes with whatever a verdict depends on. Raises ProofError."""
        needed, harness = self.sources_of(prop)
        self.mutated(prop)
        folders = tuple(self.includes)
        return digest.of(
            self.version, prop.method, str((BASE, STEPS)), prop.file, prop.original, prop.mutant,
            *self.script(prop)[2:],
            digest.tokens(tuple(map(str, needed.values())), folders, "YOSYS", "SYNTHESIS"),
            digest.tokens(tuple(map(str, harness)), folders, "YOSYS", "FORMAL"))

    def files(self, prop):
        """What ABC says of the proof and of its control. Raises ProofError."""
        return [self.folder / f"{prop.full_name}.{self.key(prop)}.{what}.said"
                for what in (PROOF, CONTROL)]

    def log(self, prop):
        """What ABC says, of both, as one pattern."""
        return f"build/formal/{prop.full_name}.{self.key(prop)}.*.said"

    def result(self, prop):
        """The verdict on these sources, if there is one; else None. Raises ProofError."""
        files = self.files(prop)
        # Seconds come last: without them a run was broken off.
        if not all(path.is_file() and path.with_suffix(".seconds").is_file() for path in files):
            return None
        (result, clock), (control, frame) = (decided(prop, path.read_text(errors="replace"))
                                             for path in files)
        took, control_took = (engine.seconds(path.with_suffix(".seconds")) for path in files)
        return {"result": result, "negative_control": control, "seconds": took,
                "control_seconds": control_took,
                "clocks_to_counterexample": frame if control == REFUTED else None,
                **({"broken_at_clock": clock} if result == REFUTED else {})}

    def effort(self, prop):
        """The seconds that it took with other sources."""
        return max(map(engine.seconds, self.folder.glob(f"{prop.full_name}.*.seconds")), default=0)


def changed_since(proofs, everything, commit):
    """The properties whose row, harness or modules under proof differ from those of a commit, in groups of what one
    commit changed last, the newest first. Raises ProofError."""
    def git(*words):
        status, text = rtl_sources.run(["git", "-C", str(proofs.root), *words])
        if status:
            raise ProofError(f"commit '{commit}': "
                             f"{text.strip().splitlines()[-1] if text.strip() else 'unknown to git'}")
        return text

    diff = git("diff", "--name-status", commit, "--", "rtl", str(pathlib.Path(TABLE).parent))
    different = {pathlib.Path(line.split("\t")[-1]).name: line.split("\t")[-1]
                 for line in diff.splitlines() if not line.startswith("R100")}
    table = pathlib.Path(TABLE).name
    rows = set(map(tuple, csv.reader(git("show", f"{commit}:{TABLE}").splitlines()))) if table in different else None
    order = {name: place for place, name in enumerate(git("rev-list", "HEAD").split())}
    changed_last = {name: order.get(git("log", "-1", "--format=%H", "--", path).strip(), -1)
                    for name, path in different.items()}

    def read(path):
        """Its name, and those of all that it includes."""
        names, texts = {path.name}, [path.read_text()]
        for text in texts:
            for name in re.findall(r'^\s*`include "([^"]+)"', text, re.MULTILINE):
                if name not in names:
                    names.add(name)
                    texts += [(folder / name).read_text() for folder in map(pathlib.Path, proofs.includes)
                              if (folder / name).is_file()]
        return names

    groups = {}
    for prop in everything:
        needed, harness = proofs.sources_of(prop)
        names = set().union(*(read(path) for path in (*needed.values(), *harness))) & set(different)
        if rows is not None and dataclasses.astuple(prop) not in rows:
            names.add(table)
        if names:
            groups.setdefault(min(changed_last[name] for name in names), []).append(prop)
    return [groups[place] for place in sorted(groups)]


def decided(prop, output):
    """(verdict, the clock of the counterexample or None) of what ABC said."""
    broken = re.search(r"was asserted in frame (\d+)", output)
    if broken:
        return REFUTED, int(broken.group(1))
    proved = ("Property proved." in output if prop.method != INDUCTION else
              f"No output asserted in {BASE} frames" in output
              and "Networks are equivalent" in output)
    return (PROVED if proved else UNDECIDED), None


def in_words(complaint):
    """What yosys says where it looks for the one assertion of a property, in the words of the table."""
    if "Assertion failed" in complaint or "select" in complaint:
        return "the harness has not exactly one assertion of this name"
    return complaint
