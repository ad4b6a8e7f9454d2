"""make -C lab bfp: block floating point, its error and the bits of its organizations.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, listing, shown


def errors(reports):
    """Largest errors of both forms in units in the last place, and what is proved."""
    rows = reports.rows("bfp")
    forms = list(dict.fromkeys(row["form"] for row in rows))
    value = {(row["points"], row["form"]): row["max_error_ulp"] for row in rows}
    bound = {row["form"]: row["bound_ulp"] for row in rows}
    lines = [[points, *(shown(value[points, form], ".3f") for form in forms)]
             for points in dict.fromkeys(row["points"] for row in rows)]
    return Table(["control points", *(f"{form} form" for form in forms)],
                 [*lines, ["proved", *(shown(bound[form], ".3f") for form in forms)]])


def printed(reports):
    report = reports.get("bfp")
    table = listing(report["errors"], "control points | points", "form | form",
                    "max, ulp of the lattice | max_error_ulp:.4f",
                    "ulp of its support | max_error_ulp_of_support:.3f", "bound | bound_ulp:.3f",
                    "vertices | vertices")
    return "\n".join([table.text(), "", *(
        f"{len(entry['rows'])} rows in the {entry['form']} form, {entry['vertices']} vertices each: "
        f"{entry['mismatches']} results differ from the model's, {entry['disagreements']} from those "
        f"of {entry['rows'][0]}" for entry in report["organizations"])])


def missing(reports):
    forms = {entry["form"] for entry in reports.get("bfp")["organizations"]}
    return "" if forms == {"product", "factored"} else "a form"


TABLES = {"errors": errors}
FIGURES = {"rtl_rows": lambda reports: sum(len(entry["rows"])
                                           for entry in reports.get("bfp")["organizations"]),
           "rtl_vertices": lambda reports: reports.get("bfp")["organizations"][0]["vertices"]}
