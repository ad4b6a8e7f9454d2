"""The program: options, the folder, what it says, and its status.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import re
import shlex
import sys

from tools import command_line
from tools.csv_table import TableError
from tools.standalone import configuration, folder, mapping, reserved, simulation
from tools.tables import configurations, features, gone

MOST_LETTERS = 41  # of the prefix

_EXAMPLES = """examples:
  hwffd core --org walk --format fx17 -o my_ffd
  hwffd core --org cg1 --format fx18 --axis 8 --features resident+pages --pages 4 -o small
  hwffd core --row factored3-fx18-overlapped --top hwffd_axi --prefix deformer -o deformer
"""


def _number(text):
    if not re.fullmatch("[0-9]{1,10}", text):
        raise argparse.ArgumentTypeError(f"'{text}' is no number")
    return int(text)


def _evaluator(text):
    one = gone.find("evaluator", text)
    if one:
        raise argparse.ArgumentTypeError(str(one))
    return text


class _Parser(argparse.ArgumentParser):
    def error(self, message):
        raise command_line.Request(f"{message}; see {self.prog} --help")


def parser(prog):
    arguments = _Parser(
        prog=prog, description="Writes a core of one configuration into a folder that needs nothing else: one Verilog "
        "file, a testbench with expected results, a data sheet, constraints, and the bit-true model as a C++ header.",
        epilog=_EXAMPLES, formatter_class=argparse.RawDescriptionHelpFormatter)
    add = arguments.add_argument
    add("-o", "--output", required=True, metavar="FOLDER", help="folder to write; it must not be there, or be empty")
    add("--prefix", help="name of the top, and in front of its modules (default: that of the folder)")
    add("--top", choices=configuration.TOPS, default=configuration.TOPS[0], help="default: %(default)s")
    add("--row", metavar="NAME", help="a row of the table of configurations, which other options change")
    add("--org", help=f"organization, such as walk or factored/3 (default: {configuration.DEFAULT_ORG})")
    add("--format", help="number format: fp32, bfp32, or fx12 to fx32 (default: that of the organization's first "
        "overlapped row)")
    add("--n", type=_number, help="control points taken in one clock, where the organization has a choice")
    add("--schedule", choices=configurations.SCHEDULES)
    add("--evaluator", type=_evaluator, choices=configurations.EVALUATORS)
    for name in ("mul", "add", "fma", "convert"):
        add(f"--{name}-latency", type=_number, metavar="CLOCKS")
    add("--features", metavar="NAMES", help=f"what is built, + between: some of {', '.join(features.BITS)} "
        f"(default: {configuration.DEFAULT_FEATURES}, and what other options want)")
    add("--axis", type=_number, help="points an axis of a resident lattice, at most")
    add("--pages", type=_number, help="resident lattices")
    add("--spans", type=_number, help="runs of cells with blending functions of their own")
    add("--data-width", type=_number, help="bits of the bus of hwffd_stream_bus or of the DMA: 64, 128 or 256")
    add("--set", action="append", default=[], metavar="NAME=NUMBER", help="any other parameter of the top")
    add("--map", choices=mapping.TARGETS, help="maps the core by yosys, and says its size on that target in the data sheet")
    add("--simulate", action="store_true", help="runs the testbench in Icarus, and says the latency in the data sheet")
    add("--vertices", type=_number, default=1000, help="of the testbench (default: %(default)s)")
    return arguments


def _prefix(options):
    """A name that modules can have. Raises Refused."""
    name = options.prefix or re.sub(r"[\W_]+", "_", pathlib.Path(options.output).resolve().name).strip("_")
    # Verilator keeps two _ in a row, which an end in one would make, for itself.
    if not re.fullmatch("[a-z](_?[a-z0-9])*", name) or len(name) > MOST_LETTERS or name.startswith("error_"):
        raise configuration.Refused(f"--prefix {name}: at most {MOST_LETTERS} lower case letters, digits and single _ between "
                                    "them wanted, a letter first and not error_")
    if name in reserved.WORDS:
        raise configuration.Refused(f"--prefix {name}: a word of Verilog, VHDL or C++; take another one")
    return name


def run(words, prog):
    options = parser(prog).parse_args(words)
    folder.check(options.output)
    options.prefix = _prefix(options)
    options.command_line = " ".join(shlex.join(["hwffd", "core", *words]).split())  # a line, whatever the folder
    if not 1 <= options.vertices <= 100_000:
        raise configuration.Refused(f"--vertices {options.vertices}: 1 to 100000 wanted")
    mapping.check(options.map)
    simulation.check(options.simulate)
    core = configuration.core(options)
    texts = folder.files(core, options.vertices, options.map, options.simulate)
    folder.write(options.output, texts)
    print(f"{options.output}: {core.top}, {core.organization.name} in {core.number_format.name}, "
          f"{'+'.join(core.has)}: {', '.join(texts)}")
    return 0


def main(words=None, prog="hwffd core"):
    """The program; its exit status."""
    return command_line.ended(prog, lambda: run(sys.argv[1:] if words is None else words, prog), (TableError,))
