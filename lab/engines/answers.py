"""Answers of an engine, in files that all of them write alike, and how far two of them are the same.

SPDX-License-Identifier: Apache-2.0
"""

import itertools
from dataclasses import dataclass


class AnswerError(Exception):
    """Answers that are not there, in one line."""


@dataclass(frozen=True)
class Answers:
    """A line a result, tlast and four words, and how often each event was."""

    results: tuple
    events: tuple


def beats(path):
    """The lines of a file of beats. Raises AnswerError where it has none."""
    lines = path.read_text(encoding="ascii").splitlines() if path.is_file() else []
    answers = tuple(line for line in lines if line and not line.startswith("//"))
    if not answers:
        raise AnswerError(f"{path}: no beats")
    return answers


def read(folder):
    """The Answers in a folder. Raises AnswerError."""
    path = folder / "events.txt"
    events = path.read_text(encoding="ascii").split() if path.is_file() else []
    if not events:
        raise AnswerError(f"{path}: no counts of events")
    return Answers(beats(folder / "results.txt"), tuple(map(int, events)))


def differing(got, wanted):
    """Places at which two rows differ, where one has nothing too."""
    return sum(a != b for a, b in itertools.zip_longest(got, wanted))


def mismatches(got, wanted):
    """Results that differ, are absent or should not be there, and events that were not as often."""
    return differing(got.results, wanted.results) + differing(got.events, wanted.events)
