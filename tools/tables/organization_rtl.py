"""The RTL that follows from the table of organizations: ffd_org_select, and what kind each of them is; and their
forms in C++.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import textwrap

from tools.tables import organizations

TABLE = f"rtl/{organizations.TABLE}"
SELECT = "rtl/evaluator/ffd_org_select.v"
HEADER = "rtl/evaluator/ffd_organizations.vh"
FORMS = "golden/include/hwffd/model/form.hpp"
GENERATED = "by tools/tables/generated_files.py; changes here are lost."
LATENCIES = """\
  ffd_num_latencies #(
    .FORMAT         (FORMAT),
    .MUL_LATENCY    (MUL_LATENCY),
    .ADD_LATENCY    (ADD_LATENCY),
    .FMA_LATENCY    (FMA_LATENCY),
    .CONVERT_LATENCY(CONVERT_LATENCY)
  ) u_latencies ();
"""


def select_text(rtl):
    """ffd_org_select: the organization numbered ORG, if N is one that it has."""
    rows = sorted(organizations.read(rtl).values(), key=lambda organization: organization.number)
    first = rows[0]
    refused = [f"ORG == {row.number} && N != {row.n}" for row in rows if row.n]
    arms = []
    for organization in rows:
        own = "".join(f"        .{name}({value}),\n"
                      for name, value in organization.parameters.items())
        opening = "if" if organization is first else "end else if"
        label = organization.name.replace("/", "_by_")
        arms.append(f"""    {opening} (ORG == {organization.number}) begin : gen_{label}
      ffd_org_{organization.module} #(
{own}        `include "ffd_org_arguments.vh"
      ) u_org (
        `include "ffd_org_connections.vh"
      );
""")
    listing = ", ".join(f"{row.number} {row.name}" + (f" (N {row.n})" if row.n else "")
                        for row in rows)
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
  parameter FORMAT          = 18,
  parameter N               = {first.n or 1},
  parameter PORTS           = `FFD_ORG_PORTS(ORG),
  `include "ffd_org_parameters.vh"
) (
  `include "ffd_org_ports.vh"
);
{LATENCIES}
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


def header_text(rtl):
    """What other modules may ask of ORG."""
    rows = sorted(organizations.read(rtl).values(), key=lambda organization: organization.number)

    def any_of(kind):
        tests = [f"(ORG) == {row.number}" for row in rows if kind(row)]
        lines = (" || ".join(tests[i:i + 6]) for i in range(0, len(tests), 6))
        return " || \\\n    ".join(lines)

    numbers = "".join(f"(ORG) == {row.number} ? {row.n} : " + ("\\\n    " if index % 4 == 3 else "")
                      for index, row in enumerate(row for row in rows if row.n))
    ports = "".join(f"(ORG) == {row.number} ? {row.ports} : " for row in rows if row.ports > 1)
    return f"""// What kind an organization is, by its number.
// Made from rtl/{organizations.TABLE} {GENERATED}
// SPDX-License-Identifier: Apache-2.0
`ifndef FFD_ORGANIZATIONS_VH
`define FFD_ORGANIZATIONS_VH

// It takes the 64 points of a vertex in turn, N in a clock.
`define FFD_ORG_IN_TURN(ORG) \\
  ({any_of(lambda row: row.in_turn)})

// It takes for granted that the functions of an axis sum to one.
`define FFD_ORG_AFFINE(ORG) \\
  ({any_of(lambda row: row.of_form.completes)})

// How many points it takes in a clock; four, the functions of an axis, where it may be any.
`define FFD_ORG_N(ORG) \\
  ({numbers}4)

// At how many ports it reads points.
`define FFD_ORG_PORTS(ORG) ({ports}1)

// One pass of it gives the position and its three derivatives.
`define FFD_ORG_JACOBIAN(ORG) \\
  ({any_of(lambda row: row.jacobian)})

// It takes a second vertex of the same cell of a row with each one.
`define FFD_ORG_PAIRS(ORG) \\
  ({any_of(lambda row: row.pairs)})

`endif
"""


def forms_text():
    """C++: the forms, and what the model and the cores ask of them."""
    forms = list(organizations.FORMS.values())
    width = max(len(form.name) for form in forms)
    names = "\n".join(f"  k{form.name.capitalize()},".ljust(width + 6) + f"///< {form.meaning}" for form in forms)

    def any_of(kind):
        return " || ".join(f"form == Form::k{form.name.capitalize()}" for form in forms if kind(form)) or "false"

    return f"""// Made from the forms of organizations.py by tools/tables/generated_files.py; changes are lost.
#pragma once

namespace hwffd {{

// clang-format off
/// How an organization computes eq. (1), which decides what it rounds.
enum class Form {{
{names}
}};

/// Whether it takes one axis after the other.
constexpr bool contracts(Form form) {{
  return {any_of(lambda form: form.contracts)};
}}

/// Whether it takes for granted that the functions of an axis sum to one.
constexpr bool completes(Form form) {{
  return {any_of(lambda form: form.completes)};
}}
// clang-format on

}}  // namespace hwffd
"""


def outputs(root):
    """path below root -> the text that it must have"""
    rtl = pathlib.Path(root) / "rtl"
    return {SELECT: select_text(rtl), HEADER: header_text(rtl), FORMS: forms_text()}
