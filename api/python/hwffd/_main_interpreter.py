"""Refuses to be imported in a subinterpreter, where the module _core would wait for ever.

SPDX-License-Identifier: Apache-2.0
"""

import ctypes


def _interpreter(function):
    function.restype = ctypes.c_void_p
    return function()


if (_interpreter(ctypes.pythonapi.PyInterpreterState_Get)
        != _interpreter(ctypes.pythonapi.PyInterpreterState_Main)):
    raise ImportError("hwffd: not in a subinterpreter; import it in the main interpreter or in another process")
