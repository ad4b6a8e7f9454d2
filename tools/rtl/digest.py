"""Keys of results: what a result depends on, in sixteen digits. Equal keys mean equal results.

Comments, blanks and the folders of files change nothing: Verilog counts as the tokens that are left
of it after preprocessing, Python as its statements, other texts as their lines without comments.

SPDX-License-Identifier: Apache-2.0
"""

import ast
import functools
import hashlib
import pathlib
import re

from tools.rtl import rtl_sources

_TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|\w+|[^\w\s"]+')


def of(*texts):
    """The key of these strings, in this order."""
    digest = hashlib.sha256()
    for part in texts:
        digest.update(hashlib.sha256(part.encode()).digest())
    return digest.hexdigest()[:16]


@functools.lru_cache(maxsize=None)
def tokens(files, folders, *defined):
    """What is left of Verilog files once they have been preprocessed, as the key of their tokens. A
    file that cannot be preprocessed counts with the complaint: yosys will say what is wrong."""
    status, text = rtl_sources.run(["verilator", "-E", "-P", *(f"-D{name}" for name in defined),
                                    *(f"-I{folder}" for folder in folders), *files])
    return of(str(status), *_TOKEN.findall(text)) if status == 0 else of(str(status), text)


@functools.lru_cache(maxsize=None)
def statements(*modules):
    """Of Python modules, without comments and docstrings."""
    texts = []
    for module in modules:
        tree = ast.parse(pathlib.Path(module.__file__).read_text(encoding="utf-8"))
        for node in ast.walk(tree):
            if isinstance(getattr(node, "body", None), list):
                node.body = [line for line in node.body if not (
                    isinstance(line, ast.Expr) and isinstance(line.value, ast.Constant))]
        texts.append(ast.unparse(tree))
    return of(*texts)


@functools.lru_cache(maxsize=None)
def lines(*paths):
    """Of scripts and tables, without blank lines and those that begin with #."""
    return of(*(line for path in paths for line in pathlib.Path(path).read_text(
        encoding="utf-8", errors="replace").splitlines() if line.strip() and line[0] != "#"))
