#!/usr/bin/env python3
"""The table of configurations, rtl/configurations.csv, for every program that needs it.

One row is one build of hwffd_stream: an organization, a number format, a schedule, the latencies of
the units, and the smallest tier (sim, test, all) in which it is verilated. This module is the one
place that knows which parameter of the RTL each column sets and how its words are numbered.

SPDX-License-Identifier: Apache-2.0
"""

import argparse
import pathlib
import re
import sys
from dataclasses import dataclass

import organizations
import tables
from organizations import GENERATED, models_text, select_text
from tables import TableError

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "rtl" / "configurations.csv"

# The enumerations of the RTL's parameters: a word's place is its number. (Organizations have a table
# of their own.)
SCHEDULES = ("overlapped", "paper")
EVALUATORS = ("pipelined", "iterative", "bspline")

# A tier includes those before it.
TIERS = ("sim", "test", "all")

COLUMNS = (
    "name", "org", "n", "format", "schedule", "evaluator", "mul_latency", "add_latency",
    "fma_latency", "convert_latency", "stream", "tier",
)
NUMBERS = {"n": (1, 64), "mul_latency": (1, 99), "add_latency": (1, 99),
           "fma_latency": (0, 99), "convert_latency": (0, 99), "stream": (0, 1)}
FIXED_WIDTHS = range(12, 33)
BLOCK_WIDTH = 35  # of the words inside bfp32 (docs/numerics.md)


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
    stream: int
    tier: str
    org_number: int

    @property
    def identifier(self):
        """The name as C, CMake and Verilator can use it; the class is V<identifier>."""
        return self.name.replace("-", "_")

    @property
    def parameters(self):
        """Parameter of hwffd_stream -> value."""
        return {
            "ORG": self.org_number,
            "N": self.n,
            "FORMAT": format_number(self.format),
            "SCHEDULE": SCHEDULES.index(self.schedule),
            "EVALUATOR": EVALUATORS.index(self.evaluator),
            "MUL_LATENCY": self.mul_latency,
            "ADD_LATENCY": self.add_latency,
            "FMA_LATENCY": self.fma_latency,
            "CONVERT_LATENCY": self.convert_latency,
        }

    def assignments(self):
        """["ORG=0", "N=1", ...]"""
        return [f"{name}={value}" for name, value in self.parameters.items()]


def format_number(word):
    """fp32 is 0, fxW is W, bfp32 is 64 + its words' width; None for anything else."""
    if word == "fp32":
        return 0
    if word == "bfp32":
        return 64 + BLOCK_WIDTH
    match = re.fullmatch(r"fx([1-9][0-9]*)", word)
    return int(match.group(1)) if match and int(match.group(1)) in FIXED_WIDTHS else None


def _read_row(fields, where, known):
    if not re.fullmatch(r"[a-z][a-z0-9]*(-[a-z0-9]+)*", fields["name"]):
        raise TableError(f"{where}: bad name '{fields['name']}': lower case words joined by '-'")
    if fields["org"] not in known:
        raise TableError(f"{where}: unknown org '{fields['org']}': one of {', '.join(known)}")
    for column, words in (("schedule", SCHEDULES), ("evaluator", EVALUATORS), ("tier", TIERS)):
        if fields[column] not in words:
            raise TableError(
                f"{where}: unknown {column} '{fields[column]}': one of {', '.join(words)}")
    if format_number(fields["format"]) is None:
        raise TableError(f"{where}: unknown format '{fields['format']}': fp32, bfp32 or "
                         f"fx{FIXED_WIDTHS[0]} to fx{FIXED_WIDTHS[-1]}")
    for column, (low, high) in NUMBERS.items():
        if not re.fullmatch(r"[0-9]{1,4}", fields[column]):
            raise TableError(f"{where}: {column} is '{fields[column]}', a number wanted")
        fields[column] = int(fields[column])
        if not low <= fields[column] <= high:
            raise TableError(f"{where}: {column} is {fields[column]}, {low} to {high} wanted")
    organization = known[fields["org"]]
    if organization.n not in (None, fields["n"]):
        raise TableError(f"{where}: n is {fields['n']}, that of {organization.name} is "
                         f"{organization.n}")
    return Configuration(**fields, org_number=organization.number)


def read(path=TABLE):
    """The rows in order. Raises TableError."""
    known = organizations.read()
    found = {}
    for where, fields in tables.read(path, COLUMNS):
        configuration = _read_row(fields, where, known)
        if configuration.name in found:
            raise TableError(f"{where}: '{configuration.name}' is there twice")
        found[configuration.name] = configuration
    if not found:
        raise TableError(f"{path}: no configurations")
    return list(found.values())


