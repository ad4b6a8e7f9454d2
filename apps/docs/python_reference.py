"""The page of the Python packages, as Markdown: signatures from hwffd's stub with the docstrings of its bindings,
and hwffd.volumes from its sources.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import inspect

from apps.docs.bindings import docstrings

PACKAGE = "api/python/hwffd"
_HEAD = """# Python

The package `hwffd` works on arrays of NumPy; [python](../python.md) has examples. `hwffd.volumes` resamples images
of medicine and needs SciPy ([volumes](../volumes.md)).
"""


def _signature(node):
    """A function's signature, or a property's, as in a stub."""
    decorators = {ast.unparse(one) for one in node.decorator_list}
    arguments = ast.unparse(node.args).replace("self, /, ", "").removeprefix("self, ").removeprefix("self")
    returns = f" -> {ast.unparse(node.returns)}" if node.returns else ""
    if decorators & {"property", "functools.cached_property"}:
        return f"{node.name}: {ast.unparse(node.returns)}" if node.returns else node.name
    prefix = "static " if "staticmethod" in decorators else ""
    return f"{prefix}{node.name}({arguments}){returns}"


def _entry(signature, text):
    words = inspect.cleandoc(text or "")
    return f"```python\n{signature}\n```\n\n" + (f"{_shown(words)}\n\n" if words else "")


def _shown(words):
    """Docstrings name arrays and code without marks: shown as they stand, but code that is set apart."""
    lines = [line if line.startswith("    ") else line.replace("*", "\\*").replace("_", "\\_").replace("<", "&lt;")
             for line in words.splitlines()]
    return "\n".join(lines)


def _class(node, doc_of, attributes=()):
    bases = ", ".join(ast.unparse(base) for base in node.bases)
    text = f"### {node.name}\n\n" + _entry(f"class {node.name}" + (f"({bases})" if bases else ""), doc_of(node))
    fields = [one for one in node.body if isinstance(one, ast.AnnAssign)]
    for one in fields:
        text += _entry(ast.unparse(one), attributes and attributes.get(f"{node.name}.{one.target.id}", ""))
    for one in node.body:
        if isinstance(one, ast.FunctionDef) and (one.name == "__init__" or not one.name.startswith("_")):
            text += _entry(_signature(one), doc_of(one))
    return text


def _bound(root):
    """The package's own part, of C++."""
    said = docstrings(sorted((root / "api/python/src").glob("*.cpp")))
    tree = ast.parse((root / PACKAGE / "__init__.pyi").read_text(encoding="utf-8"))
    text = "## hwffd\n\n"
    functions = [one for one in tree.body if isinstance(one, ast.FunctionDef)]
    text += "### Functions\n\n" + "".join(_entry(_signature(one), said.get(one.name)) for one in functions)
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            owner = node.name
            text += _class(node, lambda one, owner=owner: said.get(
                owner if isinstance(one, ast.ClassDef) else f"{owner}.{one.name}"), said)
    return text


def _volumes(root):
    """What hwffd.volumes gives, in the order of its __all__."""
    folder = root / PACKAGE / "volumes"
    package = ast.parse((folder / "__init__.py").read_text(encoding="utf-8"))
    (names,) = [ast.literal_eval(one.value) for one in package.body
                if isinstance(one, ast.Assign) and ast.unparse(one.targets[0]) == "__all__"]
    found = {node.name: node for path in sorted(folder.glob("*.py"))
             for node in ast.parse(path.read_text(encoding="utf-8")).body
             if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name in names}
    text = "## hwffd.volumes\n\n"
    for name in sorted(names, key=lambda one: (one[0].islower(), one)):
        node = found[name]
        if isinstance(node, ast.ClassDef):
            text += _class(node, ast.get_docstring)
        else:
            text += f"### {name}\n\n" + _entry(_signature(node), ast.get_docstring(node))
    return text


def page(root):
    return f"{_HEAD}\n{_bound(root)}{_volumes(root)}"
