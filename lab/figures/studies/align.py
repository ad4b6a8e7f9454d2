"""make -C lab align: hwffd and programs of others align pairs of volumes whose deformation is known.

SPDX-License-Identifier: Apache-2.0
"""

from tools.reports.text_table import Table, shown

MILLION = 1e6


def _versions(report):
    return {row["program"]: row for row in report["programs"]}


def _part(value):
    """A share that is rarely anything but 0."""
    return "0" if value == 0 else f"{value:.2%}"


def programs(reports, *pairs):
    """A line for each pair and program, as exact ones first; behind them those that are absent or failed."""
    report = reports.get("align")
    entries = _versions(report)
    lines = []
    for pair in report["pairs"]:
        if pairs and pair["name"] not in pairs:
            continue
        lines.append([pair["name"], "before", *["-"] * 4, f"{pair['error']:.3f}", shown(pair["overlap"], ".3f"), "-", "-"])
        rows = sorted((row for row in report["rows"] if row["pair"] == pair["name"]), key=lambda row: row["error"])
        for row in rows:
            version = entries[row["program"]]["version"]
            lines.append([
                pair["name"], f"{row['program']} {version}" + (" (stopped)" if row["stopped"] else ""),
                f"{row['voxels_per_s'] / MILLION:.2f}", f"{row['seconds']:.2f}", f"{row['evaluations']:,}", str(row["runs"]),
                f"{row['error']:.3f}", shown(row["overlap"], ".3f"), _part(row["folds"]), f"{row['peak_mb']:,.0f}"])
    for row in report["programs"]:
        if row["absent"]:
            lines.append(["-", f"{row['program']}: {row['absent']}", *["-"] * 8])
    for row in report["failed"]:
        lines.append([row["pair"], f"{row['program']}: {row['why']}", *["-"] * 8])
    return Table(["pair", "program", "million voxel evaluations per second", "seconds", "evaluations", "runs",
                  "error, voxels", "overlap", "folds", "memory, MB"], lines)


def bits(reports):
    """For each program how many bits of the field differ from those of one thread."""
    rows = reports.get("align")["bits"]
    names = list(dict.fromkeys(name for row in rows for name in row["differing"]))
    return Table(["program", "bits of the field", *names], [
        [row["program"], f"{row['of']:,}", *(shown(row["differing"].get(name), ",") for name in names)] for row in rows])


def aims(reports):
    """What was aimed at and what was reached; a missed aim says so."""
    return Table(["pair", "aim", "wanted", "reached", ""], [
        [row["pair"], row["aim"], f"{row['wanted']:g}", f"{row['value']:,.3g}", "yes" if row["reached"] else "missed"]
        for row in reports.get("align")["aims"]])


def settings(reports):
    """How each program is called, where it differs, and how its evaluations are counted."""
    return Table(["program", "version", "optimiser", "evaluations are counted by", "differs in"], [
        [row["program"], row["version"] or "absent", row["optimiser"], row["counted"], row["differs"] or "-"]
        for row in reports.get("align")["programs"]])


def core(reports):
    """What a core would take for the two halves of an evaluation."""
    estimate = reports.get("align")["core"]
    return Table(["half", "core", "MHz", "routed", "clocks", "ms"], [
        [half["what"], f"`{half['top']}` {half['name']}", f"{half['mhz']:.1f}", shown(half["routed"]),
         f"{half['clocks']:,.0f}", f"{1e3 * half['seconds']:.2f}"] for half in estimate["halves"]])


def printed(reports):
    report = reports.get("align")
    estimate = report["core"]
    counts = " x ".join(map(str, estimate["counts"]))
    return "\n\n".join([
        f"{report['processor']}, one core; at most {report['iterations']} iterations a level",
        programs(reports).text(), bits(reports).text(), aims(reports).text(), settings(reports).text(),
        f"An estimate: positions and transpose of {counts} voxels in cores, without the images, "
        f"{estimate['voxels_per_s'] / MILLION:.1f} million voxels a second\n\n{core(reports).text()}"])


def _subjects(report):
    return {row["program"] for row in report["programs"] if row["hwffd"]}


def _missed(reports):
    return sum(not row["reached"] for row in reports.get("align")["aims"])


def _differing(ours):
    def figure(reports):
        report = reports.get("align")
        rows = [row for row in report["bits"] if (row["program"] in _subjects(report)) == ours]
        return sum(sum(row["differing"].values()) for row in rows)
    return figure


def missing(reports):
    """What is committed has every pair, program and comparison of bits."""
    report = reports.get("align")
    measured = {row["program"] for row in report["rows"]}
    absent = [row["program"] for row in report["programs"] if row["absent"] or row["program"] not in measured]
    absent += [f"{row['program']} on {row['pair']}" for row in report["failed"]
               if row["program"] in _subjects(report) & measured]
    if absent:
        return f"{', '.join(absent)}"
    return "" if len(report["pairs"]) > 1 and report["bits"] else "pairs or bits"


TABLES = {"programs": programs, "bits": bits, "aims": aims, "settings": settings, "core": core}
FIGURES = {
    "missed": _missed, "aims": lambda reports: len(reports.get("align")["aims"]),
    "differing": _differing(True), "others_differing": _differing(False),
    "core_rate": lambda reports: reports.get("align")["core"]["voxels_per_s"] / MILLION,
}
