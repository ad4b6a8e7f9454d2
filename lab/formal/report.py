"""build/reports/formal.json and formal.md: which properties are proved.

SPDX-License-Identifier: Apache-2.0
"""

import json

from lab.figures.studies import formal as tables
from lab.formal import proofs
from tools import whole_file
from tools.reports.results import Results

NOT_RUN = "not run"


def collect(work, everything, verdicts, failed):
    """A dictionary a property, in the table's order; verdicts of earlier runs are used."""
    shown = []
    for prop in everything:
        verdict = verdicts.get(prop)
        if verdict is None and prop not in failed:
            try:
                verdict = work.result(prop)
            except proofs.ProofError as error:
                failed = {**failed, prop: str(error)}
        row = {
            "module": prop.module, "name": prop.name, "statement": prop.statement,
            "result": NOT_RUN, "negative_control": NOT_RUN, "seconds": None,
            "harness": f"lab/formal/{prop.harness}.v", "parameters": prop.parameters,
            "method": prop.method, "lemmas": prop.lemmas.split(),
            "planted_bug": {"module": prop.file, "original": prop.original, "mutant": prop.mutant},
        }
        if prop in failed:
            row.update(result="error", negative_control="error", complaint=failed[prop])
        elif verdict is not None:
            row.update(verdict)
        shown.append(row)
    results = {(row["module"], row["name"]): row["result"] for row in shown}
    for row in shown:
        for lemma in row["lemmas"]:
            if row["result"] == proofs.PROVED and results[row["module"], lemma] != proofs.PROVED:
                row["result"] = f"lemma {lemma} is not proved"
    return shown


def write(work, everything, verdicts, failed, folder):
    """Writes both files and returns the rows."""
    shown = collect(work, everything, verdicts, failed)
    whole_file.write(folder / "formal.json", json.dumps({
        "tool": work.version, "limit_seconds": work.limit, "properties": shown}, indent=1) + "\n")
    whole_file.write(folder / "formal.md", tables.document(Results(work.root)))
    return shown
