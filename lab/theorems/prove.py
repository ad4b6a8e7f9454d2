"""Theorems: units against what they should compute, each with a planted bug that is refuted.

A case is a unit with parameters. Its claim says, of the unit's terms, what is assumed and what
follows; a solver searches for inputs that break it, and finds none. Where two cases are the same
circuit but for their registers they are one question, which is asked once. Answers are kept by the
digest of the question.

SPDX-License-Identifier: Apache-2.0
"""

import hashlib
import json
from concurrent import futures
from dataclasses import dataclass, field
from typing import Callable

from lab.theorems import netlist, solve, terms
from lab.theorems.netlist import TheoremError

PROVED, REFUTED, OPEN = "proved", "refuted", "open"
SMALL = 16  # questions that a solver is given at once


@dataclass(frozen=True)
class Case:
    """A unit with parameters."""

    unit: str
    parameters: dict
    latency: int                      # of its outputs; None where they depend on no input
    claim: Callable                   # of (unit, parameters): (hypotheses, goal)
    late: dict = field(default_factory=dict)
    solver: str = "bitwuzla"
    limit: int = 3600                 # seconds of the clock

    @property
    def label(self):
        words = [f"{key}={value}" for key, value in self.parameters.items()]
        return " ".join([self.unit, *words, *([str(self.claim)] if hasattr(self.claim, "label") else [])])


@dataclass(frozen=True)
class Theorem:
    """A statement about a unit at every width and latency that its cases have."""

    name: str
    statement: str
    widths: str
    bug: netlist.Bug
    cases: tuple
    note: str = ""
    also: tuple = ()                  # cases that must be the first one's circuit but for registers
    control: int = 0                  # the case that the bug must break
    nightly: bool = False
    heavy: bool = False               # each question takes seconds
    quick: bool = False               # one of those that `make test` proves


@dataclass(frozen=True)
class Lemma:
    """A truth about whole numbers, as a script of SMT-LIB, and a false one that resembles it."""

    name: str
    statement: str
    script: str
    false: str
    widths: str = "all"
    note: str = ""
    nightly: bool = False
    quick: bool = True


def shared(left, right):
    """A product as a word of which only its factors are known: the same on both sides."""
    return terms.apply(f"product{left.width}", left.width, left, right)


