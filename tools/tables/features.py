"""What a core has, by names, `pages+resident`: which bit of the register FEATURES each of them is, rtl/bus/registers.csv
says; a parameter of the tops each of them is, but for two that follow from others.

SPDX-License-Identifier: Apache-2.0
"""

from tools.csv_table import TableError
from tools.tables import register_texts, registers

BITS = {field.name: field.mask for field in register_texts.features(registers.read())}
CORES = ("hwffd_stream", "hwffd_stream_bus", "hwffd_axi", "hwffd_wishbone", "hwffd_adjoint")  # whose parameters they are
USUAL = "resident+interleaved+derivatives+determinant"  # of rows of tables that do not say

FOLLOWS = register_texts.FOLLOWS  # name -> a parameter, and above which value of it a core has the feature
PARAMETERS = {name: register_texts.parameter(name) for name in BITS if name not in FOLLOWS}


def value(text, where):
    """The number of such names, each once. Raises TableError."""
    names = text.split("+")
    for name in names:
        if name not in BITS or names.count(name) > 1:
            raise TableError(f"{where}: FEATURES={text}: {'twice' if name in BITS else 'unknown feature'} '{name}': "
                             f"some of {', '.join(BITS)} wanted, with + between")
    return sum(BITS[name] for name in names)


def parameters_of(number):
    """{parameter: 0 or 1} of such a number."""
    return {parameter: int(number & BITS[name] != 0) for name, parameter in PARAMETERS.items()}


def has(parameters, name):
    """Whether a core with these parameters has a feature; one that follows from a parameter needs it to be given."""
    if name in FOLLOWS:
        parameter, most = FOLLOWS[name]
        return parameters.get(parameter, most) > most
    return parameters[PARAMETERS[name]] != 0


def followed(text):
    """Of such names those that are no parameter, since they follow from others."""
    return [name for name in text.split("+") if name in FOLLOWS]


def names_of(parameters):
    """Names of what a core with these parameters has."""
    return [name for name in BITS if has(parameters, name)]


def number_of(parameters):
    """The word of a core with these parameters, that of the register FEATURES."""
    return sum(BITS[name] for name in names_of(parameters))


def of_top(top, parameters):
    """The parameters of a row of a table as a top takes them: of a core what it has by names, in place of FEATURES, or
    the usual. Raises TableError where those that follow are not as the row says."""
    if top not in CORES:
        return parameters
    others = {name: number for name, number in parameters.items() if name != "FEATURES"}
    wanted = parameters.get("FEATURES", value(USUAL, "USUAL"))
    for name in FOLLOWS:
        if has(others, name) != (wanted & BITS[name] != 0):
            raise TableError(f"{top}: FEATURES have {name} where, and only where, {register_texts.condition(name)}")
    return {**others, **{name: has for name, has in parameters_of(wanted).items() if name not in others}}
