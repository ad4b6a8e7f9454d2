"""make -C lab bounds: what is proved of errors, beside errors that are reached.

SPDX-License-Identifier: Apache-2.0
"""

from lab.bounds import forms as proved
from tools.reports.text_table import Table, shown

FORMS = proved.NAMES
# Of a form, what its ratio shall be at most.
AIMS = {"factored": 1.2, "product": 1.6, "sequence": 4.0, "tree": 4.0}
FORMATS = ("fx12", "fx13", "fx14", "fx15", "fx16", "fx17", "fx18", "fx32", "bfp32", "fp32", "fp32-fused")
FAMILIES = ("bspline", "powers", "bernstein", "hermite", "catmull-rom", "linear", "slopes", "powers slopes")
OF_SOME = ("powers", "slopes", "powers slopes")  # which not every format has


def _unit(name):
    """A unit of a weight."""
    return 2.0 ** {**{f"fx{width}": 2 - width for width in range(12, 17)}, "fx17": -15, "fx18": -16, "fx32": -30, "bfp32": -33}.get(name, -24)


def _ratio(row):
    return row["bound"] / row["witness"]


def _sorted(rows):
    return sorted(rows, key=lambda row: (FORMS.index(row["form"]), FORMATS.index(row["format"]), row["bound"]))


def sharpest(reports):
    """Of each form and format the smallest bound."""
    best = {}
    for row in _sorted(row for row in reports.rows("bounds") if row["form"] in FORMS):
        best.setdefault((row["form"], row["format"]), row)
    return best


def forms(reports):
    """Composed bounds, a form and format a line, or two where one takes nothing for granted."""
    return Table(["form", "format", "bound", "reached", "ratio", "checked by", "taken for granted"],
                 [[f"`{row['form']}`", f"`{row['format']}`", shown(row["bound"], ".3e"),
                   shown(row["witness"], ".3e"), shown(_ratio(row), ".2f"), row["checked_by"],
                   row["hypothesis"] or "nothing"]
                  for row in _sorted(row for row in reports.rows("bounds") if row["form"] in FORMS)])


def certified(reports):
    """The sharpest bound of each form and format by its name, and the one that takes nothing for granted."""
    plain = {(row["form"], row["format"]): row["bound"] for row in reports.rows("bounds") if not row["hypothesis"]}
    return Table(["form", "format", "certificate", "bound", "reached", "nothing taken for granted"],
                 [[f"`{form}`", f"`{name}`", f"`{row['certificate']}`", shown(row["bound"], ".3e"),
                   shown(row["witness"], ".3e"), shown(plain[form, name], ".3e") if (form, name) in plain else "-"]
                  for (form, name), row in sharpest(reports).items()])


def weights(reports):
    """Weights of a family, a format a column: the bound in units, and its ratio to what is reached."""
    rows = {(row["form"], row["format"]): row for row in reports.rows("bounds")}
    formats = [name for form, name in rows if form == "weights bspline"]

    def cell(family, name):
        row = rows.get((f"weights {family}", name))
        if not row:
            return "-" if family in OF_SOME else "exact"
        return f"{shown(row['bound'] / _unit(name), '.2f')} ({shown(_ratio(row), '.2f')})"

    return Table(["functions", *(f"`{name}`" for name in formats)],
                 [[f"`{family}`", *(cell(family, name) for name in formats)] for family in FAMILIES
                  if any((f"weights {family}", name) in rows for name in formats)])


def axes(reports):
    """What the search has looked at all of, in units of a weight."""
    lines = []
    for row in reports.get("bounds")["axes"]:
        if row["weights"] not in proved.WEIGHTS.values():
            continue
        unit = _unit(row["format"])
        lines.append([f"`{row['weights']}`", f"`{row['format']}`", shown(row["coordinates"], ","),
                      shown(row["error"] / unit, ".2f"),
                      *(shown(row[field] / unit, ".2f") if row[field] else "-" for field in ("pair", "distance"))])
    return Table(["weights", "format", "coordinates", "one axis", "two, rounded", "three"], lines)


def missing(reports):
    measured = {row["form"] for row in reports.rows("bounds")}
    wanted = {*FORMS, *(f"weights {family}" for family in FAMILIES)}
    return ", ".join(sorted(wanted - measured))


def _largest(form):
    return lambda reports: max(_ratio(row) for (of, _), row in sharpest(reports).items() if of == form)


def _missed(reports):
    """Forms and formats that miss their aim, in words."""
    names = [f"`{form}` in `{name}` ({shown(_ratio(row), '.2f')})" for (form, name), row in sharpest(reports).items()
             if _ratio(row) > AIMS.get(form, float("inf"))]
    return ", ".join(names) or "none"


def _kind(checked_by):
    return lambda reports: sum(row["checked_by"] == checked_by for row in reports.rows("bounds"))


TABLES = {"forms": forms, "weights": weights, "axes": axes, "certified": certified}
FIGURES = {**{f"ratio_{form}": _largest(form) for form in AIMS}, "missed": _missed,
           "hypotheses": lambda reports: sum(bool(row["hypothesis"]) for row in reports.rows("bounds")),
           "certified": _kind("gappa+coq"), "of": lambda reports: len(reports.rows("bounds"))}
