"""build/reports/formal.json and formal.md: which properties are proved.

SPDX-License-Identifier: Apache-2.0
"""

import json

import proofs
from synth_report import table

NOT_RUN = "not run"


def collect(work, everything, verdicts, failed):
    """A dictionary a property, in the table's order; verdicts of earlier runs are used."""
    shown = []
    for one in everything:
        verdict = verdicts.get(one)
        if verdict is None and one not in failed:
            try:
                verdict = work.result(one)
            except proofs.ProofError as error:
                failed = {**failed, one: str(error)}
        row = {
            "module": one.module, "name": one.name, "statement": one.statement,
            "result": NOT_RUN, "negative_control": NOT_RUN, "seconds": None,
            "harness": f"tests/formal/{one.harness}.v", "parameters": one.parameters,
            "method": one.method, "lemmas": one.lemmas.split(),
            "planted_bug": {"module": one.file, "original": one.original, "mutant": one.mutant},
        }
        if one in failed:
            row.update(result="error", negative_control="error", complaint=failed[one])
        elif verdict is not None:
            row.update({name: value for name, value in verdict.items() if name != "key"})
        shown.append(row)
    results = {(row["module"], row["name"]): row["result"] for row in shown}
    for row in shown:
        for lemma in row["lemmas"]:
            if row["result"] == proofs.PROVED and results[row["module"], lemma] != proofs.PROVED:
                row["result"] = f"lemma {lemma} is not proved"
    return shown


def complaint(row):
    """What is wrong with a property; '' if nothing."""
    if "complaint" in row:
        return row["complaint"]
    if row["result"] != proofs.PROVED:
        return row["result"]
    if row["negative_control"] != proofs.REFUTED:
        return f"the planted bug is not found ({row['negative_control']})"
    return ""


def write(work, everything, verdicts, failed, folder):
    """Writes both files and returns the rows."""
    shown = collect(work, everything, verdicts, failed)
    proofs.write(folder / "formal.json", json.dumps({
        "tool": work.version, "limit_seconds": work.limit, "properties": shown}, indent=1) + "\n")
    good = sum(not complaint(row) for row in shown)
    lines = [
        "# Formal proofs\n",
        f"{good} of {len(shown)} properties are proved for runs of any length, each with"
        " a planted bug that the same proof refutes.\n",
        table(["module", "property", "parameters", "method", "result", "planted bug", "seconds",
               "statement"],
              [[f"`{row['module']}`", row["name"], row["parameters"] or "-",
                row["method"], row["result"], row["negative_control"],
                "-" if row["seconds"] is None else row["seconds"], row["statement"]]
               for row in shown], left=8),
    ]
    broken = [row for row in shown if complaint(row)]
    if broken:
        lines.append("\n" + "\n".join(
            f"* Failed: {row['module']}, {row['name']}: {complaint(row)}" for row in broken))
    proofs.write(folder / "formal.md", "\n".join(lines) + "\n")
    return shown
