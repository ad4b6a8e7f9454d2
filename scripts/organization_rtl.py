"""ffd_org_select, the RTL that follows from the table of organizations.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re
import textwrap

import organizations

GENERATED = "by scripts/configurations.py; changes here are lost."


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
    found = sorted(organizations.read(rtl).values(), key=lambda organization: organization.number)
    first = found[0]
    if first.n:
        parameters = re.sub(r"(?m)^(  parameter N +=) \d+", rf"\1 {first.n}", parameters)
    refused = [f"ORG == {one.number} && N != {one.n}" for one in found if one.n]
    arms = []
    for organization in found:
        values = _connections(names, " " * 8)
        for name, value in organization.parameters.items():
            values = f"        .{name}({value}),\n" + values
        opening = "if" if organization is first else "end else if"
        label = organization.name.replace("/", "_by_")
        arms.append(f"""    {opening} (ORG == {organization.number}) begin : gen_{label}
      ffd_org_{organization.module} #(
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
// Made from rtl/{organizations.TABLE} {GENERATED}
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
