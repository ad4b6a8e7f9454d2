"""The table of organizations, rtl/organizations.csv, and the code that follows from it: the selector
in the RTL and the factory of bit-true models. An organization `name` is the module ffd_org_<name>
and the class OrgName in hwffd/model/org_<name>.hpp; a number at the end of a name (cg3) is the
module's parameter SIZE, one behind a stroke (factored/3) its parameter FOLD. Where two organizations
are one module, the second is in SHARED. All modules have the ports and parameters of ffd_org_tree.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import textwrap
from dataclasses import dataclass

import tables
from tables import TableError

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = "organizations.csv"
COLUMNS = ("org", "number", "n")
NUMBERS = range(256)  # what CONFIG.org has bits for
UNITS = range(1, 65)
_GENERATED = "by scripts/configurations.py; changes here are lost."
GENERATED = f"Made from rtl/configurations.csv {_GENERATED}"

# The word of an organization: letters, perhaps a number, perhaps how often it is folded.
WORD = re.compile(r"([a-z]+)([0-9]*)(?:/([0-9]+))?")

# Organization -> the module that it is, with the parameters that make it so.
SHARED = {
    "basic": ("tree", {"SERIAL": 1}),
    "parallel": ("tree", {}),
}


@dataclass(frozen=True)
class Organization:
    name: str
    number: int  # the value of the parameter ORG, which software reads: it stays for ever
    n: int  # that of N; None where the rows choose


def split_name(org):
    """cg3 -> ("cg", {"SIZE": 3}), factored/3 -> ("factored", {"FOLD": 3}),
    basic -> ("tree", {"SERIAL": 1})
    """
    if org in SHARED:
        return SHARED[org]
    module, size, fold = WORD.fullmatch(org).groups()
    given = {"SIZE": size, "FOLD": fold}
    return module, {name: int(value) for name, value in given.items() if value}


def module_path(rtl, org):
    return pathlib.Path(rtl) / "evaluator" / f"ffd_org_{split_name(org)[0]}.v"


def _number(text, allowed, where, what):
    if not re.fullmatch(r"[0-9]{1,4}", text) or int(text) not in allowed:
        raise TableError(f"{where}: {what} is '{text}', {allowed[0]} to {allowed[-1]} wanted")
    return int(text)


def read(rtl=ROOT / "rtl"):
    """name -> Organization, of the table in that folder. Raises TableError."""
    path = pathlib.Path(rtl) / TABLE
    found = {}
    for where, cells in tables.read(path, COLUMNS):
        name = cells["org"]
        if not WORD.fullmatch(name):
            raise TableError(f"{where}: bad org '{name}': letters, then perhaps a number, then "
                             "perhaps / and a number")
        module = module_path(rtl, name)
        if not module.is_file():
            raise TableError(f"{where}: unknown org '{name}': there is no {module.name}")
        number = _number(cells["number"], NUMBERS, where, "number")
        n = _number(cells["n"], UNITS, where, "n") if cells["n"] else None
        if name in found:
            raise TableError(f"{where}: '{name}' is there twice")
        for other in found.values():
            if other.number == number:
                raise TableError(f"{where}: number {number} is that of '{other.name}'")
        found[name] = Organization(name, number, n)
    if not found:
        raise TableError(f"{path}: no organizations")
    return found


def _header(rtl):
    """The text between `module ffd_org_tree` and its `);`, with its parameters and ports."""
    text = (pathlib.Path(rtl) / "evaluator" / "ffd_org_tree.v").read_text(encoding="utf-8")
    match = re.search(
        r"^module ffd_org_tree #\(\n  parameter SERIAL [^\n]*\n(.*?)\n\) \(\n(.*?)\n\);$",
        text, re.M | re.S)
    parameters, ports = match.group(1), match.group(2)
    names = re.findall(r"^  parameter (\w+)", parameters, re.M)
    wires = re.findall(r"(\w+),?$", ports, re.M)
    return parameters, ports, names, wires


def _connections(names, indent):
    width = max(len(name) for name in names)
    return ",\n".join(f"{indent}.{name:<{width}}({name})" for name in names)


def select_text(rtl):
    """ffd_org_select: the organization numbered ORG, if N is one that it has."""
    parameters, ports, names, wires = _header(rtl)
    found = sorted(read(rtl).values(), key=lambda organization: organization.number)
    first = found[0]
    if first.n:
        parameters = re.sub(r"(?m)^(  parameter N +=) \d+", rf"\1 {first.n}", parameters)
    refused = [f"ORG == {one.number} && N != {one.n}" for one in found if one.n]
    arms = []
    for organization in found:
        module, own = split_name(organization.name)
        values = _connections(names, " " * 8)
        for name, value in own.items():
            values = f"        .{name}({value}),\n" + values
        opening = "if" if organization is first else "end else if"
        label = organization.name.replace("/", "_by_")
        arms.append(f"""    {opening} (ORG == {organization.number}) begin : gen_{label}
      ffd_org_{module} #(
{values}
      ) u_org (
{_connections(wires, " " * 8)}
      );
