"""Pickles and copies of the classes of _core, in every protocol. Those of a subclass keep their class and
attributes.

SPDX-License-Identifier: Apache-2.0
"""

import copy
import copyreg


def _attributes(thing):
    """What a subclass has put into an object."""
    slots = copyreg._slotnames(type(thing))  # pylint: disable=protected-access  # as object.__reduce_ex__ does
    return {**getattr(thing, "__dict__", {}),
            **{name: getattr(thing, name) for name in slots if hasattr(thing, name)}}


def keep(kind):
    """Gives a class, which has the state of its C++ object and is made of it, pickles and copies."""
    state_of, make = kind.__getstate__, kind.__setstate__

    def getstate(self):
        return (*state_of(self), _attributes(self))

    def setstate(self, state):
        attributes = {}
        if state and isinstance(state[-1], dict):
            *state, attributes = state
        make(self, tuple(state))
        for name, value in attributes.items():
            setattr(self, name, value)

    def reduce(self):
        return copyreg.__newobj__, (type(self),), self.__getstate__()

    def twin(self):
        other = type(self).__new__(type(self))
        make(other, (self,))
        return other

    def shallow(self):
        other = twin(self)
        for name, value in _attributes(self).items():
            setattr(other, name, value)
        return other

    def deep(self, memo):
        memo[id(self)] = other = twin(self)
        for name, value in _attributes(self).items():
            setattr(other, name, copy.deepcopy(value, memo))
        return other

    for name, function in {"__getstate__": getstate, "__setstate__": setstate, "__reduce__": reduce,
                           "__copy__": shallow, "__deepcopy__": deep}.items():
        setattr(kind, name, function)
