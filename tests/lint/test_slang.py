"""Every top, as its file list gives it, through a parser that wants each name declared before it is used, in both
languages; and its parameters, whatever their widths.

SPDX-License-Identifier: Apache-2.0
"""

import pyslang
import pytest
from pyslang import ast, driver

from tools.project_root import ROOT
from tools.rtl import module_header, rtl_sources
from tools.standalone import elaboration
from tools.tables import configurations

TOPS = sorted(path.stem for path in (ROOT / "rtl" / "top").glob("*.v"))


@pytest.mark.parametrize("standard", ("1364-2005", "1800-2017"))
@pytest.mark.parametrize("top", TOPS)
def test_each_name_is_declared_first(top, standard):
    sources = rtl_sources.Sources()
    slang = driver.Driver()
    slang.addStandardArgs()
    words = [f"-I{path}" for path in sources.includes] + [str(path) for path in sources.needed(top)]
    assert slang.parseCommandLine(f"slang -Werror --std {standard} --top {top} {' '.join(words)}") and slang.processOptions()
    assert slang.parseAllSources() and slang.runFullCompilation(True)


def instances(design, parameters):
    """Every instance below a top with the values of its parameters."""
    bag, options = pyslang.Bag(), ast.CompilationOptions()
    options.topModules = {design.top}
    options.paramOverrides = [f"{name}={value}" for name, value in parameters.items()]
    bag.compilationOptions = options
    compilation = ast.Compilation(bag)
    for tree in design.trees.values():
        compilation.addSyntaxTree(tree)
    found = []

    def visit(symbol):
        if symbol.kind == ast.SymbolKind.Instance:
            found.append((symbol.hierarchicalPath, [int(one.value.value) for one in symbol.body.parameters if one.isPortParam]))
        return ast.VisitAction.Advance

    compilation.getRoot().visit(visit)
    return found


@pytest.mark.parametrize("top, row, more", (
    ("hwffd_axi", "basic-fp32-overlapped", {}), ("hwffd_axi", "cg1-fx18-overlapped", {"MUL_LATENCY": 3}),
    ("hwffd_stream", "affine4-fx17-overlapped", {"EVALUATOR": 3, "MUL_LATENCY": 3}), ("hwffd_scatter", None, {}),
    ("hwffd_adjoint", None, {"MUL_LATENCY": 3})))
def test_a_parameter_with_the_width_of_its_value_is_the_same_core(top, row, more):
    """As LiteX gives them: of 3'd4 and 3'd4 the sum has three bits where nothing makes it wider."""
    values = module_header.parameters(rtl_sources.Sources(), top)
    values.update({**(configurations.find(configurations.read(), row).parameters if row else {}), **more})
    design = elaboration.Design(top)
    plain = instances(design, values)
    assert len(plain) > 100
    assert instances(design, {name: f"{max(1, value.bit_length())}'d{value}" for name, value in values.items()}) == plain
