"""What tests of standalone cores share: cores drawn at random, their folders, and the tools that read them.

SPDX-License-Identifier: Apache-2.0
"""

import random
import re
import subprocess

from pyslang import driver

from tools.rtl import rtl_sources
from tools.standalone import configuration, folder, words
from tools.tables import configuration_texts as texts, configurations, formats, parameter_draws, parameter_space

UNITS = 30  # multipliers of a drawn core, at most: Icarus runs it in seconds
PASSED = re.compile(r"PASS (\d+) vertices, (\d+) results, (\d+) clocks, (?:latency (\d+)|(\d+) packets)\n")


def run(*words, cwd=None):
    """(exit status, all that it printed)"""
    result = subprocess.run([str(word) for word in words], cwd=cwd, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                            stderr=subprocess.STDOUT, text=True, check=False)
    return result.returncode, result.stdout


def drawn(seed, top="hwffd_stream", prefix="drawn"):
    """A core of a legal configuration that has a model; the same for the same seed."""
    space = parameter_space.Space()
    kinds = {texts.model_kind(row.organization, row.number_format, row.fma_latency, row.evaluator)
             for row in configurations.read()}
    known = sorted({kind[1].number for kind in kinds} & {of.number for of in formats.read().by_name.values()})
    draw = parameter_draws.Draw(space, top, random.Random(seed), UNITS, known)
    while True:
        parameters = draw.legal(**({"RESULT_WIDTH": 128} if top == "hwffd_stream" else {}))
        organization = space.organizations[parameters["ORG"]]
        evaluator = configurations.evaluator_of(parameters["EVALUATOR"])
        kind = texts.model_kind(organization, space.formats[parameters["FORMAT"]], parameters["FMA_LATENCY"], evaluator)
        modelled = kind in kinds and (organization.weighs_axes or evaluator != "powers") and not parameters.get("BESIDE")
        if modelled and parameters.get("BUS_TIMEOUT", 0) not in range(1, configuration.LEAST_TIMEOUT):
            return configuration.of_parameters(space, top, prefix, parameters, f"number {seed}")


def numbers(output):
    """Those of the line of a testbench that passes."""
    return tuple(int(number) for number in PASSED.search(output).groups() if number is not None)


class Folder:
    """That of a core."""

    def __init__(self, core, path, vertices):
        self.core, self.path, self.prefix = core, path, core.prefix
        self.vertices = vertices
        folder.write(path, folder.files(core, vertices))

    def text(self, ending):
        return (self.path / f"{self.prefix}{ending}").read_text(encoding="utf-8")

    def simulated(self, testbench=None, sources=None, name="run"):
        """(exit status, what Icarus printed), of its testbench or of another text of one."""
        files = [self.path / f"{self.prefix}.v"] if sources is None else sources
        bench = self.path / f"{name}_tb.v"
        bench.write_text(self.text("_tb.v") if testbench is None else testbench, encoding="utf-8")
        status, output = run("iverilog", "-g2005", "-s", f"{self.prefix}_tb", "-o", f"{name}.vvp", *files, bench,
                             cwd=self.path)
        assert (status, output) == (0, ""), output
        return run("vvp", "-N", f"{name}.vvp", cwd=self.path)

    def passed(self, **more):
        """(vertices, results, clocks, latency or packets) of a run that passes."""
        status, output = self.simulated(**more)
        assert status == 0 and PASSED.search(output), f"{self.core.parameters}\n{output}"
        return numbers(output)

    def units(self):
        """Commands and results as units of 16 bytes, whatever the bus; two files, the texts of which the check reads."""
        sample = words.sample(self.core, self.vertices)
        for name, units in ("commands", sample.commands), ("results", sample.results):
            (self.path / f"{name}.hex").write_text(words.hexadecimal(units, words.UNIT), encoding="utf-8")
        return len(sample.results)

    def with_parameters(self, top, parameters):
        """The testbench with another top, of these parameters."""
        values = ", ".join(f".{name}({value})" for name, value in parameters.items())
        text = self.text("_tb.v")
        before = f"  {self.prefix} u_core ("
        assert text.count(before) == 1
        return text.replace(before, f"  {top} #({values}) u_core (" if values else before)

    def lint(self, every):
        """Complaints of Verilator, Icarus, yosys and slang, each in Verilog-2005 and in SystemVerilog; without `every`
        Verilator and yosys read the core by itself in the one, and Verilator reads it below its testbench in the other."""
        core, bench = f"{self.prefix}.v", f"{self.prefix}_tb.v"
        commands = []
        for language, icarus, yosys in (rtl_sources.VERILOG.verilator, "-g2005", ""), ((), "-g2012", "-sv "):
            for top, files in (self.prefix, [core]), (f"{self.prefix}_tb", [core, bench]):
                if every or bool(language) == (top == self.prefix):
                    commands.append(["verilator_bin", "--lint-only", "--timing", "-Wall", *language, "--top-module", top, *files])
                commands.append(["iverilog", icarus, "-Wall", "-t", "null", "-s", top, *files])
            if every or language:
                commands.append(["yosys", "-Q", "-T", "-q", "-p",
                                 f"read_verilog {yosys}{core}; hierarchy -check -top {self.prefix}; proc; check -assert"])
        results = [(words, run(*words, cwd=self.path)) for words in commands]
        faults = [f"{' '.join(words)}: {output}" for words, (status, output) in results if status or output]
        for standard in "1364-2005", "1800-2017":
            slang = driver.Driver()
            slang.addStandardArgs()
            paths = " ".join(str(self.path / name) for name in (core, bench))
            read = (slang.parseCommandLine(f"slang -Werror --std {standard} --top {self.prefix}_tb {paths}")
                    and slang.processOptions() and slang.parseAllSources() and slang.runFullCompilation(True))
            faults += [] if read else [f"slang {standard} complains"]
        return faults


def whole_tree():
    """The sources of the project, as Icarus takes them."""
    sources = rtl_sources.Sources()
    return [f"-I{path}" for path in sources.includes] + sorted(map(str, set(sources.files.values())))