""")
    listing = ", ".join(f"{one.number} {one.name}" + (f" (N {one.n})" if one.n else "")
                        for one in found)
    numbers = textwrap.fill(f"ORG is {listing}.", 100, initial_indent="// ",
                            subsequent_indent="// ")
    refusals = " ||\n        ".join(refused)
    return f"""// ffd_org_select: the organization numbered ORG
//
{numbers}
// Made from rtl/{TABLE} {_GENERATED}
//
// Ports, pipeline, parameters: those of every organization (docs/architecture.md).
// Model:      golden/include/hwffd/model/evaluator.hpp.  Test: tests/system.
// SPDX-License-Identifier: Apache-2.0
`default_nettype none
`include "ffd_num.vh"
`include "ffd_eval.vh"

module ffd_org_select #(
  parameter ORG             = {first.number},
{parameters}
) (
{ports}
);
  generate
    if ({refusals}) begin : gen_bad_n
      ERROR_ffd_org_select_n_is_not_that_of_the_organization u_error ();
    end
{"".join(arms)}    end else begin : gen_bad_org
      ERROR_ffd_org_select_org_is_unknown u_error ();
    end
  endgenerate
endmodule

`default_nettype wire
"""


def _format_class(word, fused):
    if word == "fp32":
        return "Binary32Fused" if fused else "Binary32"
    if word == "bfp32":
        return "Block32"
    return f"Fixed<{word[2:]}>"


def models_text(configurations):
    """C++: make_evaluator_model for every organization and format of the table."""
    modules = list(dict.fromkeys(split_name(c.org)[0] for c in configurations))
    kinds = list(dict.fromkeys((split_name(c.org)[0], c.org, c.format, c.fma_latency > 0)
                               for c in configurations))
    lines = [f"// {GENERATED}"]
    lines += [f'#include "hwffd/model/org_{module}.hpp"' for module in modules]
    lines += [
        '#include "hwffd/model/evaluator.hpp"',
        '#include "hwffd/model/hard_wired.hpp"',
        '#include "hwffd/numerics/binary32.hpp"',
        '#include "hwffd/numerics/block.hpp"',
        '#include "hwffd/numerics/fixed.hpp"',
        "",
        "#include <stdexcept>",
        "#include <string>",
        "#include <utility>",
        "",
        "namespace hwffd::model {",
        "namespace {",
        "",
        "std::unique_ptr<EvaluatorModel> make_general(const Configuration& row) {",
        "  const std::string org = row.org;",
        "  const std::string format = row.format;",
        "  const bool fused = row.fma_latency > 0;",
    ]
    for module, org, word, fused in kinds:
        lines += [
            f'  if (org == "{org}" && format == "{word}" && fused == {str(fused).lower()}) {{',
            f"    return std::make_unique<EvaluatorModelOf<{_format_class(word, fused)},"
            f" Org{module.capitalize()}>>(row);",
            "  }",
        ]
    lines += [
        '  throw std::invalid_argument("no model of " + org + " in " + format);',
        "}",
        "",
        "}  // namespace",
        "",
        "std::unique_ptr<EvaluatorModel> make_evaluator_model(const Configuration& row) {",
        "  auto model = make_general(row);",
        '  if (std::string(row.evaluator) != "bspline") return model;',
        "  return std::make_unique<HardWiredBspline>(std::move(model), row.format);",
        "}",
        "",
        "}  // namespace hwffd::model",
    ]
    return "\n".join(lines) + "\n"
