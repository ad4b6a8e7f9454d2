"""The table of names that went, rtl/gone.csv: organizations and evaluators that a core no longer has. Their
numbers are never given again, and whoever asks for one of them is told what replaces it.

SPDX-License-Identifier: Apache-2.0
"""

import functools
from dataclasses import dataclass

from tools import csv_table
from tools.csv_table import TableError
from tools.project_root import ROOT

TABLE = ROOT / "rtl" / "gone.csv"
COLUMNS = ("kind", "name", "number", "instead", "version")
KINDS = ("org", "evaluator")  # columns of rtl/configurations.csv
NUMBERS = range(256)


@dataclass(frozen=True)
class Gone:
    kind: str
    name: str
    number: int  # of the parameter
    instead: str
    version: str

    def __str__(self):
        return f"{self.name} went with {self.version}: take {self.instead}"


@functools.lru_cache(maxsize=None)
def read(path=TABLE):
    """Raises TableError."""
    return tuple(Gone(csv_table.word(cells, "kind", where, KINDS), cells["name"],
                      csv_table.number(cells, "number", where, NUMBERS), cells["instead"], cells["version"])
                 for where, cells in csv_table.read(path, COLUMNS))


def find(kind, name=None, number=None):
    """The one of that kind that had the name or the number, if one had."""
    return next((one for one in read() if one.kind == kind and (one.name == name or one.number == number)), None)


def check(kind, where, name, number=None):
    """Raises TableError for a name or a number that went."""
    one = find(kind, name, number)
    if one and one.name == name:
        raise TableError(f"{where}: {one}")
    if one:
        raise TableError(f"{where}: number {number} was that of {one.name}, and is never given again")


def refuse(name):
    """Raises TableError for the name of an organization that went, or of a row that had what went."""
    for one in read():
        if one.name.replace("/", "") in name.replace("/", "").split("-"):
            raise TableError(str(one))
