"""Every row of bad_parameters.csv stops Verilator, Icarus and yosys alike, at the module's own
named error, or that of an organization by that of another which it is made of, and every such error
in the RTL has a row; the same module with its defaults passes all three.

make test takes every sixteenth row; test-all takes all, and looks whether they meet every guard.

A row is module,parameter,value; parameters that are bad only together are joined by ';', as are
their values. A value of FEATURES is by its names, where its bits have some.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures
import csv
import os
import pathlib
import re
import tempfile

import pytest

from tools.project_root import ROOT
from tools.rtl import rtl_sources
from tools.tables import features, organizations

SOURCES = rtl_sources.Sources()
TABLE = ROOT / "tests" / "lint" / "bad_parameters.csv"
TOP = "bad_parameters_top"
TOOLS = ("verilator", "icarus", "yosys")
GUARD = re.compile(r"\bERROR_\w+")


def elaborate(module, assignments):
    """{tool: (status, output)} of an instance of `module` and nothing else."""
    values = ", ".join(f".{name}({value})" for name, value in assignments)
    parameters = f" #({values})" if values else ""
    with tempfile.TemporaryDirectory() as folder:
        top = pathlib.Path(folder) / f"{TOP}.v"
        top.write_text(f"module {TOP};\n  {module}{parameters} u_dut ();\nendmodule\n")
        files = SOURCES.needed(module) + [str(top)]
        # Open ports are no fault here, and warnings about them would hide what is looked for.
        verilator = [word for word in rtl_sources.verilator(SOURCES, TOP, files) if word != "-Wall"]
        return {
            "verilator": rtl_sources.run(verilator + ["-Wno-fatal", "-Wno-lint"]),
            "icarus": rtl_sources.run([w for w in rtl_sources.icarus(SOURCES, TOP, files) if w != "-Wall"]),
            "yosys": rtl_sources.run(yosys_hierarchy(files)),
        }


def yosys_hierarchy(files):
    sources = " ".join(f'"{path}"' for path in files)
    folders = " ".join(f"-I {folder}" for folder in SOURCES.includes)
    script = f"read_verilog {folders} {sources}; hierarchy -check -top {TOP}"
    return ["yosys", "-Q", "-T", "-q", "-p", script]


def own(module, guard):
    """Whether a guard is of the module; organizations leave checks to each other."""
    return guard.startswith(f"ERROR_{'ffd_org' if module.startswith('ffd_org_') else module}_")


def guards_of_sources():
    """The name of every guard in the RTL."""
    return {guard for path in SOURCES.files.values()
            for guard in GUARD.findall(rtl_sources.strip_comments(path.read_text()))}


# What no organization takes, where it has the parameter: N above 64, an unknown schedule or folding.
OF_ORGANIZATIONS = (("N", "65"), ("SCHEDULE", "2"), ("SCHEDULE", "-1"), ("FOLD", "5"))


def shared_rows():
    """The same for each module of an organization."""
    modules = dict.fromkeys(f"ffd_org_{organization.module}" for organization in organizations.read().values())
    return [(module, [name], [value]) for module in modules for name, value in OF_ORGANIZATIONS
            if re.search(rf"\bparameter {name}\b", SOURCES.whole(module))]


def read_table():
    with TABLE.open(newline="") as file:
        rows = [(row["module"], row["parameter"].split(";"), row["value"].split(";"))
                for row in csv.DictReader(file)]
    return [(module, names, [value if value[-1].isdigit() else str(features.value(value, TABLE)) for value in values])
            for module, names, values in rows] + shared_rows()


ROWS = read_table()
CASES = [(module, tuple(zip(names, values))) for module, names, values in ROWS]
CASES += [(module, ()) for module in dict.fromkeys(module for module, _, _ in ROWS)]
WHOLE = bool(os.environ.get("HWFFD_WHOLE"))
TRIED = CASES if WHOLE else CASES[::16]


@pytest.fixture(scope="module")
def results():
    """(module, assignments) -> {tool: (status, output)}"""
    with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        return dict(zip(TRIED, pool.map(lambda case: elaborate(*case), TRIED)))


def test_table():
    assert len(set(CASES)) == len(CASES) > len({module for module, _, _ in ROWS})
    for module, names, values in ROWS:
        assert module in SOURCES.files and len(names) == len(values), (module, names, values)


@pytest.mark.parametrize("tool", TOOLS)
@pytest.mark.parametrize("case", TRIED, ids=str)
def test_verdict(results, case, tool):
    status, output = results[case][tool]
    if case[1]:
        assert status != 0, "accepted"
        assert any(own(case[0], guard) for guard in GUARD.findall(output)), output
    else:
        assert (status, "ERROR_" in output) == (0, False), output


@pytest.mark.whole
@pytest.mark.parametrize("tool", TOOLS)
def test_every_guard_is_seen(results, tool):
    seen = {guard for by_tool in results.values() for guard in GUARD.findall(by_tool[tool][1])}
    assert guards_of_sources() - seen == set()


def test_a_legal_value_is_not_refused():
    """The harness itself can tell: a legal value is accepted by all three."""
    for tool, (status, output) in elaborate("ffd_num_delay", [("LATENCY", "3")]).items():
        assert (tool, status) == (tool, 0), output
