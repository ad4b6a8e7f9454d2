"""hwffd as a peripheral of LiteX: `add_hwffd(soc, rtl=FOLDER)`.

SPDX-License-Identifier: Apache-2.0
"""

from litex_hwffd.bridge import AxiToWishbone
from litex_hwffd.core import Hwffd, add_hwffd
from litex_hwffd.sources import RtlError, sources

__all__ = ["AxiToWishbone", "Hwffd", "RtlError", "add_hwffd", "sources"]
