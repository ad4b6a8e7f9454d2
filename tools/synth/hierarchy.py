"""The modules of a mapped design as a tree: how many instances of each, and what they cost.

A node stands for all instances of one module below its parent, whatever their parameters. What
is under 1 % of everything is folded into its parent.

SPDX-License-Identifier: Apache-2.0
"""

from collections import Counter
from dataclasses import dataclass, field

from tools.rtl.rtl_sources import module_of
from tools.synth import mapped_netlist

TARGET = "ecp5"
FIELDS = ("lut", "ff", "dsp", "bram")  # of a node; LUTs include those used as memory
SHOWN = ("lut", "dsp", "bram")         # of which 1 % keeps a node from being folded
SMALL = 0.01


@dataclass
class Node:
    module: str
    instances: int
    counts: Counter  # of all instances, with what is inside them
    children: list = field(default_factory=list)

    def own(self):
        """What lies in none of its children."""
        inside = Counter()
        for child in self.children:
            inside.update(child.counts)
        return Counter({name: self.counts[name] - inside[name] for name in FIELDS})

    def walk(self, depth=0):
        """(depth, node), parents first."""
        yield depth, self
        for child in self.children:
            yield from child.walk(depth + 1)


class Design:
    """A netlist in which every module has been mapped by itself."""

    def __init__(self, netlist, top):
        self.netlist, self.top = netlist, top
        self._counts = {}

    def counts(self, module):
        """Of one instance, with what is inside it."""
        if module not in self._counts:
            counted = mapped_netlist.count(TARGET, self.netlist, module)
            self._counts[module] = Counter({
                "lut": counted["lut"] + counted["lutram"],
                **{name: counted[name] for name in FIELDS if name != "lut"}})
        return self._counts[module]

    def tree(self):
        root = self._node(Counter({self.top: 1}))
        _fold(root, root.counts)
        return root

    def _node(self, variants):
        """Of {module with its parameters: instances}, all of one name."""
        total, below = Counter(), {}
        for variant, instances in variants.items():
            for name, each in self.counts(variant).items():
                total[name] += instances * each
            for cell in self.netlist["modules"][variant]["cells"].values():
                if cell["type"] in self.netlist["modules"]:
                    kind = below.setdefault(module_of(cell["type"]), Counter())
                    kind[cell["type"]] += instances
        children = [self._node(kind) for kind in below.values()]
        children.sort(key=lambda node: [-node.counts[name] for name in FIELDS] + [node.module])
        return Node(module_of(next(iter(variants))), sum(variants.values()), total, children)


def _small(node, everything):
    return all(node.counts[name] < SMALL * everything[name] or not node.counts[name]
               for name in SHOWN)


def _fold(node, everything):
    node.children = [child for child in node.children if not _small(child, everything)]
    for child in node.children:
        _fold(child, everything)
