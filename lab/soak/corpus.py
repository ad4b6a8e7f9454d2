"""The kinds of traffic, and the seeds that have found a fault.

SPDX-License-Identifier: Apache-2.0
"""

import csv
import pathlib
from dataclasses import astuple, dataclass, fields

from lab.soak.runs import Kind, SoakError


@dataclass(frozen=True)
class FaultySeed:
    """A seed that has found a fault: with what traffic, in which test."""

    traffic: str
    seed: int
    test: str


def _rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.DictReader(file))


def traffic(path, only):
    """The kinds of these names, or all, each under its name."""
    kinds = {row["name"]: Kind(**row) for row in _rows(path)}
    unknown = sorted(set(only) - set(kinds))
    if unknown:
        raise SoakError(f"no traffic is called {', '.join(unknown)}: {', '.join(kinds)}")
    return {name: kind for name, kind in kinds.items() if not only or name in only}


class Corpus:
    """A file of seeds; one that finds a fault is written at once."""

    def __init__(self, path):
        self.path = pathlib.Path(path)
        try:
            self.seeds = [FaultySeed(row["traffic"], int(row["seed"]), row["test"]) for row in _rows(self.path)]
        except (KeyError, TypeError, ValueError) as error:
            raise SoakError(f"{self.path}: not a corpus: {error}") from error

    def add(self, fault):
        """Adds it, once."""
        if fault in self.seeds:
            return
        self.seeds.append(fault)
        with self.path.open("w", encoding="utf-8", newline="") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow([field.name for field in fields(FaultySeed)])
            writer.writerows(astuple(fault) for fault in self.seeds)
