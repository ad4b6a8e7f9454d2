"""The stubs say what the module has: names, arguments, and that everything has a docstring.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import pathlib
import re

import hwffd

FOLDER = pathlib.Path(hwffd.__file__).parent
STUBS = ast.parse((FOLDER / "__init__.pyi").read_text())
INHERITED = {"__init__", "__len__", "__iter__"}


def arguments(function):
    names = [argument.arg for argument in function.args.args + function.args.kwonlyargs]
    return [name for name in names if name != "self"]


def documented(function):
    """Arguments of a function of the module, as the first line of its docstring has them."""
    line = function.__doc__.splitlines()[0]
    inner = line[line.index("(") + 1:line.rindex(") ->")]
    names = re.findall(r"(?:^|, )(\w+): ", inner)
    return [name for name in names if name != "self"]


def test_names_are_the_same():
    named = {node.name for node in STUBS.body if isinstance(node, (ast.ClassDef, ast.FunctionDef))}
    public = {name for name in hwffd.__all__ if name != "__version__"}
    assert named == public == {name for name in dir(hwffd) if not name.startswith("_")}
    assert (FOLDER / "py.typed").is_file()


def test_functions_have_the_arguments_that_the_stubs_say():
    compared = 0
    for node in STUBS.body:
        if isinstance(node, ast.FunctionDef):
            assert arguments(node) == documented(getattr(hwffd, node.name)), node.name
            compared += 1
        elif isinstance(node, ast.ClassDef):
            for method in node.body:
                if not isinstance(method, ast.FunctionDef):
                    continue
                real = getattr(getattr(hwffd, node.name), method.name)
                if not isinstance(real, property):
                    assert arguments(method) == documented(real), method.name
                    compared += 1
    assert compared > 20


def test_classes_have_the_members_that_the_stubs_say():
    for node in STUBS.body:
        if not isinstance(node, ast.ClassDef) or node.name.endswith("Error"):
            continue
        stubbed = {m.name for m in node.body if isinstance(m, ast.FunctionDef)}
        stubbed |= {m.target.id for m in node.body if isinstance(m, ast.AnnAssign)}
        members = vars(getattr(hwffd, node.name))
        assert stubbed - INHERITED == {name for name in members if not name.startswith("_")}
        for name in stubbed - INHERITED:
            assert len((members[name].__doc__ or "").strip()) > 10, f"{node.name}.{name}"
