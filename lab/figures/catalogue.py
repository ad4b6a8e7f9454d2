"""The reports: the command that makes each, where its rows are, and what sources it measures.

SPDX-License-Identifier: Apache-2.0
"""

import importlib
from dataclasses import dataclass

# Sources, as patterns of files (sources.py says what counts of each kind of file).
_RTL = ("rtl/**/*.v", "rtl/configurations.csv")
_CORE = ("rtl/[!b]*/*.v", "rtl/configurations.csv")  # without rtl/bus and rtl/board
_MODEL = (*(f"golden/**/{part}/*.?pp" for part in ("numerics", "bounds", "oracle")),
          "golden/**/model/org_*.?pp", "golden/**/model/organization.?pp",
          "golden/**/model/evaluator.?pp", "golden/**/stream/w*.?pp")
_GEOMETRY = ("geometry/**/lattice/*.?pp", "geometry/**/mesh/*.?pp")
_SYNTH = (*_RTL, "synth/*.ys", "synth/osu018.*")
_ENGINES = ("synth/prepare.ys", "synth/ecp5.ys", "synth/generic_memories.ys",
            "tests/recorded/commands/*", "lab/engines/*.?pp", "lab/engines/*.v",
            "lab/engines/*.py", "tb/cells/ecp5/*.v", "tools/cxxrtl.py")


@dataclass(frozen=True)
class Report:
    """A report, by the name of its file."""

    command: str
    sources: tuple
    rows: str = "rows"  # the field with its rows
    # Fields that differ from run to run or between machines: not committed.
    volatile: tuple = ()
    selectors: tuple = ()  # fields that narrow its command to the rows in question
    written: str = ""  # the name under which its command writes it, where that is another
    # Fields that tell one row from another, where rows that took hours may outlive a change.
    identity: tuple = ()


