"""What CMake and C++ are given of the tables of configurations and organizations.

SPDX-License-Identifier: Apache-2.0
"""

from tools.tables import features

GENERATED = "Made from rtl/configurations.csv by tools/tables/configurations.py; changes here are lost."


def cmake_text(configurations, tiered, streams, buses, selected):
    """All rows; the lists name those of a tier, also with streams and with buses, and those selected."""
    lists = {
        "CONFIGURATION": configurations,
        "TIER": tiered,
        "STREAM": streams,
        "AXI": buses,
        "SELECTED": selected,
    }
    lines = [f"# {GENERATED}"]
    for name, rows in lists.items():
        identifiers = " ".join(c.identifier for c in rows)
        lines.append(f"set(HWFFD_{name}_IDENTIFIERS {identifiers})")
    for c in configurations:
        lines.append(f"set(HWFFD_CONFIGURATION_NAME_{c.identifier} {c.name})")
        lines.append(f"set(HWFFD_CONFIGURATION_OPTIONS_{c.identifier} {'WIDE' if c.wide else ''})")
        lines.append(
            f"set(HWFFD_CONFIGURATION_PARAMETERS_{c.identifier} {' '.join(c.assignments())})")
    lines.append(f"set(HWFFD_CORES {' '.join(features.CORES)})")
    lines.append(f"set(HWFFD_USUAL_FEATURES {features.USUAL})")
    lines.append(f"set(HWFFD_FEATURES {' '.join(features.BITS)})")
    lines += [f"set(HWFFD_FEATURE_{name} {bit})" for name, bit in features.BITS.items()]
    lines += [f"set(HWFFD_FOLLOWS {' '.join(features.FOLLOWS)})"]
    lines += [f"set(HWFFD_FOLLOWS_{name} {parameter} {most})" for name, (parameter, most) in features.FOLLOWS.items()]
    lines += [f"set(HWFFD_PARAMETER_OF_{name} {parameter})" for name, parameter in features.PARAMETERS.items()]
    return "\n".join(lines) + "\n"


_TABLE = """\
// {generated}
#include "hwffd/model/configuration.hpp"
#include "hwffd/model/organizations.hpp"

#include <algorithm>
#include <cmath>

namespace hwffd {{

const std::vector<Organization>& organization_table() {{
  using T = const ClockTerms&;
  static const std::vector<Organization> table = {{
{organizations}
  }};
  return table;
}}

const std::vector<Configuration>& configurations() {{
  static const std::vector<Configuration> table = {{
{configurations}
  }};
  return table;
}}

const std::vector<Gone>& gone_names() {{
  static const std::vector<Gone> table = {{
{gone}
  }};
  return table;
}}

}}  // namespace hwffd
"""


def _organization(o):
    def clocks(formula):
        if formula is None:
            return "nullptr"
        text = formula.cpp()
        return f"[](T{' t' if 't.' in text else ''}) {{ return {text}; }}"

    module = " ".join([o.module, *(f"{name}={value}" for name, value in o.parameters.items())])
    return (f'      {{"{o.name}", {o.number}, "{module}", {o.n or 0}, Form::k{o.form.capitalize()},'
            f" {o.fold}, {o.lanes}, {str(o.jacobian).lower()}, {str(o.walks).lower()},"
            f" {str(o.pairs).lower()},"
            f" {', '.join(map(clocks, o.formulas.values()))}, \"{o.formulas['overlapped'].text}\"}},")


def _configuration(c):
    return (f'      {{"{c.name}", "{c.org}", {c.n}, "{c.format}", "{c.schedule}", "{c.evaluator}",'
            f' {c.mul_latency}, {c.add_latency}, {c.fma_latency}, {c.convert_latency},'
            f' "{c.tier}", "{c.stream_tier}"}},')


def table_text(configurations, organizations, gone):
    """C++: the rows of these tables."""
    return _TABLE.format(generated=GENERATED,
                         organizations="\n".join(map(_organization, organizations.values())),
                         configurations="\n".join(map(_configuration, configurations)),
                         gone="\n".join(f'      {{"{one.name}", "{one}"}},' for one in gone))


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
        includes="\n".join(f'#include "{model}.h"' for model in classes.values()),
        rows="\n".join(
            f'  if (name == "{name}") return make<{model}>;' for name, model in classes.items()),
        core=core, Core=core.capitalize(), **_CORES[core])


def model_kind(organization, number_format, fma_latency, evaluator):
    """What decides which model it is: module, format, whether fused, and whether from powers."""
    return organization.module, number_format, fma_latency > 0, evaluator == "powers"


def _model_class(kind):
    """factored, of OrgFactored in org_factored.hpp."""
    return "powers" if kind[3] else kind[0]


def _kind_of(c):
    return model_kind(c.organization, c.number_format, c.fma_latency, c.evaluator)


def _cpp(condition):
    return "true" if condition else "false"


def models_text(configurations, organizations):
    """C++: make_evaluator_model for every kind of model of the table; an organization has those of its
    module, also where no row has it in that format."""
    headers = sorted({c.number_format.header for c in configurations})
    kinds = list(dict.fromkeys(map(_kind_of, configurations)))
    lines = [f"// {GENERATED}"]
    lines += [f'#include "hwffd/model/org_{name}.hpp"' for name in dict.fromkeys(map(_model_class, kinds))]
    lines += [
        '#include "hwffd/model/evaluator.hpp"',
        *(f'#include "hwffd/numerics/{header}.hpp"' for header in headers),
        "",
        "#include <stdexcept>",
        "#include <string>",
        "",
        "namespace hwffd::model {",
        "",
        "std::unique_ptr<EvaluatorModel> make_evaluator_model(const Configuration& row) {",
        "  const std::string org = row.org;",
        "  const std::string format = row.format;",
        "  const bool fused = row.fma_latency > 0;",
        '  const bool powers = std::string(row.evaluator) == "powers";',
    ]
    for kind in kinds:
        module, number_format, fused, powers = kind
        model = number_format.fused if fused else number_format.model
        any_of = " || ".join(f'org == "{row.name}"' for row in organizations.values() if row.module == module)
        lines += [
            f'  if (({any_of}) && format == "{number_format.name}" &&',
            f"      fused == {_cpp(fused)} && powers == {_cpp(powers)}) {{",
            f"    return std::make_unique<EvaluatorModelOf<{model}, Org{_model_class(kind).capitalize()}>>(row);",
            "  }",
        ]
    lines += [
        '  throw std::invalid_argument("no model of " + org + " in " + format);',
        "}",
        "",
        "}  // namespace hwffd::model",
    ]
    return "\n".join(lines) + "\n"
