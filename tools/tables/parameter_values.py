"""Sets of values that a parameter may have: numbers, ranges, powers of two.

SPDX-License-Identifier: Apache-2.0
"""

from dataclasses import dataclass
from typing import Optional


def listed(words):
    """a, b and c"""
    *others, last = map(str, words)
    return f"{', '.join(others)} and {last}" if others else last


@dataclass(frozen=True)
class Between:
    """All numbers from one to another, or without an end."""

    least: int
    most: Optional[int] = None

    def __contains__(self, value):
        return self.least <= value and (self.most is None or value <= self.most)

    def __str__(self):
        if self.most is None:
            return f"{self.least} or more"
        return str(self.least) if self.least == self.most else f"{self.least} to {self.most}"

    def ends(self):
        return [self.least] if self.most is None else [self.least, self.most]

    def neighbours(self):
        return [end + step for end in self.ends() for step in (-1, 1)]


@dataclass(frozen=True)
class Powers:
    """Powers of two from one to another, or without an end."""

    least: int
    most: Optional[int] = None

    def __contains__(self, value):
        return value > 0 and value & (value - 1) == 0 and value in Between(self.least, self.most)

    def __str__(self):
        return f"a power of two, {Between(self.least, self.most)}"

    def ends(self):
        return Between(self.least, self.most).ends()

    def neighbours(self):
        return [self.least // 2, 3 * self.least, *([] if self.most is None else [2 * self.most])]


@dataclass(frozen=True)
class Values:
    """Any of some sets."""

    parts: tuple

    def __contains__(self, value):
        return any(value in part for part in self.parts)

    def __str__(self):
        texts = list(map(str, self.parts))
        return " or ".join([", ".join(texts[:-1]), texts[-1]]) if texts[1:] else texts[0]

    def ends(self):
        """The first and the last of each set."""
        return sorted({end for part in self.parts for end in part.ends()})

    def beyond(self):
        """Values next to those that are in none of the sets."""
        return sorted({value for part in self.parts for value in part.neighbours() if value not in self})


def of(*values):
    """Values of numbers and sets; three numbers or more that follow each other are one set."""
    numbers = sorted(part for part in values if isinstance(part, int))
    runs = []
    for number in numbers:
        if runs and runs[-1][-1] + 1 == number:
            runs[-1].append(number)
        else:
            runs.append([number])
    sets = []
    for run in runs:
        sets += [Between(run[0], run[-1])] if len(run) > 2 else [Between(number, number) for number in run]
    return Values((*sets, *(part for part in values if not isinstance(part, int))))