def find(configurations, name):
    """The one of that name. Raises TableError."""
    for configuration in configurations:
        if configuration.name == name:
            return configuration
    raise TableError(f"no configuration named '{name}'")


def of_tier(configurations, tier):
    """Those that are built in a tier: its own and those of the smaller ones."""
    built = TIERS[: TIERS.index(tier) + 1]
    return [configuration for configuration in configurations if configuration.tier in built]


def select(configurations, org="", n="", fmt=""):
    """Those of an organization, N and format, each perhaps empty: any. Raises TableError."""
    for column, wanted in (("org", org), ("n", n), ("format", fmt)):
        if not wanted:
            continue
        known = list(dict.fromkeys(str(getattr(c, column)) for c in configurations))
        configurations = [c for c in configurations if str(getattr(c, column)) == wanted]
        if not configurations:
            raise TableError(f"{column.upper()}={wanted}: unknown here: one of {', '.join(known)}")
    return configurations


def cmake_text(configurations, tier, selected):
    """All rows; the lists name those of a tier and those selected."""
    tiered = of_tier(configurations, tier)
    lists = {
        "CONFIGURATION": configurations,
        "TIER": tiered,
        "STREAM": [c for c in tiered if c.stream],
        "SELECTED": selected,
    }
    lines = [f"# {GENERATED}"]
    for name, rows in lists.items():
        identifiers = " ".join(c.identifier for c in rows)
        lines.append(f"set(HWFFD_{name}_IDENTIFIERS {identifiers})")
    for c in configurations:
        lines.append(f"set(HWFFD_CONFIGURATION_NAME_{c.identifier} {c.name})")
        lines.append(
            f"set(HWFFD_CONFIGURATION_PARAMETERS_{c.identifier} {' '.join(c.assignments())})")
    return "\n".join(lines) + "\n"


def table_text(configurations):
    lines = [
        f"// {GENERATED}",
        '#include "hwffd/model/configuration.hpp"',
        "",
        "#include <stdexcept>",
        "",
        "namespace hwffd {",
        "",
        "const std::vector<Configuration>& configurations() {",
        "  static const std::vector<Configuration> table = {",
    ]
    for c in configurations:
        lines.append(
            f'      {{"{c.name}", "{c.org}", {c.n}, "{c.format}", "{c.schedule}", "{c.evaluator}",'
            f' {c.mul_latency}, {c.add_latency}, {c.fma_latency}, {c.convert_latency},'
            f' "{c.tier}"}},')
    lines += [
        "  };",
        "  return table;",
        "}",
        "",
        "const Configuration& find_configuration(const std::string& name) {",
        "  for (const Configuration& configuration : configurations()) {",
        "    if (name == configuration.name) return configuration;",
        "  }",
        "  std::string names;",
        "  for (const Configuration& configuration : configurations()) {",
        '    names += (names.empty() ? "" : ", ") + std::string(configuration.name);',
        "  }",
        "  throw std::invalid_argument(\"no configuration named '\" + name +",
        "                              \"': one of \" + names);",
        "}",
        "",
        "}  // namespace hwffd",
    ]
    return "\n".join(lines) + "\n"


_FACTORY = """\
// {generated}
{includes}
#include "hwffd/cores/{core}_core_factory.hpp"
#include "hwffd/cores/verilated_{core}_core.hpp"
{more_includes}
#include <stdexcept>
#include <string>

namespace hwffd::cores {{
namespace {{

using Make = std::unique_ptr<{Core}Core> (*)(std::uint64_t{types});

template <class VDut>
std::unique_ptr<{Core}Core> make(std::uint64_t seed{parameters}) {{
  auto core = std::make_unique<Verilated{Core}Core<VDut>>(seed);
{prepare}  return core;
}}

Make find(const Configuration& configuration) {{
  const std::string name = configuration.name;
{rows}
  return nullptr;
}}

}}  // namespace

bool has_{core}_core(const Configuration& configuration) {{
  return find(configuration) != nullptr;
}}

{more}std::unique_ptr<{Core}Core> make_{core}_core(const Configuration& configuration,
                                             std::uint64_t seed{parameters}) {{
  const Make make_it = find(configuration);
  if (make_it == nullptr) {{
    throw std::invalid_argument(std::string("configuration '") + configuration.name +
                                "' is not in this build: configure with -DHWFFD_TIER=all");
  }}
  return make_it(seed{arguments});
}}

}}  // namespace hwffd::cores
"""
_TRACED = {
    "more_includes": "",
    "types": ", const std::string&",
    "parameters": ", const std::string& trace",
    "arguments": ", trace",
    "prepare": "  if (!trace.empty()) core->trace(trace);\n",
    "more": "",
}
_CORES = {
    "stream": {
        **_TRACED,
        "more_includes": '#include "hwffd/cores/waveform.hpp"\n',
        "more": "bool stream_cores_can_trace() { return Waveform::kAvailable; }\n\n",
    },
    "axi": _TRACED,
    "evaluator": {
        "more_includes": "", "types": "", "parameters": "", "arguments": "", "prepare": "",
        "more": "",
    },
}


