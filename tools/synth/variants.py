"""synth/variants.csv: cores with a parameter other than their row's, which say what a feature costs.

SPDX-License-Identifier: Apache-2.0
"""

import re
from dataclasses import dataclass

from tools import csv_table
from tools.tables import configurations, features

COLUMNS = ("name", "variant", "top", "parameters", "meaning")


@dataclass(frozen=True)
class Variant:
    """A row of the table of configurations with other parameters; it stands where a row stands."""

    row: configurations.Configuration
    variant: str
    more: tuple  # pairs of a parameter and its value
    meaning: str

    @property
    def name(self):
        return f"{self.row.name}+{self.variant}"

    @property
    def parameters(self):
        return {**self.row.parameters, **dict(self.more)}

    def __getattr__(self, field):
        return getattr(self.row, field)


def _parameters(text, where):
    pairs = [word.partition("=")[::2] for word in text.split()]
    if not pairs or not all(re.fullmatch(r"[A-Z][A-Z0-9_]*", name) and re.fullmatch(
            r"[a-z+]+" if name == "FEATURES" else r"[0-9]+", value) for name, value in pairs):
        raise csv_table.TableError(f"{where}: parameters '{text}': NAME=NUMBER wanted, with spaces between, or "
                                   f"FEATURES=NAME+NAME of {', '.join(features.BITS)}")
    return tuple((name, features.value(value, f"{where}: parameters") if name == "FEATURES" else int(value))
                 for name, value in pairs)


def read(path, rows, tops):
    """[(variant, its top)] of rows of the table, in order. Raises TableError."""
    by_key, known = {}, {row.name: row for row in rows}
    for where, fields in csv_table.read(path, COLUMNS):
        row = known[csv_table.word(fields, "name", where, known)]
        variant = Variant(row, fields["variant"], _parameters(fields["parameters"], where),
                          fields["meaning"])
        key = (variant.name, csv_table.word(fields, "top", where, tops))
        csv_table.unique(by_key, key, "variant", where)
        by_key[key] = variant
    return [(variant, top) for (_, top), variant in by_key.items()]
