"""Reports of a small checkout for the tests of lab/figures.

SPDX-License-Identifier: Apache-2.0
"""

import pytest

from lab.figures.modules import MODULES
from tools.reports.results import FRESH, Results


@pytest.fixture
def reports(checkout):
    """The reports of a folder, with these written into it first."""
    def of(folder=FRESH, **contents):
        checkout.put({f"{folder}/{name}.json": content for name, content in contents.items()})
        return Results(checkout.root, folder, MODULES)
    return of
