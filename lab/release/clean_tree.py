"""The commit at hand, of a tree that is what it says.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess

from tools import command_line


def git(root, *words):
    """What git prints. Raises Request where there is no checkout."""
    result = subprocess.run(["git", "-C", root, *words], capture_output=True, text=True, check=False)
    if result.returncode:
        raise command_line.Request(f"not a checkout of git: {result.stderr.strip().splitlines()[-1]}")
    return result.stdout.rstrip("\n")


def commit(root, beside=()):
    """Its full name. Raises Request where the tree has local changes. Those of files that are as `beside` do not count, nor
    do commits that change nothing else: the tree that counts is that of the commit before them."""
    places = [".", *(f":(exclude){pattern}" for pattern in beside)]
    changed = git(root, "status", "--porcelain", "--untracked-files=all", "--", *places).splitlines()
    if changed:
        raise command_line.Request(f"the tree has local changes, {changed[0][3:]} and {len(changed) - 1} more: commit them first"
                                   if changed[1:] else f"the tree has a local change, {changed[0][3:]}: commit it first")
    return git(root, "log", "-1", "--format=%H", "--", *places) if beside else git(root, "rev-parse", "HEAD")
