"""The table of organizations, rtl/organizations.csv: the one place that says what an organization is.

`module` names the RTL, ffd_org_<module>, with the parameters that make it this organization, and the
bit-true model, class Org<Module> in hwffd/model/org_<module>.hpp. docs/architecture.md section 7
explains every column.

SPDX-License-Identifier: Apache-2.0
"""

import functools
import pathlib
import re
from dataclasses import dataclass
from typing import Optional

from tools import csv_table
from tools.csv_table import TableError
from tools.project_root import ROOT
from tools.rtl import rtl_sources as sources
from tools.tables import gone
from tools.tables.formulas import Formula

TABLE = "organizations.csv"
COLUMNS = ("org", "number", "module", "n", "form", "units", "paper", "last", "overlapped",
           "mapped", "mapped_n")
NUMBERS = range(256)  # what CONFIG.org has bits for
UNITS = range(1, 65)
# On which targets besides ECP5: none, those of `fx18`, or those of every format.
MAPPED = ("", "fx18", "every")

# Formulas of clocks. What they may name is `ClockTerms` of hwffd/model/organizations.hpp.
FORMULAS = ("paper", "last", "overlapped")
TERMS = ("n", "poly", "add", "start")

NAME = re.compile(r"[a-z]+[0-9]*(/[0-9]+(x[0-9]+)?)?")


@dataclass(frozen=True)
class Form:
    """How eq. (1) is computed, which decides what it rounds."""

    name: str
    words: tuple  # of the formats that it has
    contracts: bool  # whether it takes one axis after the other
    completes: bool  # whether it takes for granted that the functions of an axis sum to one
    meaning: str


# The one place that says what a form is; `enum class Form` of the model follows.
FORMS = {form.name: form for form in (
    Form("product", ("float", "block", "fixed"), False, False, "the sum of ((B_l B_m) B_n) P"),
    Form("factored", ("float", "block", "fixed"), True, False, "one axis after the other"),
    Form("affine", ("fixed",), True, True,
         "the same, of functions that sum to one, by differences of points"),
)}


@dataclass(frozen=True)
class Organization:
    name: str
    number: int  # the value of the parameter ORG, which software reads: it stays for ever
    module: str  # tree, of ffd_org_tree
    parameters: dict  # those of its own that make it this organization
    n: Optional[int]  # None where the rows choose
    form: str  # a name of FORMS
    units: Optional[int]  # None: N
    formulas: dict  # column -> Formula, or None where there is nothing of that kind
    mapped: str
    mapped_n: range

    @property
    def of_form(self):
        return FORMS[self.form]

    @property
    def fold(self):
        return self.parameters.get("FOLD", 1)

    @property
    def in_turn(self):
        """Whether it takes the 64 points of a vertex in turn, N in a clock."""
        return not self.of_form.contracts or self.fold == 64 or (
            self.fold == 4 and self.lanes == 1)

    @property
    def weighs_axes(self):
        """Whether it takes the four weights of an axis at once."""
        return self.of_form.contracts and self.fold != 64

    @property
    def in_sequence(self):
        """Whether it contracts a point at a time."""
        return self.of_form.contracts and self.fold == 64

    @property
    def lanes(self):
        return self.parameters.get("LANES", 1)

    @property
    def ports(self):
        """At how many ports it reads points: lanes that read in every clock have their own."""
        return self.lanes if self.fold == 4 else 1

    @property
    def walks(self):
        """Whether vertices of a row along s share what comes before s, and neighbouring cells most of it."""
        return self.of_form.contracts and self.fold == 16

    @property
    def pairs(self):
        """Whether it takes two vertices of a cell at once, which neighbour along s."""
        return self.walks and self.lanes == 2

    @property
    def jacobian(self):
        """Whether one pass gives the position and its three derivatives."""
        return self.parameters.get("JACOBIAN", 0) != 0


def module_path(rtl, module):
    return pathlib.Path(rtl) / "evaluator" / f"ffd_org_{module}.v"


def _module(cells, where, rtl):
    """("tree", {"SERIAL": 1}) of "tree SERIAL=1"."""
    module, *words = cells["module"].split(" ")
    path = module_path(rtl, module)
    if not re.fullmatch(r"[a-z]+", module) or not path.is_file():
        raise TableError(f"{where}: unknown module '{module}': there is no {path.name}")
    known = re.findall(r"\bparameter\s+(\w+)", sources.strip_comments(csv_table.read_text(path)))
    parameters = {}
    for word in words:
        name, _, value = word.partition("=")
        if name not in known or not re.fullmatch(r"[0-9]{1,4}", value):
            raise TableError(f"{where}: module: '{word}' is not NAME=NUMBER of a parameter of "
                             f"{path.name}: {', '.join(known)}")
        parameters[name] = int(value)
    return module, parameters


def _formulas(cells, where):
    formulas = {column: Formula(cells[column], TERMS, f"{where}: {column}") if cells[column] else None
                for column in FORMULAS}
    if formulas["overlapped"] is None:
        raise TableError(f"{where}: overlapped: no formula")
    if (formulas["paper"] is None) != (formulas["last"] is None):
        raise TableError(f"{where}: last: a formula where paper has one, and only there")
    return formulas


def _read_row(cells, where, rtl):
    name = cells["org"]
    if not NAME.fullmatch(name):
        raise TableError(f"{where}: bad org '{name}': letters, then perhaps a number, then "
                         "perhaps / and a number, then perhaps x and a number")

    def units(column):
        return csv_table.number(cells, column, where, range(1, 1000) if column == "units" else UNITS
                                ) if cells[column] else None

    number = csv_table.number(cells, "number", where, NUMBERS)
    gone.check("org", where, name, number)
    module, parameters = _module(cells, where, rtl)
    return Organization(
        name, number, module, parameters, units("n"),
        csv_table.word(cells, "form", where, FORMS), units("units"), _formulas(cells, where),
        csv_table.word(cells, "mapped", where, MAPPED),
        csv_table.span(cells, "mapped_n", where, UNITS) if cells["mapped_n"] else UNITS)


def read(rtl=ROOT / "rtl"):
    """name -> Organization, of the table in that folder. Raises TableError."""
    path = pathlib.Path(rtl) / TABLE
    by_name = {}
    for where, cells in csv_table.read(path, COLUMNS):
        organization = _read_row(cells, where, rtl)
        csv_table.unique(by_name, organization.name, "org", where)
        for other in by_name.values():
            if other.number == organization.number:
                raise TableError(f"{where}: number {other.number} is that of '{other.name}'")
        by_name[organization.name] = organization
    if not by_name:
        raise TableError(f"{path}: no organizations")
    return by_name


@functools.lru_cache(maxsize=None)
def known():
    """Those of this checkout."""
    return read()


def label(row, between=" "):
    """An organization as tables and pictures call it: "basic"; with N where the rows choose it: "tree 8".
    `row` is one of a report."""
    own = known().get(row["org"])
    return f"{row['org']}{between}{row['n']}" if own and own.n is None else row["org"]


def is_second_name(row):
    """Whether a row of a report has the name of another organization, which is the same with this N: the
    tree of 64 units is `parallel`."""
    own = known().get(row["org"])
    return own is not None and own.n is None and any(
        other.n == row["n"] and (other.module, other.parameters) == (own.module, own.parameters)
        for other in known().values())
