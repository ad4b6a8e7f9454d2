"""IEEE-754 by whole numbers: what a word is worth, and the one word that an exact number rounds to.

Written from the standard and docs/numerics.md section 2, wide and slow, with nothing of the units'
shortcuts: no sticky bit, no swapped operands, no shared shift. A number is (-1)^sign times a whole
magnitude times 2^exponent.

SPDX-License-Identifier: Apache-2.0
"""

from dataclasses import dataclass

from lab.theorems.terms import concat, const, either, every, ite


@dataclass(frozen=True)
class Format:
    """Bits of the exponent, and of the significand with its hidden bit."""

    exponent: int = 8
    significand: int = 24

    @property
    def width(self):
        return self.exponent + self.significand

    @property
    def bias(self):
        return (1 << (self.exponent - 1)) - 1

    @property
    def lowest(self):
        """The exponent of the smallest subnormal number."""
        return 2 - self.bias - self.significand

    @property
    def nan(self):
        return ((1 << self.exponent) - 1) << (self.significand - 1) | 1 << (self.significand - 2)

    @property
    def infinity(self):
        return ((1 << self.exponent) - 1) << (self.significand - 1)


BINARY32 = Format()


@dataclass(frozen=True)
class Number:
    """What a word says."""

    sign: object
    significand: object  # with the hidden bit
    place: object        # the exponent of its lowest bit, less the lowest there is; not negative
    nan: object
    infinite: object
    zero: object


def number(word, form=BINARY32):
    fraction = word.bits(form.significand - 2, 0)
    field = word.bits(form.width - 2, form.significand - 1)
    subnormal, special = field.eq(0), field.eq((1 << form.exponent) - 1)
    return Number(
        sign=word.bit(form.width - 1),
        significand=ite(subnormal, fraction.zext(form.significand), concat(const(1, 1), fraction)),
        place=ite(subnormal, const(0, form.exponent), field - 1),
        nan=every(special, fraction.any()), infinite=every(special, fraction.eq(0)),
        zero=every(subnormal, fraction.eq(0)))


def leading(magnitude, width):
    """The place of the highest one; 0 if there is none."""
    position = const(0, width)
    for place in range(magnitude.width):
        position = ite(magnitude.bit(place), const(place, width), position)
    return position


def rounded(sign, magnitude, exponent, form=BINARY32):
    """The word nearest to the number, ties to the even one. The exponent is a signed word."""
    wide = max(exponent.width, magnitude.width.bit_length() + 1, form.exponent + 2) + 2
    exponent = exponent.sext(wide)
    top = leading(magnitude, wide) + exponent
    lowest = const(form.lowest, wide)
    unit = top - (form.significand - 1)        # the exponent of the result's last bit
    unit = ite(unit.slt(lowest), lowest, unit)
    drop = unit - exponent
    # Beyond all bits, how far does not matter: less than half of the last bit is left.
    most = magnitude.width + 1
    size = magnitude.width + form.significand + 1
    far = ~drop.slt(most)
    amount = ite(far, const(most, wide), drop)
    frame = magnitude.zext(size)
    up = frame << (-drop).zext(size) if size >= wide else frame << (-drop).bits(size - 1, 0)
    by = amount.zext(size) if size >= wide else amount.bits(size - 1, 0)
    down = frame >> by
    rest = (frame - (down << by)) << 1
    whole = const(1, size) << by
    more = either(rest > whole, every(rest.eq(whole), down.bit(0)))
    exact = drop.slt(1)
    significand = ite(exact, up, down + more.zext(size)).bits(form.significand, 0)
    carried = significand.bit(form.significand)
    significand = ite(carried, significand >> 1, significand)
    unit = ite(carried, unit + 1, unit)
    normal = significand.bit(form.significand - 1)
    field = ite(normal, unit - lowest + 1, const(0, wide))
    word = concat(sign, field.bits(form.exponent - 1, 0), significand.bits(form.significand - 2, 0))
    word = ite(~field.slt((1 << form.exponent) - 1), infinity(sign, form), word)
    return ite(significand.eq(0), const(0, form.width), word)  # docs/numerics.md: a zero is +0


def infinity(sign, form=BINARY32):
    return concat(sign, const(form.infinity, form.width - 1))


def product(one, other, magnitude, form=BINARY32):
    """The product of two numbers, the product of their significands given."""
    sign = one.sign ^ other.sign
    wide = form.exponent + form.significand.bit_length() + 2
    exponent = one.place.zext(wide) + other.place.zext(wide) + const(2 * form.lowest, wide)
    nan = either(one.nan, other.nan, every(one.infinite, other.zero), every(one.zero, other.infinite))
    word = rounded(sign, magnitude, exponent, form)
    word = ite(either(one.infinite, other.infinite), infinity(sign, form), word)
    return ite(nan, const(form.nan, form.width), word)