def factory_text(configurations, core, suffix=""):
    """Cores ("stream", "axi" or "evaluator") of these rows; a row's class is V<identifier><suffix>."""
    classes = {c.name: f"V{c.identifier}{suffix}" for c in configurations}
    return _FACTORY.format(
        generated=GENERATED,
        includes="\n".join(f'#include "{made}.h"' for made in classes.values()),
        rows="\n".join(
            f'  if (name == "{name}") return make<{made}>;' for name, made in classes.items()),
        core=core, Core=core.capitalize(), **_CORES[core])


def add_selection(parser):
    """The options that `selected` reads."""
    for column in ("org", "n", "format"):
        parser.add_argument(f"--{column}", default="", help="these rows only")


def selected(configurations, options):
    return select(configurations, options.org, options.n, options.format)


def write_if_changed(path, text):
    """Leaves the file alone, time stamp and all, when it has this text already."""
    path = pathlib.Path(path)
    if path.is_file() and path.read_text(encoding="utf-8") == text:
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text, encoding="utf-8")


def main(arguments=None):
    parser = argparse.ArgumentParser(description="Reads the table of configurations.")
    parser.add_argument("--table", default=TABLE, help="default: rtl/configurations.csv")
    commands = parser.add_subparsers(dest="command", required=True, metavar="COMMAND")
    listing = commands.add_parser("list", help="print the names of a tier (default: all)")
    parameters = commands.add_parser("parameters", help="print a row's parameters, NAME=value ...")
    parameters.add_argument("name")
    styles = parameters.add_mutually_exclusive_group()
    styles.add_argument("--verilator", dest="prefix", action="store_const", const="-G",
                        help="as -GNAME=value ...")
    styles.add_argument("--fusesoc", dest="prefix", action="store_const", const="--",
                        help="as --NAME=value ...")
    parameters.set_defaults(prefix="")
    cmake = commands.add_parser("cmake", help="write names, identifiers, parameters for CMake")
    cpp = commands.add_parser("cpp", help="write the table (all tiers) as C++")
    factory = commands.add_parser("factory", help="write the C++ that makes a row's model")
    models = commands.add_parser("models", help="write the C++ that makes a row's bit-true model")
    select = commands.add_parser("select", help="write the RTL that selects the organization")
    evaluators = commands.add_parser(
        "evaluators", help="write the C++ that makes a row's evaluator at its read port")
    for command in (cmake, cpp, factory, models, select, evaluators):
        command.add_argument("out")
    factory.add_argument("--rows", nargs="+", metavar="NAME", help="these instead of a tier's")
    factory.add_argument("--core", choices=("stream", "axi"), default="stream",
                         help="hwffd_stream or hwffd_axi (stream)")
    factory.add_argument("--suffix", default="", help="of the models' names, such as _netlist")
    for command in (listing, cmake, factory, evaluators):
        command.add_argument("--tier", choices=TIERS, default="all")
    for command in (listing, cmake, evaluators):
        add_selection(command)
    options = parser.parse_args(arguments)

    try:
        rows = read(options.table)
        if options.command == "list":
            for configuration in of_tier(selected(rows, options), options.tier):
                print(configuration.name)
        elif options.command == "parameters":
            assignments = find(rows, options.name).assignments()
            print(" ".join(options.prefix + word for word in assignments))
        elif options.command == "cmake":
            text = cmake_text(rows, options.tier, selected(rows, options))
            write_if_changed(options.out, text)
        elif options.command == "cpp":
            write_if_changed(options.out, table_text(rows))
        elif options.command == "models":
            write_if_changed(options.out, models_text(rows))
        elif options.command == "select":
            write_if_changed(options.out, select_text(ROOT / "rtl"))
        elif options.command == "evaluators":
            built = of_tier(selected(rows, options), options.tier)
            text = factory_text(built, "evaluator", "_evaluator")
            write_if_changed(options.out, text)
        else:
            named = [find(rows, name) for name in options.rows or ()]
            built = named or [c for c in of_tier(rows, options.tier) if c.stream]
            write_if_changed(options.out, factory_text(built, options.core, options.suffix))
    except (TableError, OSError) as error:
        print(f"configurations.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
