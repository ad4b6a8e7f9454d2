"""make -C lab upsets: bits that flip while the core works.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

HEADS = {"no_effect": "no effect", "flagged": "flagged", "silent": "silent", "hang_cleared": "hang, reset helps",
         "hang_stuck": "hang, it does not", "outside_window": "write outside", "other": "other"}
TOPS = ("hwffd_stream", "hwffd_axi")
KINDS = ("registers", "memories")
FLIPS = 9604  # of a row


def _name(row):
    return f"`{row['top']}`" + (", hardened" if row["hardened"] else "")


def outcomes(reports):
    """A core and kind of bits a line."""
    return Table(["core", "bits", "of", "flips", *HEADS.values()], [
        [_name(row), row["bits"], shown(row["of"], ","), shown(row["flips"], ","),
         *(shown(row[outcome], ",") for outcome in HEADS)] for row in reports.rows("upsets")])


def shares(reports):
    """The same in percent, each with its interval of 95 %."""
    def share(interval):
        return f"{interval[0]:.1f} ({interval[1]:.1f} to {interval[2]:.1f})"

    return Table(["core", "bits", *HEADS.values()], [
        [_name(row), row["bits"], *(share(row["percent"][outcome]) for outcome in HEADS)]
        for row in reports.rows("upsets")])


def modules(reports, top, *words):
    """The modules of a core, those first of whose flips the most do something; "hardened" may follow."""
    rows = [row for row in reports.get("upsets")["modules"]
            if row["top"] == top and row["hardened"] == ("hardened" in words)]
    rows.sort(key=lambda row: (row["bits"] != "registers", row["no_effect"] - row["flips"], row["module"]))
    return Table(["module", "bits", "flips", *HEADS.values()], [
        [f"`{row['module']}`", row["bits"], shown(row["flips"], ","),
         *(shown(row[outcome], ",") for outcome in HEADS)] for row in rows])


def places(reports, outcome):
    """The registers behind an outcome that ought not to be, and how often it was each."""
    lines = [[_name(row), f"`{name}`", shown(count, ",")] for row in reports.rows("upsets")
             for name, count in row["places"][outcome].items()]
    return Table(["core", "register", "flips"], lines or [["-", "-", "0"]])


def cost(reports):
    """What HARDENED costs on ECP5, a top a line."""
    lines = reports.get("upsets")["cost"]

    def cells(line):
        return [shown(line[field], ",") for field in ("lut", "ff", "bram")]

    return Table(["core", "LUT4", "flip-flops", "block memories"], [[_name(line), *cells(line)] for line in lines])


def printed(reports):
    return outcomes(reports).text()


def missing(reports):
    measured = {(_name(row), row["bits"]) for row in reports.rows("upsets") if row["flips"] >= FLIPS}
    wanted = {(_name({"top": top, "hardened": hardened}), kind)
              for top in TOPS for hardened in (False, True) for kind in KINDS}
    return "; ".join(" ".join(pair) for pair in sorted(wanted - measured))


TABLES = {"outcomes": outcomes, "shares": shares, "modules": modules, "places": places, "cost": cost}
FIGURES = {}