REPORTS = {
    "organizations": Report(
        "make organizations", (*_CORE, "lab/organizations/*.?pp"),
        volatile=("simulation_vertices_per_s", "simulation_share", "reference_vertices_per_s",
                  "compiler_options", "targets"),
        selectors=("org", "n", "format")),
    "timelines": Report("make organizations", (*_CORE, "lab/organizations/*.?pp")),
    "words": Report("make words", (*_MODEL, *_GEOMETRY, "lab/words/*.?pp")),
    "streams": Report("make streams", (*_CORE, *_GEOMETRY, "golden/**/stream/packets.?pp",
                                       "lab/streams/*.?pp")),
    "bfp": Report("make bfp", (*_CORE, *_MODEL, "lab/bfp/*.?pp"), rows="errors"),
    "tangents": Report("make tangents", (*_CORE, *_GEOMETRY, "lab/tangents/*.?pp")),
    "embed": Report("make embed", (*_GEOMETRY, "lab/embed/*.?pp")),
    "glapi": Report("make glapi", ("api/gl/**/*.?pp", "tests/gl/*.py"), rows="commands"),
    "sim": Report("make sim", (*_CORE, *_GEOMETRY, "apps/sim/*.?pp"), rows="runs"),
    "dma": Report("make sim STREAM=dma", (*_RTL, *_GEOMETRY, "apps/sim/*.?pp"), rows="runs",
                  written="sim"),
    "synth": Report("make synth", _SYNTH, volatile=("seconds", "kinds"),
                    selectors=("target", "org", "n", "format"),
                    identity=("name", "variant", "top", "target")),
    "pnr": Report("make pnr", (*_SYNTH, "synth/clocks.csv"), identity=("name", "top", "target")),
    "compare": Report(
        "make compare",
        (*_RTL, "geometry/**/lattice/lattice_evaluator.?pp", "geometry/**/lattice/contraction.?pp",
         "lab/compare/*.?pp", "lab/compare/*.py", "tools/requirements-compare.txt",
         "docs/reports/pnr.json", "docs/reports/synth.json", "docs/reports/dma.json")),
    "bench": Report("make compare", (
        *_MODEL, "golden/**/model/*.?pp", "geometry/**/lattice/*.?pp", "api/src/device/*.?pp", "api/python/src/*.?pp",
        "lab/compare/arrays/*.py", "tools/requirements-compare.txt")),
    "energy": Report(
        "make energy",
        (*_CORE, *_MODEL, "synth/prepare.ys", "synth/verify.ys", "synth/osu018.*",
         "lab/energy/*.?pp", "lab/energy/*.v", "lab/energy/*.py",
         "lab/compare/scene.?pp")),
    "coverage": Report("make coverage", (
        "rtl/**/*.v", "rtl/configurations.csv", "lab/rtl_coverage/*.py", "lab/rtl_coverage/*.csv",
        "tb/coverage/*.cpp")),
    "mutants": Report("make mutants", (
        "rtl/**/*.v", "rtl/configurations.csv", "tests/bus/axil/*.?pp", "tests/bus/dma/*.?pp",
        "tests/evaluator/*.?pp", "tests/system/*.?pp", "tests/unit/**/*.?pp", "lab/mutants/*.py",
        "lab/mutants/*.csv", "lab/mutants/*.v")),
    "upsets": Report("make upsets", (
        "rtl/**/*.v", "rtl/configurations.csv", "lab/upsets/*.?pp", "lab/upsets/*.v",
        "lab/upsets/*.py", "synth/ecp5.ys", "synth/prepare.ys", "tb/**/axi_*.?pp",
        "driver/**/driver.?pp")),
    "bounds": Report("make bounds", (*_MODEL, "golden/**/stream/blending.?pp", "lab/bounds/*.?pp",
                                     "lab/bounds/*.py", "lab/bounds/coq/*.v")),
    "soak": Report("make soak", (*_RTL, "lab/soak/*.csv"), volatile=("hours",)),
    "theorems": Report("make theorems", ("rtl/number/**/*.v", "rtl/common/ffd_num_delay.v", "lab/theorems/*.py",
                                         "tools/requirements-theorems.txt"), volatile=("seconds", "counterexample")),
    "testfloat": Report("make testfloat", ("rtl/number/float/*.v", "rtl/number/fixed/ffd_fx_block.v",
                                           "rtl/common/ffd_num_delay.v", "lab/testfloat/*.?pp")),
    "engines": Report("make engines", (*_CORE, *_ENGINES), volatile=("seconds",)),
    "unknowns": Report("make engines", (*_RTL, *_ENGINES)),
    "boards": Report("make boards", (*_RTL, "synth/*.ys", "synth/boards/boards.csv",
                                     "synth/boards/*/*.pcf", "synth/boards/*/*.lpf"),
                     rows="boards"),
    "plates": Report("make plates", (*_CORE, *_GEOMETRY, "apps/plates/*.?pp"), rows="plates"),
    "web": Report("make web", (*_CORE, "apps/web/**/*.?pp", "apps/web/**/*.js", "apps/web/**/*.css",
                               "apps/web/page/index.html")),
    "structure": Report("make structure", (*_RTL, "synth/prepare.ys", "synth/ecp5.ys"),
                        rows="designs"),
    "formal": Report("make formal", ("rtl/**/*.v", "lab/formal/*.v",
                                     "lab/formal/properties.csv"),
                     rows="properties", volatile=("seconds", "control_seconds")),
    "tests": Report("make test", ("tests/**/*_test.cpp", "tests/**/test_*.py", "tests/**/*.csv",
                                  "rtl/configurations.csv"), rows="suites"),
}

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
}

# Modules of lab/ without a report of their own: what joins several, what is read off the sources.
JOINED = ("results", "rtl", "project")


def printed(reports, name):
    """What the command of a report prints: its module says so, or has one table."""
    found = module(name)
    if hasattr(found, "printed"):
        return found.printed(reports)
    return "\n".join(table(reports).text() for table in found.TABLES.values())


def missing(reports, name):
    """What a report lacks that shall be committed, '' if nothing."""
    return getattr(module(name), "missing", lambda _: "")(reports)


def module(name):
    """The module of a report, with its TABLES and FIGURES; None if it has none."""
    if name not in REPORTS and name not in JOINED:
        return None
    return importlib.import_module(f"figures.studies.{name}")
