"""The table of configurations, rtl/configurations.csv, for every program that needs it.

One row is one build of the core: an organization, a number format, a schedule, the latencies of the
units, the largest top, the smallest tier (sim, cover, test, all) in which it is verilated at its read port and the
smallest in which it is verilated with its streams, and its buses if it has them. This module is the one place that
knows which parameter of the RTL each column sets and how its words are numbered.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import re
import sys
from dataclasses import dataclass

from tools import csv_table
from tools.csv_table import TableError, write_if_changed
from tools.project_root import ROOT
from tools.tables import configuration_texts as texts, features, formats, gone, organizations
from tools.tables.organizations import Organization

TABLE = ROOT / "rtl" / "configurations.csv"

# The enumerations of the RTL's parameters: a word's place is its number, or the number stands with it.
# (Organizations have a table of their own, and names that went another, whose numbers stay free.)
SCHEDULES = ("overlapped", "paper")
EVALUATORS = {"pipelined": 0, "iterative": 1, "powers": 3}

# A tier includes those before it.
TIERS = ("sim", "cover", "test", "all")
# So does a top: the read port of the evaluator, the core with its streams, the core on its buses.
TOPS = ("evaluator", "stream", "axi")
NO_STREAMS = "none"  # the tier of the streams of a row that has none

COLUMNS = (
    "name", "org", "n", "format", "schedule", "evaluator", "mul_latency", "add_latency",
    "fma_latency", "convert_latency", "top", "tier", "stream_tier",
)
NUMBERS = {"n": range(1, 65), "mul_latency": range(1, 100), "add_latency": range(1, 100),
           "fma_latency": range(100), "convert_latency": range(100)}
WORDS = {"schedule": SCHEDULES, "evaluator": EVALUATORS, "top": TOPS, "tier": TIERS,
         "stream_tier": (*TIERS, NO_STREAMS)}


@dataclass(frozen=True)
class Configuration:
    name: str
    org: str
    n: int
    format: str
    schedule: str
    evaluator: str
    mul_latency: int
    add_latency: int
    fma_latency: int
    convert_latency: int
    top: str
    tier: str
    stream_tier: str
    organization: Organization
    number_format: formats.Format

    @property
    def identifier(self):
        """The name as C, CMake and Verilator can use it; the class is V<identifier>."""
        return self.name.replace("-", "_")

    @property
    def stream(self):
        """Whether some tier has it with its streams."""
        return self.top != TOPS[0]

    @property
    def wide(self):
        """Whether so many float units work side by side that they want another way of building."""
        return self.number_format.words == "float" and (self.organization.units or self.n) >= 16

    @property
    def parameters(self):
        """Parameter of hwffd_stream -> value."""
        return {
            "ORG": self.organization.number,
            "N": self.n,
            "FORMAT": self.number_format.number,
            "SCHEDULE": SCHEDULES.index(self.schedule),
            "EVALUATOR": EVALUATORS[self.evaluator],
            "MUL_LATENCY": self.mul_latency,
            "ADD_LATENCY": self.add_latency,
            "FMA_LATENCY": self.fma_latency,
            "CONVERT_LATENCY": self.convert_latency,
        }

    @property
    def interval(self):
        """Clocks between vertices when steps overlap; of one cell, where an organization keeps one."""
        start = 3 if self.evaluator == "iterative" else 1
        return self.organization.formulas["overlapped"].value(n=self.n, start=start)

    def assignments(self):
        """["ORG=0", "N=1", ...]"""
        return [f"{name}={value}" for name, value in self.parameters.items()]


def _read_row(fields, where, known, known_formats):
    if not re.fullmatch(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", fields["name"]):
        raise TableError(f"{where}: bad name '{fields['name']}': lower case words joined by '-'")
    for column in gone.KINDS:
        gone.check(column, where, fields[column])
    organization = known[csv_table.word(fields, "org", where, known)]
    for column, words in WORDS.items():
        csv_table.word(fields, column, where, words)
    number_format = known_formats.find(fields["format"], where)
    for column, allowed in NUMBERS.items():
        fields[column] = csv_table.number(fields, column, where, allowed)
    if organization.n not in (None, fields["n"]):
        raise TableError(f"{where}: n is {fields['n']}, that of {organization.name} is "
                         f"{organization.n}")
    if organization.of_form.words == ("fixed",) and number_format.words != "fixed":
        raise TableError(f"{where}: format is {fields['format']}: {organization.name} is exact in "
                         "fixed point only")
    if fields["evaluator"] == "powers" and not (
            organization.weighs_axes and number_format.words == "fixed"):
        raise TableError(f"{where}: evaluator is powers: wants fixed point and an organization that "
                         "takes the four weights of an axis at once")
    if (fields["top"] == TOPS[0]) != (fields["stream_tier"] == NO_STREAMS):
        raise TableError(f"{where}: stream_tier is {fields['stream_tier']}, top is {fields['top']}: it is "
                         f"{NO_STREAMS} of a row that has no streams, and of no other")
    if (*TIERS, NO_STREAMS).index(fields["stream_tier"]) < TIERS.index(fields["tier"]):
        raise TableError(f"{where}: stream_tier is {fields['stream_tier']}, tier is {fields['tier']}: a row has "
                         "its streams in no tier that lacks its read port")
    if fields["fma_latency"] > 0 and not number_format.fused:
        raise TableError(f"{where}: fma_latency is {fields['fma_latency']}, 0 wanted: there is no "
                         f"fused multiply-add in {fields['format']}")
    return Configuration(**fields, organization=organization, number_format=number_format)


def read(path=TABLE):
    """The rows in order. Raises TableError."""
    known, known_formats = organizations.read(), formats.read()
    by_name = {}
    for where, fields in csv_table.read(path, COLUMNS):
        configuration = _read_row(fields, where, known, known_formats)
        csv_table.unique(by_name, configuration.name, "name", where)
        by_name[configuration.name] = configuration
    if not by_name:
        raise TableError(f"{path}: no configurations")
    return list(by_name.values())


def find(configurations, name):
    """The one of that name. Raises TableError."""
    for configuration in configurations:
        if configuration.name == name:
            return configuration
    gone.refuse(name)
    raise TableError(f"no configuration named '{name}': rtl/configurations.csv has them")


def of_tier(configurations, tier, top=TOPS[0]):
    """Those that are built with a top in a tier: its own and those of the smaller ones.

    The tier `cover` has its rows with their streams, whatever the column says: what counts there is each line.
    """
    built = TIERS[: TIERS.index(tier) + 1]
    column = "tier" if top == TOPS[0] or tier == "cover" else "stream_tier"
    tops = TOPS[TOPS.index(top):]
    return [c for c in configurations if getattr(c, column) in built and c.top in tops]


def select(configurations, org="", n="", fmt="", schedule=""):
    """Those of an organization, N, format and schedule, each perhaps empty: any. Raises TableError."""
    for column, wanted in (("org", org), ("n", n), ("format", fmt), ("schedule", schedule)):
        if not wanted:
            continue
        known = list(dict.fromkeys(str(getattr(c, column)) for c in configurations))
        configurations = [c for c in configurations if str(getattr(c, column)) == wanted]
        if not configurations:
            gone.refuse(wanted)
            raise TableError(f"{column.upper()}={wanted}: unknown here: one of {', '.join(known)}")
    return configurations


def add_selection(parser):
    """The options that `selected` reads."""
    for column in ("org", "n", "format"):
        parser.add_argument(f"--{column}", default="", help="these rows only")


def evaluator_of(number):
    """The word of a value of the parameter EVALUATOR."""
    return next(word for word, own in EVALUATORS.items() if own == number)


def listed(configurations, options):
    """Those of the command `list`. Raises TableError."""
    rows = of_tier(configurations, options.tier, options.top)
    return select(rows, options.org, options.n, options.format, options.schedule)


def smallest_tier(configurations, options):
    """That which has a row of the command `tier`; all, if there is none. (`cover` is there to count lines.)"""
    for options.tier in (tier for tier in TIERS if tier != "cover"):
        try:
            if listed(configurations, options):
                return options.tier
        except TableError:
            pass
    return TIERS[-1]


def selected(configurations, options):
    return select(configurations, options.org, options.n, options.format)


def generated(rows, tier, wanted):
    """file -> what a build of a tier has of the table and of the rows selected. Raises TableError."""
    tiered, stream, axi = (of_tier(rows, tier, top) for top in TOPS)
    return {
        "configurations.cpp": texts.table_text(rows, organizations.read(), gone.read()),
        "models.cpp": texts.models_text(rows, organizations.read()),
        "stream_core_factory.cpp": texts.factory_text(stream, "stream"),
        "axi_core_factory.cpp": texts.factory_text(axi, "axi", "_axi"),
        "evaluator_core_factory.cpp": texts.factory_text(tiered, "evaluator", "_evaluator"),
        "selected_core_factory.cpp": texts.factory_text(wanted, "evaluator", "_evaluator"),
        "configurations.cmake": texts.cmake_text(rows, tiered, stream, axi, wanted),
    }


def parser():
    arguments = argparse.ArgumentParser(description="Reads the table of configurations.")
    arguments.add_argument("--table", default=TABLE, help="default: rtl/configurations.csv")
    commands = arguments.add_subparsers(dest="command", required=True, metavar="COMMAND")
    listing = commands.add_parser("list", help="print the names of a tier (default: all)")
    smallest = commands.add_parser("tier", help="print the smallest tier that has such rows")
    parameters = commands.add_parser("parameters", help="print the parameters of a core of a row, NAME=value ...")
    parameters.add_argument("name")
    styles = parameters.add_mutually_exclusive_group()
    styles.add_argument("--verilator", dest="prefix", action="store_const", const="-G",
                        help="as -GNAME=value ...")
    styles.add_argument("--fusesoc", dest="prefix", action="store_const", const="--",
                        help="as --NAME=value ...")
    parameters.set_defaults(prefix="")
    build = commands.add_parser("build", help="write what a build needs of the table into a folder")
    factory = commands.add_parser("factory", help="write the C++ that makes cores of some rows")
    models = commands.add_parser("models", help="write the C++ that makes models of some rows")
    for command in (build, factory, models):
        command.add_argument("out")
    for command in (factory, models):
        command.add_argument("--rows", nargs="+", metavar="NAME", required=True)
    factory.add_argument("--suffix", default="", help="of the models' names, such as _netlist")
    for command in (listing, build):
        command.add_argument("--tier", choices=TIERS, default="all")
    for command in (listing, smallest, build):
        add_selection(command)
    for command in (listing, smallest):
        command.add_argument("--schedule", default="", help="these rows only")
        command.add_argument("--top", choices=TOPS, default=TOPS[0], help="rows with at least this top")
    return arguments


def main(arguments=None):
    options = parser().parse_args(arguments)
    try:
        rows = read(options.table)
        if options.command == "list":
            for configuration in listed(rows, options):
                print(configuration.name)
        elif options.command == "tier":
            print(smallest_tier(rows, options))
        elif options.command == "parameters":
            of_core = features.of_top(features.CORES[0], find(rows, options.name).parameters)
            print(" ".join(f"{options.prefix}{name}={value}" for name, value in of_core.items()))
        elif options.command == "factory":
            write_if_changed(options.out, texts.factory_text(
                [find(rows, name) for name in options.rows], "stream", options.suffix))
        elif options.command == "models":
            write_if_changed(options.out, texts.models_text(
                [find(rows, name) for name in options.rows], organizations.read()))
        else:
            for name, text in generated(rows, options.tier, selected(rows, options)).items():
                write_if_changed(pathlib.Path(options.out) / name, text)
    except (TableError, OSError) as error:
        print(f"configurations: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
