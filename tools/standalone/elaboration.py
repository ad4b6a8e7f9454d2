"""What of the RTL a core consists of: the modules of its hierarchy, and the arms of generates that are taken.

SPDX-License-Identifier: Apache-2.0
"""

import itertools
import random
from collections import Counter

import pyslang
from pyslang import ast, syntax

from tools.rtl import rtl_sources
from tools.rtl.memories import MEMORY, Shape

COMBINATIONS = 30  # of free parameters, drawn, besides each value of each


def place(node):
    """Where a piece of source stands, as a key."""
    start = node.sourceRange.start
    return start.buffer.id, start.offset


class Design:
    """The sources that a top may need, parsed; and what its elaborations had."""

    def __init__(self, top, sources=None):
        sources = sources or rtl_sources.Sources()
        self.top, self.manager = top, pyslang.SourceManager()
        for folder in sources.includes:
            self.manager.addUserDirectories(folder)
        self.files = {}  # module -> path
        self.trees = {}  # module -> tree
        for path in sources.needed(top):
            module = next(name for name, of in sources.files.items() if str(of) == path)
            self.files[module] = path
            self.trees[module] = syntax.SyntaxTree.fromFile(path, self.manager)
        self.modules = {}  # name -> {parameter: value} of its first instance, in the order in which they come
        self.relied = {}  # name -> parameters that some instance leaves at their default
        self.arms = set()  # places of generate blocks that are taken
        self.refusals = []  # of the last elaboration
        self.memories = None  # of the first elaboration: Shape -> how many
        self.ports = {}  # of the top: name -> (direction, bits)
        self.known = {}  # (module, values of its parameters), nothing of which is refused -> its memories

    def elaborate(self, parameters):
        """Adds what a configuration has. Raises ValueError where the RTL refuses it."""
        if guards := self.guards(parameters):
            raise ValueError(f"the RTL refuses it by {guards[0]}")

    def guards(self, parameters):
        """The same, but the names of the guards that refuse it."""
        self.refusals = []
        options = ast.CompilationOptions()
        options.topModules = {self.top}
        options.paramOverrides = [f"{name}={value}" for name, value in parameters.items()]
        bag = pyslang.Bag()
        bag.compilationOptions = options
        compilation = ast.Compilation(bag)
        for tree in self.trees.values():
            compilation.addSyntaxTree(tree)
        top = compilation.getRoot().topInstances[0]
        memories = self._instance(top)
        if self.memories is None:
            self.memories = memories
        if not self.ports:
            self.ports = {port.name: ("input" if port.direction == ast.ArgumentDirection.In else "output",
                                      port.type.bitWidth) for port in top.body.portList}
        return self.refusals

    def _instance(self, instance):
        """The memories of an instance. What has been looked at with these parameters, in this elaboration or before, is not
        looked at again."""
        body = instance.body
        name = body.definition.name
        parameters = [parameter for parameter in body.parameters if parameter.isPortParam]
        # A default that an instance relies on stays as it is.
        self.relied.setdefault(name, set()).update(
            parameter.name for parameter in body.parameters if not parameter.isOverridden)
        key = name, tuple(str(parameter.value) for parameter in parameters)
        if key in self.known:
            return self.known[key]
        self.modules.setdefault(name, _values(body))
        memories = Counter([Shape(*map(_values(body).get, ("WIDTH", "DEPTH", "READ_LATENCY")))] if name == MEMORY else [])
        refused = len(self.refusals)
        self._members(body, memories)
        if len(self.refusals) == refused:
            self.known[key] = memories
        return memories

    def _members(self, scope, memories):
        for member in scope:
            if member.kind == ast.SymbolKind.Instance:
                memories.update(self._instance(member))
            elif member.kind == ast.SymbolKind.InstanceArray:
                for instance in member.elements:
                    memories.update(self._instance(instance))
            elif member.kind == ast.SymbolKind.GenerateBlockArray:
                for block in member.entries:
                    self._block(block, memories)
            elif member.kind == ast.SymbolKind.GenerateBlock:
                self._block(member, memories)
            elif member.kind == ast.SymbolKind.UninstantiatedDef:
                self.refusals.append(member.definitionName)

    def _block(self, block, memories):
        if not block.isUninstantiated:
            self.arms.add(place(block.syntax))
            self._members(block, memories)


def _values(body):
    """Parameter -> number, of those of an instance that are given one in its header."""
    return {parameter.name: int(parameter.value.value) for parameter in body.parameters
            if parameter.isPortParam and parameter.type.bitWidth <= 32}


def of_core(core):
    """The design of a core, with all that any value of its free parameters wants. Raises ValueError."""
    design = Design(core.top)
    for values in combinations(core):
        design.elaborate({**core.parameters, **values})
    return design


def combinations(core):
    """Values of the free parameters: those of the core, each other value of each, and some drawn."""
    yield {}
    for free in core.free.values():
        for value in free.samples():
            yield {free.name: value}
    if core.free:
        drawn = random.Random(1)
        for _ in itertools.repeat(None, COMBINATIONS):
            yield {free.name: drawn.choice(free.samples()) for free in core.free.values()}
