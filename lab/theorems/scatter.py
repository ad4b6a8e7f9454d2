"""The units of scatter, and that what an expansion gives its four banks sums to the part, for every width.

Compared with docs/numerics.md section 11, in words so wide that nothing is lost.

SPDX-License-Identifier: Apache-2.0
"""

from lab.theorems.fixed import half_up, product, saturated, weight
from lab.theorems.netlist import Bug
from lab.theorems.prove import Case, Theorem
from lab.theorems.terms import const, every, ite

FORMATS = (17, *range(12, 17), 18)
ALL_LATENCIES = (17, 18)  # formats whose units are read at several latencies


def cumulate(unit, p):
    form = p["FORMAT"]
    a, b, out = (weight(word, form) for word in (unit.inputs["a_i"], unit.inputs["b_i"], unit.outputs["weight_o"]))
    value, over = saturated(a.value.sext(form + 2) + b.value.sext(form + 2), form)
    return [], every(out.value.eq(value), out.flag.eq(a.flag | b.flag | over))


def share(unit, p):
    """Of a weight and a part; the weight's flag is not looked at."""
    form, part = p["FORMAT"], unit.inputs["part_i"]
    factor = weight(unit.inputs["weight_i"], form).value.sext(part.width)
    whole, assumed = product(factor, part, p["MUL_LATENCY"])
    value, over = saturated(half_up(whole.sext(2 * part.width + 2), form - 2), part.width)
    return assumed, every(unit.outputs["share_o"].eq(value), unit.outputs["saturated_o"].eq(over))


def less(unit, _):
    a, b = unit.inputs["a_i"], unit.inputs["b_i"]
    value, over = saturated(a.sext(a.width + 2) - b.sext(a.width + 2), a.width)
    return [], every(unit.outputs["part_o"].eq(value),
                     unit.outputs["saturated_o"].eq(unit.inputs["saturated_i"] | over))


def conserved(unit, _):
    """Whatever the products are."""
    part, parts = unit.inputs["part_i"], unit.outputs["parts_o"]
    bits, wide = part.width, part.width + 3
    whole = ite(unit.inputs["whole_i"].eq(1), part.sext(wide), const(0, wide))
    total = const(0, wide)
    for bank in range(4):
        total = total + parts.bits(bits * bank + bits - 1, bits * bank).sext(wide)
    return [unit.outputs["saturated_o"].eq(0)], total.eq(whole)


def _cases(unit, claim, names, latencies, latency=sum):
    """A case for each format at the first latencies, and at all of them for some formats."""
    return tuple(Case(unit, {"FORMAT": form, **dict(zip(names, clocks))}, latency(clocks), claim)
                 for form in FORMATS for clocks in (latencies if form in ALL_LATENCIES else latencies[:1]))


_MUL_ADD = ("MUL_LATENCY", "ADD_LATENCY")
_W = "W 12 to 18"

THEOREMS = (
    Theorem("num.cumulate", "weight + weight, saturated and flagged.", _W,
            Bug("ffd_num_cumulate", "a_i[W] | b_i[W]", "a_i[W] & b_i[W]"),
            _cases("ffd_num_cumulate", cumulate, ("LATENCY",), ((1,), (0,), (2,))), quick=True),
    Theorem("num.share", "weight x part, rounded half up once to a part, saturated and flagged.", _W,
            Bug("ffd_num_share", ".DROP   (W - 2)", ".DROP   (W - 1)"),
            _cases("ffd_num_share", share, _MUL_ADD, ((4, 1), (1, 1), (2, 1), (3, 2), (5, 1))),
            note="products shared"),
    Theorem("num.less", "part - part, saturated and flagged.", _W,
            Bug("ffd_num_less", "{b_i[PART_W-1], b_i}", "{1'b0, b_i}"),
            _cases("ffd_num_less", less, ("LATENCY",), ((1,), (2,))), quick=True),
    Theorem("scatter.expand", "Where nothing saturates, the parts of four banks sum to the part, or of a derivative to "
            "0, to the bit.", _W,
            Bug("ffd_scatter_expand", "shares[(b-1)*PART_W +: PART_W]", "shares[0 +: PART_W]"),
            _cases("ffd_scatter_expand", conserved, _MUL_ADD, ((4, 1), (1, 1), (2, 1), (3, 2)),
                   lambda clocks: clocks[0] + 2 * clocks[1]),
            note="whatever the products are", quick=True),
)
