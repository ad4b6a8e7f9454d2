"""Calls with arguments of the wrong kinds end with a UsageError of one line, as all that is refused.

SPDX-License-Identifier: Apache-2.0
"""

import functools
import re

from hwffd._core import UsageError


def _wanted(function):
    """The arguments of a function of _core, as the first line of its docstring has them."""
    line = function.__doc__.splitlines()[0]
    inner = line[line.index("("):line.rindex(" ->")]
    return re.sub(r"self: \w+(, )?", "", re.sub(r"\b(hwffd|_core|typing|collections|abc)\.", "", inner))


def refusing(function, name=None, bound=0):
    """The same function, whose refusals of arguments are UsageErrors.

    name: in their texts, where it is not the function's; bound: arguments that no caller writes, 1 for self.
    """
    @functools.wraps(function)
    def call(*arguments, **named):
        try:
            return function(*arguments, **named)
        except TypeError as error:
            if isinstance(error, UsageError) or "incompatible" not in str(error):
                raise
        kinds = [type(value).__name__ for value in arguments[bound:]]
        kinds += [f"{key}={type(value).__name__}" for key, value in named.items()]
        raise UsageError(f"{name or function.__name__}: arguments ({', '.join(kinds)}); give {_wanted(function)}")
    return call


def refuse_in(kind):
    """Replaces the methods of a class, and what makes its objects, by such functions."""
    for name, member in list(vars(kind).items()):
        if isinstance(member, staticmethod):
            setattr(kind, name, staticmethod(refusing(member.__func__)))
        elif callable(member) and (name == "__init__" or not name.startswith("_")):
            setattr(kind, name, refusing(member, kind.__name__ if name == "__init__" else name, bound=1))
