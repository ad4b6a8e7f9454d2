"""The bit-true model of a standalone core as one C++ header, its configuration fixed: the golden reference,
file behind file, in a namespace of its own.

SPDX-License-Identifier: Apache-2.0
"""

import re

from tools.project_root import ROOT
from tools.standalone import templates
from tools.tables import configuration_texts as texts, configurations, features

# What StreamModel consists of; the headers that these include come in front of them.
_SOURCES = ("model/configuration", "model/resident_vertex", "model/stream_headers", "model/stream_model",
            "model/stream_results", "model/stream_vertices", "stream/grid", "stream/halves", "stream/packed",
            "stream/packets", "stream/word_codec", "excerpt")
_INCLUDE = re.compile(r'^#include ([<"])([^>"]+)[>"].*\n', re.MULTILINE)
_GOLDEN = ROOT / "golden"


class _Flattened:
    """Text of C++ without its own includes, each header once, where it is first wanted."""

    def __init__(self):
        self.standard = set()  # headers of the standard library
        self.known = set()
        self.pieces = []

    def add(self, name, text):
        """A file, behind the headers that it wants."""
        for kind, header in _INCLUDE.findall(text):
            if kind == "<":
                self.standard.add(header)
            elif header not in self.known:
                self.known.add(header)
                self.add(f"golden/include/{header}", (_GOLDEN / "include" / header).read_text(encoding="utf-8"))
        body = _INCLUDE.sub("", text).replace("#pragma once\n", "").strip("\n")
        self.pieces.append(f"// {name}\n\n{body}\n")


def _row(core):
    """The core as a row of the table of configurations."""
    parameters = core.parameters
    return configurations.Configuration(
        name="standalone", org=core.organization.name, n=parameters["N"], format=core.number_format.name,
        schedule=core.schedule, evaluator=core.evaluator, mul_latency=parameters["MUL_LATENCY"],
        add_latency=parameters["ADD_LATENCY"], fma_latency=parameters["FMA_LATENCY"],
        convert_latency=parameters["CONVERT_LATENCY"], top="stream", tier="all", stream_tier="all",
        organization=core.organization, number_format=core.number_format)


def text(core, version):
    """The header."""
    flat, row, own = _Flattened(), _row(core), {core.organization.name: core.organization}
    for name in _SOURCES:
        flat.add(f"golden/src/{name}.cpp", (_GOLDEN / "src" / f"{name}.cpp").read_text(encoding="utf-8"))
    flat.add("the table of configurations, of one row", texts.table_text([row], own, []))
    flat.add("the model of that row", texts.models_text([row], own))
    space = f"{core.prefix}_golden"
    golden = re.sub(r"\bhwffd\b(?=::| \{|;)", space, "\n".join(flat.pieces))
    golden = re.sub(r"\bHWFFD_(?=[A-Z])", f"{core.prefix.upper()}_", golden)
    return templates.text("model.hpp.jinja", core=core, features=features.number_of(core.parameters), version=version, golden=golden, space=space,
                          standard=sorted(flat.standard | {"cstdint", "vector", "memory", "array", "utility"}),
                          guard=f"{core.prefix.upper()}_MODEL")
