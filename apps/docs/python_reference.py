"""The Python packages as mkdocstrings reads them: hwffd's stub with the docstrings of its bindings, and hwffd.volumes.

SPDX-License-Identifier: Apache-2.0
"""

import ast

from apps.docs.bindings import docstrings

PACKAGE = "api/python/hwffd"
PAGE = """# Python

The package `hwffd` works on arrays of NumPy; [python](../python.md) has examples. `hwffd.volumes` resamples images
of medicine and needs SciPy ([volumes](../volumes.md)).

::: hwffd

::: hwffd.volumes
"""
_NAMED = (ast.FunctionDef, ast.ClassDef, ast.AnnAssign)


def _shown(words):
    """Docstrings name arrays and code without marks: shown as they stand, but code that is set apart."""
    lines = [line if line.startswith("    ") else line.replace("*", "\\*").replace("_", "\\_").replace("<", "&lt;")
             for line in words.splitlines()]
    return ast.Expr(ast.Constant("\n".join(lines)))


def _document(node, texts, owner=""):
    """Gives what the body of a module or class names these docstrings, or else its own."""
    for child in [child for child in node.body if isinstance(child, _NAMED)]:
        name = f"{owner}{child.target.id if isinstance(child, ast.AnnAssign) else child.name}"
        own = "" if isinstance(child, ast.AnnAssign) else ast.get_docstring(child) or ""
        words = texts.get(name, own)
        if isinstance(child, ast.AnnAssign):
            node.body.insert(node.body.index(child) + 1, _shown(words))
        else:
            child.body[:1 if own else 0] = [_shown(words)] if words else []
        if isinstance(child, ast.ClassDef):
            _document(child, texts, f"{name}.")


def stage(root, target):
    """Fills `target`/hwffd."""
    texts = docstrings(sorted((root / "api/python/src").glob("*.cpp")))
    folder = root / PACKAGE
    for path in (folder / "__init__.pyi", *folder.glob("volumes/*.py")):
        tree = ast.parse(path.read_text(encoding="utf-8"))
        _document(tree, texts if path.suffix == ".pyi" else {})
        place = target / "hwffd" / path.relative_to(folder).with_suffix(".py")
        place.parent.mkdir(parents=True, exist_ok=True)
        place.write_text(ast.unparse(ast.fix_missing_locations(tree)), encoding="utf-8")
