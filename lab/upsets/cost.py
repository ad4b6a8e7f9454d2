"""What HARDENED costs: cells of a core on ECP5, mapped as `make synth` maps it.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures
import json
import tempfile

from lab.upsets import counted
from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.synth import mapped_netlist, synthesis, variants
from tools.tables import configurations

TARGET = "ecp5"


def subject(row, top, hardened):
    return synthesis.Subject(variants.Variant(row, "hardened" if hardened else "plain",
                                              (("HARDENED", int(hardened)),), ""), top, TARGET)


def counts(work, core):
    """{field: number} of a core. Raises UpsetError."""
    with tempfile.NamedTemporaryFile(suffix=".json") as out:
        status, output = rtl_sources.run(["yosys", "-Q", "-T", "-q", "-p",
                                          "; ".join([*work.script(core), f"json -o {out.name} *"])], work.root)
        if status:
            raise counted.UpsetError(f"yosys, {core}: {(output.strip().splitlines() or ['failed'])[-1]}")
        return mapped_netlist.count(TARGET, json.load(out), core.top)


def rows(row_name, tops, jobs, root=ROOT):
    """A line for each top, plain and hardened, with the row's own parameters."""
    work = synthesis.Synthesis(root)
    row = configurations.find(configurations.read(), row_name)
    wanted = [(top, hardened) for top in tops for hardened in (False, True)]
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        cells = list(pool.map(lambda core: counts(work, subject(row, *core)), wanted))
    lines = [{"top": top, "hardened": hardened, **number}
             for (top, hardened), number in zip(wanted, cells)]
    for plain, hardened in zip(lines[::2], lines[1::2]):
        if hardened["ff"] <= plain["ff"]:
            raise counted.UpsetError(f"{plain['top']}: HARDENED costs no flip-flop: its copies are gone")
    return lines