class Prover:
    """Runs cases; folder holds questions and answers."""

    def __init__(self, folder, jobs=1, say=lambda text: None):
        self.folder, self.jobs, self.say = folder, jobs, say
        self.units = {}
        (folder / "questions").mkdir(parents=True, exist_ok=True)

    def _path(self, script, solver):
        versions = json.dumps(solve.versions())
        digest = hashlib.sha256(f"{solver} {versions} {script}".encode()).hexdigest()[:24]
        return self.folder / "questions" / f"{digest}.smt2"

    def ask(self, scripts, solver, limit):
        """For each script unsat, sat or unknown, a counterexample, and seconds of processor; what is
        answered already is not asked again."""
        paths = [self._path(script, solver) for script in scripts]
        left = [path for path in paths if not path.with_suffix(".json").exists()]
        for path, script in zip(paths, scripts):
            path.write_text(script, encoding="utf-8")
        replies = {}
        for path, answer in zip(left, solve.run(solver, left, limit) if left else ()):
            if answer[0] not in ("sat", "unsat", "unknown"):
                raise TheoremError(f"{solver} says of {path}: {answer[0]}")
            replies[path] = answer
            if answer[0] != "unknown":
                path.with_suffix(".json").write_text(json.dumps(answer))
        return [replies.get(path) or json.loads(path.with_suffix(".json").read_text(encoding="utf-8"))
                for path in paths]

    def elaborate(self, cases):
        """Reads the units of cases at once."""
        keys = {self._key(case): case for case in cases}
        circuits = netlist.read([(case.unit, case.parameters, case.late) for case in keys.values()],
                                self.folder / "netlists", cut=shared)
        self.units = dict(zip(keys, circuits))

    @staticmethod
    def _key(case, bug=None):
        return (case.unit, *case.parameters.items(), *case.late.items(), bug)

    def unit(self, case, bug=None):
        """The terms of a case, its registers counted."""
        key = self._key(case, bug)
        if key not in self.units:
            self.units[key], = netlist.read([(case.unit, case.parameters, case.late)],
                                            self.folder / "netlists", bug, shared)
        unit = self.units[key]
        if bug is not None:
            return unit
        for port, depth in unit.depths.items():
            if depth not in (case.latency, None):
                raise TheoremError(f"{case.unit} {case.parameters}: {port} comes {depth} clocks after "
                                   f"the inputs, not {case.latency}")
        if set(unit.depths.values()) == {None}:
            raise TheoremError(f"{case.unit} {case.parameters}: no output depends on an input")
        return unit

    def question(self, case, bug=None):
        """The script of a case."""
        hypotheses, goal = case.claim(self.unit(case, bug), case.parameters)
        return terms.script(hypotheses, goal)

    def _same(self, theorem):
        """What keeps the other cases from being the circuit of the first."""
        first = self.unit(theorem.cases[0]).outputs if theorem.also else None
        for case in theorem.also:
            if self.unit(case).outputs != first:
                yield f"{case.label}: not the same circuit"

    def _cases(self, theorem):
        """(seconds, questions, what is left open), each question counted once."""
        self.elaborate((*theorem.cases, *theorem.also))
        questions, left = {}, list(self._same(theorem))
        for case in theorem.cases:
            questions.setdefault(self.question(case), case)
        if not questions:
            raise TheoremError(f"{theorem.name}: 0 cases")

        # Small ones together, since a solver starts as long as it takes for one.
        several = SMALL if len(questions) > SMALL and not theorem.heavy else 1
        scripts = list(questions)
        chunks = [scripts[place:place + several] for place in range(0, len(scripts), several)]

        def answer(chunk):
            case = questions[chunk[0]]
            return self.ask(chunk, case.solver, case.limit)

        seconds = 0.0
        with futures.ThreadPoolExecutor(self.jobs) as pool:
            for chunk, answers in zip(chunks, pool.map(answer, chunks)):
                for script, (result, words, took) in zip(chunk, answers):
                    seconds += took
                    if result != "unsat":
                        left.append(f"{questions[script].label}: {result}" + (f" {words}" if words else ""))
                        self.say(f"theorems: {theorem.name}: {left[-1]}")
        return seconds, len(questions), left

    def prove(self, theorem):
        """The row of a theorem."""
        seconds, questions, left = self._cases(theorem)
        case = theorem.cases[theorem.control]
        (control, words, _), = self.ask([self.question(case, theorem.bug)], case.solver, case.limit)
        return {"name": theorem.name, "unit": case.unit, "statement": theorem.statement,
                "result": OPEN if left else PROVED,
                "negative_control": {"sat": REFUTED, "unsat": "not refuted"}.get(control, OPEN),
                "counterexample": {key: hex(word) for key, word in words.items()},
                "planted_bug": {"module": theorem.bug.module, "original": theorem.bug.original,
                                "mutant": theorem.bug.mutant},
                "cases": len(theorem.cases) + len(theorem.also), "questions": questions, "left": left,
                "widths": theorem.widths, "note": theorem.note, "seconds": round(seconds, 1)}

    def lemma(self, lemma):
        """The row of a truth about whole numbers."""
        (result, _, seconds), (control, words, _) = self.ask([lemma.script, lemma.false], "z3", 600)
        return {"name": lemma.name, "unit": "whole numbers", "statement": lemma.statement,
                "result": PROVED if result == "unsat" else OPEN,
                "negative_control": {"sat": REFUTED, "unsat": "not refuted"}.get(control, OPEN),
                "counterexample": {key: str(word) for key, word in words.items()},
                "planted_bug": {}, "cases": 1, "questions": 1, "left": [] if result == "unsat" else [result],
                "widths": lemma.widths, "note": lemma.note, "seconds": round(seconds, 1)}

    def row(self, statement):
        return self.lemma(statement) if isinstance(statement, Lemma) else self.prove(statement)
