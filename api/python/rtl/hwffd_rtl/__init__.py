"""The simulated hardware of hwffd, as a library that is loaded here, so that hwffd finds it by its name.

SPDX-License-Identifier: Apache-2.0
"""

import ctypes
import pathlib

(_path,) = pathlib.Path(__file__).parent.glob("libhwffd_rtl.so.*[0-9]")
library = ctypes.CDLL(str(_path))
