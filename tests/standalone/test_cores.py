"""Standalone cores of random configurations: their words, their clocks, and what tools say of them.

SPDX-License-Identifier: Apache-2.0
"""

import random

import pytest

from tests.standalone import bench

TOPS = ("hwffd_stream", "hwffd_axi", "hwffd_stream_bus", "hwffd_wishbone")
DRAWN = 20
SOME = (17,)  # of them, in make test: a small one with a DMA engine and many features
VERTICES = 24

CHECK = """#define {guard}_MODEL_IMPLEMENTATION
#include "{prefix}_model.hpp"

#include <cstdio>
#include <fstream>
#include <string>

std::vector<{prefix}_model::Beat> read(const char* name) {{
  std::ifstream file(name);
  std::string line;
  std::vector<{prefix}_model::Beat> beats;
  while (file >> line) {{
    {prefix}_model::Beat beat;
    const int flags = std::stoi(line.substr(0, 1), nullptr, 16);
    beat.last = (flags & 1) != 0;
    beat.user = (flags & 2) != 0;
    for (int word = 0; word < 4; ++word) {{
      beat.words[3 - word] = static_cast<std::uint32_t>(std::stoul(line.substr(1 + 8 * word, 8), nullptr, 16));
    }}
    beats.push_back(beat);
  }}
  return beats;
}}

int main() {{
  {prefix}_model::Model model;
  const auto got = model.run(read("commands.hex"));
  const auto wanted = read("results.hex");
  std::printf("%zu of %zu, %s\\n", got.size(), wanted.size(), got == wanted ? "equal" : "not equal");
}}
"""


def seeds():
    return [pytest.param(seed, marks=[pytest.mark.whole] if seed not in SOME else []) for seed in range(DRAWN)]


@pytest.fixture(scope="module", params=seeds())
def written(request, tmp_path_factory):
    seed = request.param
    core = bench.drawn(seed, TOPS[seed % len(TOPS)], f"drawn{seed}")
    return bench.Folder(core, tmp_path_factory.mktemp("folder") / core.prefix, VERTICES)


def test_it_passes_in_the_clocks_of_the_whole_tree(written):
    passed = written.passed()
    assert passed[0] == VERTICES and passed[1] >= 1
    tree = written.with_parameters(written.core.top, written.core.parameters)
    assert written.passed(testbench=tree, sources=bench.whole_tree(), name="tree") == passed


def test_free_parameters_change_no_word(written):
    chosen = random.Random(1)
    values = {free.name: chosen.choice(free.samples()) for free in written.core.free.values()}
    vertices, results, *_ = written.passed(testbench=written.with_parameters(written.prefix, values), name="free")
    assert (vertices, results) == (VERTICES, written.text("_results.hex").count("\n"))


@pytest.mark.parametrize("every", (False, pytest.param(True, marks=pytest.mark.whole)))
def test_no_tool_has_a_warning(written, every):
    assert written.lint(every) == []


def test_the_file_is_the_core_alone(written):
    text = written.text(".v")
    assert "`include" not in text and "`define" not in text and "`ifdef" not in text
    assert not [line for line in text.splitlines() if "`" in line and not line.startswith(("`default_nettype", "//"))
                and "`" in line.partition("//")[0]]
    assert max(map(len, text.splitlines())) <= 130


def test_the_model_header_says_the_same(written):
    prefix, count = written.prefix, written.units()
    (written.path / "check.cpp").write_text(CHECK.format(prefix=prefix, guard=prefix.upper()), encoding="utf-8")
    status, output = bench.run("g++", "-std=c++17", "-Wall", "-Wextra", "-Werror", "-ffp-contract=off", "-o", "check", "check.cpp",
                               cwd=written.path)
    assert (status, output) == (0, "")
    assert count and bench.run("./check", cwd=written.path) == (0, f"{count} of {count}, equal\n")
