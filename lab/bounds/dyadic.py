"""Numbers m 2^-k: what Gappa and Coq take exactly.

SPDX-License-Identifier: Apache-2.0
"""

import fractions
import math
from dataclasses import dataclass


@dataclass(frozen=True)
class Dyadic:
    """mantissa x 2^exponent."""

    mantissa: int
    exponent: int

    def __float__(self):
        return float(self.value())

    def value(self):
        return self.mantissa * fractions.Fraction(2) ** self.exponent

    def gappa(self):
        return f"{self.mantissa}b{self.exponent}" if self.mantissa else "0"

    def coq(self):
        return f"(float2R (Float2 ({self.mantissa}) ({self.exponent})))"


def power(exponent):
    """2^exponent."""
    return Dyadic(1, exponent)


def exact(value):
    """A fraction whose denominator is a power of two."""
    value = fractions.Fraction(value)
    exponent = 1 - value.denominator.bit_length()
    if value.denominator != 1 << -exponent:
        raise ValueError(f"{value} is no multiple of a power of two")
    mantissa = value.numerator
    while mantissa and mantissa % 2 == 0:  # as Gappa writes them
        mantissa, exponent = mantissa // 2, exponent + 1
    return Dyadic(mantissa, exponent if mantissa else 0)


def above(value, bits=16):
    """The least number of so many bits that is no smaller."""
    value = fractions.Fraction(value)
    if value <= 0:
        return Dyadic(0, 0)
    exponent = 0
    while value * fractions.Fraction(2) ** -exponent >= 1 << bits:
        exponent += 1
    while value * fractions.Fraction(2) ** -exponent < 1 << (bits - 1):
        exponent -= 1
    return exact(math.ceil(value * fractions.Fraction(2) ** -exponent) * fractions.Fraction(2) ** exponent)
