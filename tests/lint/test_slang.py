"""Every top, as its file list gives it, through a parser that wants each name declared before it is used, in both
languages.

SPDX-License-Identifier: Apache-2.0
"""

import pytest
from pyslang import driver

from tools.project_root import ROOT
from tools.rtl import rtl_sources

TOPS = sorted(path.stem for path in (ROOT / "rtl" / "top").glob("*.v"))


@pytest.mark.parametrize("standard", ("1364-2005", "1800-2017"))
@pytest.mark.parametrize("top", TOPS)
def test_each_name_is_declared_first(top, standard):
    sources = rtl_sources.Sources()
    slang = driver.Driver()
    slang.addStandardArgs()
    words = [f"-I{path}" for path in sources.includes] + [str(path) for path in sources.needed(top)]
    assert slang.parseCommandLine(f"slang -Werror --std {standard} --top {top} {' '.join(words)}") and slang.processOptions()
    assert slang.parseAllSources() and slang.runFullCompilation(True)
