"""Every row of bad_parameters.csv stops Verilator, Icarus and yosys alike, at the module's own
named error, and every such error in the RTL has a row; the same module with its defaults passes all
three.

A row is module,parameter,value; parameters that are bad only together are joined by ';', as are
their values.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures
import csv
import os
import pathlib
import re
import sys
import tempfile
import unittest

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent.parent / "scripts"))

import organizations  # noqa: E402
import rtl  # noqa: E402

SOURCES = rtl.Sources()
TABLE = HERE / "bad_parameters.csv"
TOP = "bad_parameters_top"
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
        verilator = [word for word in rtl.verilator(SOURCES, TOP, files) if word != "-Wall"]
        return {
            "verilator": rtl.run(verilator + ["-Wno-fatal", "-Wno-lint"]),
            "icarus": rtl.run([w for w in rtl.icarus(SOURCES, TOP, files) if w != "-Wall"]),
            "yosys": rtl.run(yosys_hierarchy(files)),
        }


def yosys_hierarchy(files):
    sources = " ".join(f'"{path}"' for path in files)
    folders = " ".join(f"-I {folder}" for folder in SOURCES.includes)
    script = f"read_verilog {folders} {sources}; hierarchy -check -top {TOP}"
    return ["yosys", "-Q", "-T", "-q", "-p", script]


def guards_of_sources():
    """The name of every guard in the RTL."""
    return {guard for path in SOURCES.files.values()
            for guard in GUARD.findall(rtl.strip_comments(path.read_text()))}


# What no organization takes, where it has the parameter: N above 64, an unknown schedule or folding.
OF_ORGANIZATIONS = (("N", "65"), ("SCHEDULE", "2"), ("SCHEDULE", "-1"), ("FOLD", "2"))


def shared_rows():
    """The same for each module of an organization."""
    modules = dict.fromkeys(f"ffd_org_{one.module}" for one in organizations.read().values())
    return [(module, [name], [value]) for module in modules for name, value in OF_ORGANIZATIONS
            if re.search(rf"\bparameter {name}\b", SOURCES.whole(module))]


def read_table():
    with TABLE.open(newline="") as file:
        rows = [(row["module"], row["parameter"].split(";"), row["value"].split(";"))
                for row in csv.DictReader(file)]
    return rows + shared_rows()


class BadParameters(unittest.TestCase):
    def test_table(self):
        rows = read_table()
        self.assertTrue(rows)
        for module, names, values in rows:
            self.assertIn(module, SOURCES.files, "not in rtl/hwffd.f")
            self.assertEqual(len(names), len(values), f"{module}: {names} and {values}")
        modules = list(dict.fromkeys(module for module, _, _ in rows))
        cases = [(module, list(zip(names, values))) for module, names, values in rows]
        cases += [(module, []) for module in modules]
        with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
            results = list(pool.map(lambda case: elaborate(*case), cases))
        right = 0
        seen = {}
        for (module, assignments), result in zip(cases, results):
            for tool, (status, output) in result.items():
                with self.subTest(module=module, assignments=assignments, tool=tool):
                    if assignments:
                        self.assertNotEqual(status, 0, "accepted")
                        self.assertIn(f"ERROR_{module}_", output)
                    else:
                        self.assertEqual((status, "ERROR_" in output), (0, False), output)
                    right += 1
                seen.setdefault(tool, set()).update(GUARD.findall(output))
        for tool, guards in seen.items():
            self.assertEqual(guards_of_sources() - guards, set(), f"never seen with {tool}")
        print(f"bad parameters: {len(rows)} rows to refuse and {len(modules)} defaults to accept, "
              f"{right} of {3 * len(cases)} verdicts of 3 tools right")

    def test_a_legal_value_is_not_refused(self):
        """The harness itself can tell: a legal value is accepted by all three."""
        for tool, (status, output) in elaborate("ffd_num_delay", [("LATENCY", "3")]).items():
            self.assertEqual((tool, status), (tool, 0), output)


if __name__ == "__main__":
    unittest.main(verbosity=2)
