"""hwffd.core, the description of the core for FuseSoC: files from rtl/hwffd.f and the headers beside
them, parameters with their defaults from the tops, the version from VERSION.

SPDX-License-Identifier: Apache-2.0
"""

from tools.rtl import module_header, rtl_sources
from tools.tables import configurations, version

NAME = "hwffd.core"
GENERATED = "Made by python3 -m tools.tables.generated_files write; changes here are lost."
TOPS = ("hwffd_stream", "hwffd_axi")  # hwffd_wishbone has the parameters of hwffd_axi
EXAMPLE_SOURCES = ("examples/fusesoc/main.cpp", "golden/src/excerpt.cpp",
                   "golden/src/stream/packets.cpp", "golden/src/stream/word_codec.cpp")
EXAMPLE_HEADERS = ("stream/beat.hpp", "stream/formats.hpp", "stream/opcodes.hpp", "stream/packets.hpp",
                   "stream/status.hpp", "stream/word_codec.hpp", "error.hpp",
                   "excerpt.hpp", "numerics/bits.hpp")
GOLDEN = "golden/include"

_TEXT = """\
CAPI=2:
# {generated}
# docs/datasheet.md says how to use it.
# SPDX-License-Identifier: Apache-2.0
name: "hwffd:ip:hwffd:{version}"
description: Free-form deformation of vertices by a lattice of 64 control points a cell
license: Apache-2.0

filesets:
  rtl:
    files:
{rtl}
    file_type: verilogSource-2005

  # One packet of coefficients, one of a lattice, one of vertices; results compared bit for bit.
  example:
    files:
{example}
    file_type: cppSource

targets:
  default: &default
    filesets: [rtl]
    toplevel: ["axi? (hwffd_axi)", "!axi? (hwffd_stream)"]
    parameters:
{used}

  sim:
    <<: *default
    filesets: [rtl, example]
    toplevel: hwffd_stream
    flow: sim
    flow_options:
      tool: verilator
      mode: cc
      verilator_options: [--default-language, 1364-2005, -Wall, -D{simulation}]
    parameters:
{used_stream}

  lint:
    <<: *default
    flow: lint
    flow_options:
      tool: verilator
      verilator_options: [--default-language, 1364-2005, -Wall]

  synth:
    <<: *default
    flow: generic
    flow_options:
      tool: yosys
      arch: ecp5
      output_format: json
      yosys_synth_options: [-nowidelut]

parameters:
{parameters}
"""


def _rtl_lines(root):
    sources = sorted((root / "rtl").glob("*/*.vh"))
    lines = [f"      - {path.relative_to(root)}: {{is_include_file: true}}" for path in sources]
    return lines + [f"      - rtl/{entry}" + (": {file_type: vlt}" if entry == rtl_sources.WAIVERS else "")
                    for entry in rtl_sources.read_file_list(root / "rtl/hwffd.f")]


def _example_lines():
    lines = [f"      - {GOLDEN}/hwffd/{name}: {{is_include_file: true, include_path: {GOLDEN}}}"
             for name in EXAMPLE_HEADERS]
    return lines + [f"      - {name}" for name in EXAMPLE_SOURCES]


def text(root):
    """What hwffd.core must be."""
    sources = rtl_sources.Sources(root)
    stream, axi = (module_header.parameters(sources, top) for top in TOPS)
    of_org = module_header.of_org(sources, TOPS[1])
    row = configurations.read(root / "rtl" / "configurations.csv")[0].parameters
    parameters = []
    for name, value in axi.items():
        where = "rtl/configurations.csv" if name in row else "docs/interface.md"
        parameters += [f"  {name}:", "    datatype: int", "    paramtype: vlogparam",
                       f"    description: {'that of ORG' if name in of_org else value} if not given; {where}"]
    return _TEXT.format(
        generated=GENERATED, version=version.read(root), simulation=rtl_sources.SIMULATION,
        rtl="\n".join(_rtl_lines(root)), example="\n".join(_example_lines()),
        used="\n".join(f"      - {name}" if name in stream else f'      - "axi? ({name})"'
                       for name in axi),
        # Without those that tops which have an hwffd_stream inside give it.
        used_stream="\n".join(f"      - {name}" for name in axi if name in stream),
        parameters="\n".join(parameters))
