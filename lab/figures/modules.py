"""By the name of a report what makes its tables, of the product's commands and of the laboratory; and the pictures.

SPDX-License-Identifier: Apache-2.0
"""

import importlib
import pathlib

from lab.figures import study_pages
from tools.reports import report_modules, text_blocks

STUDIES = sorted(path.stem for path in pathlib.Path(__file__).parent.glob("studies/[a-z]*.py"))
MODULES = {**report_modules.MODULES, "studies": study_pages,
           **{name: importlib.import_module(f"lab.figures.studies.{name}") for name in STUDIES}}
# The texts of the product and of the laboratory.
TEXTS = (*text_blocks.PATTERNS, "lab/**/*.md")
# Pictures, a module of charts/ each, and the reports that each is drawn from.
CHARTS = {
    "organizations": ("organizations",),
    "pareto": ("organizations", "synth"),
    "timeline": ("timelines",),
    "words": ("words",),
    "streams": ("streams",),
    "structure": ("structure",),
    "compare": ("compare",),
    "tutorial": (),
    "walk": (),
}


def missing(reports, name):
    """What a report lacks to be whole, '' if nothing."""
    return getattr(MODULES.get(name), "missing", lambda _: "")(reports)
