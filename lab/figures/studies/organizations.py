"""make organizations: clocks of every organization counted in the RTL, operators, errors, seams.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports import throughput
from tools.reports.organization_tables import is_plain, rows
from tools.reports.results import RequestError
from tools.reports.text_table import Table, shown
from tools.tables import configurations, organizations

FORMATS = ("fp32", "fx17", "fx18", "fx32")


def first(rows, **wanted):
    """The first of the rows with these fields; an empty one if there is none."""
    return next((row for row in rows
                 if all(row[key] == value for key, value in wanted.items())), {})


def _operators(row, field):
    counted = row.get(field)
    return f"{counted['mul']} + {counted['add']}" if counted else "-"


def _fixed(rows):
    """Those in fx18, or else in fx17."""
    return next((part for word in ("fx18", "fx17") if (part := [row for row in rows if row["format"] == word])), [])


def clocks(reports):
    """Section 4 of the paper and what goes beyond it; operators in fixed point."""
    everything, lines = rows(reports), []
    for name in dict.fromkeys(organizations.label(row) for row in everything):
        selected = [row for row in everything if organizations.label(row) == name]
        plain = [row for row in selected if is_plain(row)]
        fixed = _fixed(plain)
        paper = first(fixed, schedule="paper")
        overlapped = first(fixed, schedule="overlapped")
        fused = first(selected, schedule="paper", fmac=True)
        if overlapped:
            lines.append([
                f"`{name}`", shown(overlapped["formula"]), shown(paper.get("clocks_paper")),
                shown(fused.get("clocks_paper")), _operators(paper, "operators"),
                _operators(paper, "operators_drawn"),
                shown(overlapped["interval_overlapped"], ".3g"), _operators(overlapped, "operators"),
                *(shown(first(plain, schedule="overlapped", format=word).get("max_error"), ".2e")
                  for word in FORMATS)])
    return Table(["organization", "formula", "counted", "fused", "multipliers + adders", "as drawn",
                  "overlapped", "multipliers + adders, overlapped",
                  *(f"max error `{word}`" for word in FORMATS)], lines)


def units(reports, *names):
    """What is explained of some organizations: clocks and operators at both schedules, in fx18 or else fx17."""
    everything, lines = [row for row in rows(reports) if is_plain(row)], []
    for name in names:
        selected = [row for row in everything if organizations.label(row, "") == name]
        fixed = _fixed(selected)
        paper, overlapped = (first(fixed, schedule=schedule) for schedule in ("paper", "overlapped"))
        if not overlapped:
            raise RequestError(f"no organization '{name}' in fx18 or fx17")
        lines.append([f"`{organizations.label(overlapped)}`", shown(paper.get("clocks_paper")), _operators(paper, "operators"),
                      shown(overlapped["interval_overlapped"], ".3g"), _operators(overlapped, "operators")])
    heads = ["organization", "cycles, paper's schedule", "multipliers + adders", "cycles, overlapped",
             "multipliers + adders, overlapped"]
    if all(line[1] == "-" for line in lines):
        return Table([heads[0], "cycles per vertex", heads[2]], [[line[0], *line[3:]] for line in lines])
    return Table(heads, lines)


def _sum(row):
    return "/".join(str(row[kind]) for kind in ("mul", "add", "fma"))


def _line(everything, row):
    """A row of the overlapped schedule with its partner at the paper's, for a terminal."""
    same = {key: row[key] for key in ("org", "n", "format", "fmac")}
    paper = first(everything, **same, schedule="paper")
    both = [entry for entry in (row, paper if paper is not row else {}) if entry]
    verdict = {None: "-", True: "yes", False: "NO"}
    return [row["org"], str(row["n"]), row["format"],
            row["evaluator"] + (" fmac" if row["fmac"] else ""), shown(row["formula"]),
            shown(row["clocks_paper"]), verdict[row["equal"]], shown(row["final_accumulation"]),
            _sum(paper["operators"]) if len(both) > 1 else "-",
            shown(row["interval_overlapped"], ".2f"), verdict[row["equal_overlapped"]],
            _sum(row["operators"]), _sum(row["operators_drawn"]), shown(row["max_error"], ".2e"),
            *(str(sum(row[field] for row in both)) for field in ("mismatches", "seam_differences")),
            shown(row["simulation_vertices_per_s"], ".0f"), shown(row["simulation_share"], ".4f")]


def printed(reports):
    """A line for each overlapped row, and for those of the paper's schedule without a partner."""
    everything = rows(reports)
    overlapped = {(row["org"], row["n"], row["format"], row["fmac"])
                  for row in everything if row["schedule"] == "overlapped"}
    lines = [_line(everything, row) for row in everything
             if row["schedule"] == "overlapped"
             or (row["org"], row["n"], row["format"], row["fmac"]) not in overlapped]
    report = reports.get("organizations")
    text = Table(["org", "n", "format", "evaluator", "formula", "clocks", "equal", "final",
                  "paper's operators", "interval", "equal", "operators", "as drawn", "max error",
                  "wrong", "seam", "vertex/s", "of C++"], lines).text()
    text += (f"\n\nvertex/s is of the simulation; C++, eq. (1) in double by three loops, does "
             f"{report['reference_vertices_per_s']:.0f}; each is timed alone on one thread, "
             f"compiled with {report['compiler_options']}\n\n")
    if not _has_areas(reports):
        return text + "no areas: make synth writes build/reports/synth.json"
    return text + throughput.table(reports).text()


def _has_areas(reports):
    """Whether there are any: of areas that are no report of make synth nothing is said."""
    return reports.has("synth") and bool(reports.get("synth").get("rows"))


def finished(reports):
    """With what each row is on every target on which it has been mapped."""
    report = reports.get("organizations")
    if not _has_areas(reports):
        return report
    targets = throughput.by_row(reports)
    return {**report, "rows": [{**row, "targets": targets.get(row["name"], {})}
                               for row in report["rows"]]}


def _total(field, **wanted):
    return lambda reports: sum(row[field] for row in rows(reports, **wanted))


def _watertight(reports):
    return [row for row in rows(reports) if not row["seam_differences"]]


def missing(reports):
    present = {row["name"] for row in rows(reports)}
    table = configurations.read(reports.root / "rtl" / "configurations.csv")
    absent = [row.name for row in table if row.name not in present]
    return f"{len(absent)} rows, the first {absent[0]}" if absent else ""


TABLES = {"clocks": clocks, "units": units}
FIGURES = {
    "rows_measured": lambda reports: len(rows(reports)),
    "results_checked": _total("checked"),
    "results_wrong": _total("mismatches"),
    "watertight_rows": lambda reports: len(_watertight(reports)),
    "watertight_results": lambda reports: sum(row["checked"] for row in _watertight(reports)),
}
