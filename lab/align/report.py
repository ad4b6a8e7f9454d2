"""align.json: what was measured, in one form, and what of it does not hold.

SPDX-License-Identifier: Apache-2.0
"""

import statistics

from lab.align import measures

FIELDS = ("program", "pair", "evaluations", "voxel_evaluations", "seconds", "voxels_per_s", "all_s", "peak_mb", "error",
          "overlap", "folds", "runs", "stopped")


def of_pair(pair, spacing, levels):
    """What a pair is before anything has been aligned."""
    still = 0 * pair.truth
    return {"name": pair.name, "counts": list(pair.fixed.shape[::-1]), "spacing": spacing, "levels": levels,
            "body_voxels": int(pair.body.sum()), "error": measures.error(still, pair),
            "overlap": measures.overlap(still, pair)}


def of_program(program):
    """Version and remarks of a program, whether it is there or not."""
    return {"program": program.name, "package": program.package, "optimiser": program.optimiser,
            "counted": program.counted, "differs": program.differs,
            "hwffd": program.hwffd, "rate_aim": program.rate_aim, "version": None, "absent": None}


def row(program, pair, runs, field):
    """Of the runs of a program on a pair the median, and what its field is worth."""
    def middle(name):
        return statistics.median(run[name] for run in runs)
    seconds = middle("seconds")
    return {"program": program.name, "pair": pair.name, "evaluations": runs[0]["evaluations"],
            "voxel_evaluations": runs[0]["voxel_evaluations"], "seconds": seconds,
            "voxels_per_s": runs[0]["voxel_evaluations"] / seconds if seconds else None,
            "all_s": middle("all_s"), "peak_mb": middle("peak_mb"), "share": min(run["share"] for run in runs),
            "error": measures.error(field, pair), "overlap": measures.overlap(field, pair),
            "folds": measures.folds(field), "runs": len(runs), "stopped": any(run["stopped"] for run in runs)}


def bits(program, pair, fields):
    """Differing bits of fields beside the first, which is of one thread; fields: name -> field."""
    (_, first), *others = fields.items()
    return {"program": program.name, "pair": pair.name, "of": int(first.nbytes * 8),
            "differing": {name: measures.differing_bits(first, field) for name, field in others}}


def aims(report):
    """What is aimed at, for each pair that hwffd and others were given whole: what was reached, and whether it holds."""
    subjects = {row["program"] for row in report["programs"] if row["hwffd"]}
    reference = next(row["program"] for row in report["programs"] if row["hwffd"])
    rows, lines = report["rows"], []
    for pair in report["pairs"]:
        results = {row["program"]: row for row in rows if row["pair"] == pair["name"]}
        others = [row for name, row in results.items() if name not in subjects and not row["stopped"]]
        best = min(others, key=lambda row: row["error"], default=None)
        for name, row in results.items():
            if best and name in subjects:
                lines.append({"pair": pair["name"], "aim": f"error of {name} by that of {best['program']}, the best of the others",
                              "value": row["error"] / best["error"], "wanted": 1.0,
                              "reached": row["error"] <= best["error"]})
        for program in report["programs"]:
            mine, other, times = results.get(reference), results.get(program["program"]), program["rate_aim"]
            if times and mine and other:
                value = mine["voxels_per_s"] / other["voxels_per_s"]
                lines.append({"pair": pair["name"], "aim": f"times the rate of {program['program']}", "value": value,
                              "wanted": times, "reached": value >= times})
    for entry in report["bits"]:
        if entry["program"] in subjects:
            value = sum(entry["differing"].values())
            lines.append({"pair": entry["pair"], "aim": f"differing bits of {entry['program']}", "value": value, "wanted": 0,
                          "reached": value == 0})
    return lines


def faults(report):
    """What is missing or cannot be, a line each. A missed aim is no fault: it stands in the report as missed."""
    lines = []
    absent = {row["program"] for row in report["programs"] if row["absent"]}
    measured = {row["program"] for row in report["rows"]}
    for entry in report["programs"]:
        if entry["program"] not in absent | measured:
            lines.append(f"{entry['program']}: neither measured nor said to be absent")
    if not any(row["program"] in measured for row in report["programs"] if row["hwffd"]):
        lines.append("hwffd has not been measured")
    before = {pair["name"]: pair["error"] for pair in report["pairs"]}
    for entry in report["rows"]:
        what = f"{entry['program']}, {entry['pair']}"
        if set(FIELDS) - set(entry):
            lines.append(f"{what}: no {', '.join(sorted(set(FIELDS) - set(entry)))}")
        elif not entry["evaluations"] > 0 or not entry["seconds"] > 0:
            lines.append(f"{what}: {entry['evaluations']} evaluations in {entry['seconds']} s")
        elif not entry["stopped"] and not entry["error"] < before[entry["pair"]]:
            lines.append(f"{what}: an error of {entry['error']:.3f} voxels, and {before[entry['pair']]:.3f} before")
    return lines
