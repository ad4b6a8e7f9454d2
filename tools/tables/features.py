"""FEATURES by names, `pages+resident`: which bit each of them is, the register of that name in rtl/bus/registers.csv says.

SPDX-License-Identifier: Apache-2.0
"""

from tools.csv_table import TableError
from tools.tables import register_texts, registers

BITS = {field.name: field.mask for field in register_texts.features(registers.read())}


def value(text, where):
    """The number of such names, each once. Raises TableError."""
    names = text.split("+")
    for name in names:
        if name not in BITS or names.count(name) > 1:
            raise TableError(f"{where}: FEATURES={text}: {'twice' if name in BITS else 'unknown feature'} '{name}': "
                             f"some of {', '.join(BITS)} wanted, with + between")
    return sum(BITS[name] for name in names)
