"""Parts of the campaign, one for each top, make the report that one run makes: on stand-ins for the programs
that flip bits and for yosys.

SPDX-License-Identifier: Apache-2.0
"""

import json
import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[3]
# So many flips of an outcome that depends on the core, the kind of bits and the seed.
PROGRAM = """#!{python}
import sys, zlib
words = dict(zip(sys.argv[1::2], sys.argv[2::2]))
with open(words["--out"], "w") as out:
    print("# clocks 100 registers 8 memory_bits 64", file=out)
    print("clock,module,name,word,bit,outcome,recovered,restarted,outside_read", file=out)
    for flip in range(int(words["--flips"])):
        draw = zlib.crc32(f"{{sys.argv[0][-9:]}} {{words['--kind']}} {{words['--seed']}} {{flip}}".encode()) % 3
        print(f"{{flip}},ffd_{{draw}},u_x.q[{{flip}}],0,0,{{{outcomes}[draw]}},1,1,0", file=out)
"""
YOSYS = """#!{python}
import json, re, sys
if sys.argv[1] == "-V":
    sys.exit(print("Yosys 1"))
flip_flop = {{"type": "TRELLIS_FF", "parameters": {{}}, "port_directions": {{}}, "connections": {{}}}}
hardened = "HARDENED 1" in sys.argv[-1]
top = re.search(r"-top (\\w+)", sys.argv[-1])[1]
json.dump({{"modules": {{top: {{"cells": {{str(n): flip_flop for n in range(2 + hardened)}}}}}}}},
          open(re.search(r"json -o (\\S+)", sys.argv[-1])[1], "w"))
"""
GOOD, BAD = ("no_effect", "flagged", "silent"), ("no_effect", "flagged", "hang_stuck")
TOPS = (("stream", "stream-hardened"), ("axi", "axi-hardened"))


@pytest.fixture(name="study")
def _study(checkout):
    """Runs the study: (exit status, complaints, report)"""
    def programs(outcomes):
        for name in (name for top in TOPS for name in top):
            checkout.put({f"programs/hwffd-upsets-{name}": PROGRAM.format(python=sys.executable, outcomes=outcomes)},
                         0o755)

    def run(*words, outcomes=GOOD):
        programs(outcomes)
        report = checkout.root / "reports" / "upsets.json"
        report.unlink(missing_ok=True)
        status, _, errors = checkout.run(
            sys.executable, "-B", ROOT / "studies" / "upsets", "--programs", "programs", "--output", ".", "--flips",
            "12", *words, env={**os.environ, "PATH": f"{checkout.root}/bin:{os.environ['PATH']}"})
        said = [line for line in errors.splitlines() if "flips in" not in line and "costs" not in line]
        return status, said, json.loads(report.read_text()) if report.exists() else None

    checkout.put({"bin/yosys": YOSYS.format(python=sys.executable)}, 0o755)
    return run


def measured(study, **more):
    """A part of each top."""
    for names in TOPS:
        cores = [word for name in names for word in ("--core", name)]
        assert study(*cores, "--part", f"{names[0]}.json", **more) == (0, [], None)
    return [f"{names[0]}.json" for names in TOPS]


def test_joined_parts_are_the_report_of_one_run(study):
    whole = study()
    assert whole[:2] == (0, []) and len(whole[2]["rows"]) == 8 and len(whole[2]["cost"]) == 4
    assert sum(row["flips"] for row in whole[2]["rows"]) == 96
    assert study("--join", *measured(study)) == whole


def test_who_joins_judges(study):
    whole = study(outcomes=BAD)
    assert whole[0] == 1 and len(whole[1]) == 4
    assert study("--join", *measured(study, outcomes=BAD)) == whole


def test_parts_that_make_no_report_are_refused(study, checkout):
    stream, axi = measured(study)
    checkout.put({"seed.json": checkout.text(axi).replace('"seed": 1', '"seed": 2'),
                  "flips.json": checkout.text(axi).replace('"flips": 12', '"flips": 13')})
    for names, said in (((stream,), "parts have 4 rows, not each kind of bits of each core once"),
                        ((stream, stream), "parts have 8 rows"),
                        ((stream, "seed.json"), "parts differ in seed: 1, 2"),
                        ((stream, "flips.json"), "parts differ in flips: 12, 13"),
                        ((stream, "gone.json"), "gone.json: no part: ")):
        status, (complaint,), report = study("--join", *names)
        assert status == 1 and report is None and said in complaint
