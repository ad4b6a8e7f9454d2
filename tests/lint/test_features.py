"""Features of a core: parameters of the tops by name, of which the register FEATURES tells.

SPDX-License-Identifier: Apache-2.0
"""

import random
import subprocess

import pytest

from tools.csv_table import TableError
from tools.rtl import module_header, rtl_sources
from tools.tables import features, parameter_draws, parameter_space

TOP = "hwffd_stream"
CORES = 4


def simulated(verilog, folder):
    """What a module prints beside the core's sources."""
    sources = rtl_sources.Sources()
    (folder / "bench.v").write_text(verilog, encoding="utf-8")
    words = ["iverilog", "-g2005", "-o", folder / "bench.vvp", "-s", "bench", *(f"-I{path}" for path in sources.includes),
             *sources.needed(TOP), folder / "bench.v"]
    subprocess.run(words, check=True, capture_output=True)
    return subprocess.run(["vvp", "-n", folder / "bench.vvp"], check=True, capture_output=True, text=True).stdout


def test_the_word_follows_from_the_names(tmp_path):
    """Of cores drawn at random, and of the core without a parameter."""
    draw = parameter_draws.Draw(parameter_space.Space(), TOP, random.Random(1), units=12)
    cores = [{}, *(draw.legal() for _ in range(CORES))]
    lines = []
    for number, core in enumerate(cores):
        given = ", ".join(f".{name}({value})" for name, value in core.items())
        lines += [f"  {TOP} #({given}) u_core{number} ();" if core else f"  {TOP} u_core{number} ();",
                  f'  initial $display("%0d", u_core{number}.FEATURES);']
    printed = simulated("\n".join(["module bench;", *lines, "endmodule", ""]), tmp_path)
    defaults = module_header.parameters(rtl_sources.Sources(), TOP)
    wanted = [features.number_of({**defaults, **core}) for core in cores]
    assert sorted(map(int, printed.split())) == sorted(wanted) and len(set(wanted)) > CORES / 2
    assert wanted[0] == features.value("resident+interleaved", "here")


def test_a_row_has_the_usual_features_unless_it_says():
    usual = features.of_top(TOP, {"ORG": 3})
    assert usual["ORG"] == 3 and "+".join(sorted(features.names_of({"AXIS": 16, "SPANS": 1, **usual}))) == "+".join(
        sorted(features.USUAL.split("+")))
    few = features.of_top(TOP, {"ORG": 3, "FEATURES": features.value("resident", "here")})
    assert "FEATURES" not in few and sum(few[name] for name in features.PARAMETERS.values()) == 1
    assert features.of_top("ffd_stream_header", {"FEATURES": 256}) == {"FEATURES": 256}
    for given in {"FEATURES": features.value("resident+spans", "here")}, {"SPANS": 2}:
        with pytest.raises(TableError, match="spans where, and only where, SPANS > 1"):
            features.of_top(TOP, given)


@pytest.mark.parametrize("text, complaint", [("resident+page", "unknown feature 'page'"), ("pages+pages", "twice 'pages'")])
def test_a_name_that_is_none_is_refused(text, complaint):
    with pytest.raises(TableError, match=complaint):
        features.value(text, "here")
