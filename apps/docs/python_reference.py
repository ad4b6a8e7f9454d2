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
    decorators = {ast.unparse(decorator) for decorator in node.decorator_list}
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
    fields = [statement for statement in node.body if isinstance(statement, ast.AnnAssign)]
    for member in fields:
        text += _entry(ast.unparse(member), attributes and attributes.get(f"{node.name}.{member.target.id}", ""))
    for member in node.body:
        if isinstance(member, ast.FunctionDef) and (member.name == "__init__" or not member.name.startswith("_")):
            text += _entry(_signature(member), doc_of(member))
    return text


def _bound(root):
    """The package's own part, of C++."""
    texts = docstrings(sorted((root / "api/python/src").glob("*.cpp")))
    tree = ast.parse((root / PACKAGE / "__init__.pyi").read_text(encoding="utf-8"))
    text = "## hwffd\n\n"
    functions = [statement for statement in tree.body if isinstance(statement, ast.FunctionDef)]
    text += "### Functions\n\n" + "".join(_entry(_signature(func), texts.get(func.name)) for func in functions)
    for node in tree.body:
        if isinstance(node, ast.ClassDef):
            owner = node.name
            text += _class(node, lambda member, owner=owner: texts.get(
                owner if isinstance(member, ast.ClassDef) else f"{owner}.{member.name}"), texts)
    return text


def _volumes(root):
    """What hwffd.volumes gives, in the order of its __all__."""
    folder = root / PACKAGE / "volumes"
    package = ast.parse((folder / "__init__.py").read_text(encoding="utf-8"))
    (names,) = [ast.literal_eval(statement.value) for statement in package.body
                if isinstance(statement, ast.Assign) and ast.unparse(statement.targets[0]) == "__all__"]
    nodes = {node.name: node for path in sorted(folder.glob("*.py"))
             for node in ast.parse(path.read_text(encoding="utf-8")).body
             if isinstance(node, (ast.FunctionDef, ast.ClassDef)) and node.name in names}
    text = "## hwffd.volumes\n\n"
    for name in sorted(names, key=lambda name: (name[0].islower(), name)):
        node = nodes[name]
        if isinstance(node, ast.ClassDef):
            text += _class(node, ast.get_docstring)
        else:
            text += f"### {name}\n\n" + _entry(_signature(node), ast.get_docstring(node))
    return text


def page(root):
    return f"{_HEAD}\n{_bound(root)}{_volumes(root)}"
