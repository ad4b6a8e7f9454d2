"""Whether every arm of a generate construct has a name, gen_..., in Verilog as pyslang parses it.

SPDX-License-Identifier: Apache-2.0
"""

import re

from pyslang import syntax
from pyslang.syntax import SyntaxKind


def _arms(node):
    """Those of a construct; an if behind an else is another one."""
    if node.kind == SyntaxKind.LoopGenerate:
        return [node.block]
    if node.kind == SyntaxKind.IfGenerate:
        other = [node.elseClause.clause] if node.elseClause else []
        return [node.block, *(arm for arm in other if arm.kind != SyntaxKind.IfGenerate)]
    return [item.clause for item in node.items] if node.kind == SyntaxKind.CaseGenerate else []


def _complaint(arm):
    if arm.kind != SyntaxKind.GenerateBlock:
        return "generate arm without begin : gen_..."
    if arm.beginName is None:
        return "generate arm without a name: begin : gen_..."
    name = arm.beginName.name.valueText
    return "" if re.fullmatch("gen_[a-z0-9_]+", name) else f"generate arm named {name}, gen_... wanted"


def problems(code):
    """[(line, message)]"""
    tree, faults = syntax.SyntaxTree.fromText(code), []

    def visit(node):
        for arm in _arms(node) if isinstance(node, syntax.SyntaxNode) else ():
            if complaint := _complaint(arm):
                line = tree.sourceManager.getLineNumber(arm.getFirstToken().location)
                faults.append((line, complaint))

    tree.root.visit(visit)
    return faults
