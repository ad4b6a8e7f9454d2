"""The description of the legal space (tools/tables/parameter_space.py) and the RTL say the same: parameters and defaults
of each top; a guard of the name that the description gives it for each value next to a range and for each
rule; and no guard for what is legal. Of the cases a part is tried, another one whenever the RTL changes; the test
lint.space_whole tries all.

SPDX-License-Identifier: Apache-2.0
"""

import concurrent.futures
import os
import random
import re

import pytest

from tools.rtl import digest, module_header, rtl_sources
from tools.tables import parameter_draws, parameter_space as spaces

SOURCES = rtl_sources.Sources()
SPACE = spaces.Space()
GUARD = re.compile(r"\bERROR_(\w+)")
# Of tops that share parameters, the one whose parameters are tried.
OWN = {"hwffd_stream": None, "hwffd_scatter": None, "hwffd_axi": "hwffd_stream", "hwffd_stream_bus": "hwffd_stream",
       "hwffd_adjoint": "hwffd_stream"}


def guards(top, configuration):
    """The guards that Icarus meets."""
    parameters = [f"{name}={value}" for name, value in configuration.items()]
    status, output = rtl_sources.run([word for word in rtl_sources.icarus(SOURCES, top, SOURCES.needed(top), parameters)
                                      if word != "-Wall"])
    met = sorted(set(GUARD.findall(output)))
    assert met or status == 0, output
    return met


def cases():
    """(what, top, configuration, guard or None) of everything that is tried, from one seed."""
    collected = []
    for top, base in OWN.items():
        draw = parameter_draws.Draw(SPACE, top, random.Random(top))
        own = [parameter for name, parameter in SPACE.parameters[top].items()
               if base is None or parameter != SPACE.parameters[base].get(name)]
        names = set(SPACE.parameters[top]) - set(SPACE.parameters[base] if base else ())
        for parameter in own:
            collected += [(f"{parameter.name}={value}", top, draw.beyond(parameter, value), parameter.guard)
                          for value in parameter.beyond()]
            collected += [(f"{parameter.name}={value}", top, draw.legal(**{parameter.name: value}), None)
                          for value in parameter_draws.ends(parameter)]
        collected += [(rule.text, top, draw.breaking(rule), rule.guard) for rule in SPACE.rules_of(top)
                      if base is None or (set(rule.names) | set(rule.needs)) & names]
    return collected


def kinds(draw):
    """ORG and EVALUATOR of what is built of other modules: a guard that one of them has another may lack."""
    by_kind = {}
    for _ in range(1000):
        drawn = draw.legal()
        organization = SPACE.organizations[drawn["ORG"]]
        by_kind.setdefault((organization.module, organization.in_turn, organization.walks, drawn["EVALUATOR"]),
                           {name: drawn[name] for name in ("ORG", "EVALUATOR")})
    return by_kind.values()


def arithmetic_cases():
    """Latencies that are none, and a fused one without binary32, in each kind."""
    collected = []
    draw = parameter_draws.Draw(SPACE, "hwffd_stream", random.Random(1))
    fused, = [rule for rule in SPACE.rules if rule.names == ("FORMAT", "FMA_LATENCY")]
    for kind in kinds(draw):
        for name in ("MUL_LATENCY", "ADD_LATENCY"):
            parameter = draw.parameters[name]
            collected.append((f"{kind} {name}=0", draw.top, draw.beyond(parameter, 0, **kind), parameter.guard))
        collected.append((f"{kind} {fused.text}", draw.top, draw.breaking(fused, **kind), fused.guard))
    return collected


def part(whole, share):
    """One in `share`; which ones follows from the sources."""
    first = int(digest.of(*(path.read_text() for _, path in sorted(SOURCES.files.items())))[:8], 16)
    return whole[first % share::share]


SHARE = int(os.environ.get("HWFFD_SPACE_SHARE", "16"))
CASES = part(cases() + arithmetic_cases(), SHARE)


@pytest.fixture(name="met", scope="module")
def _met():
    """What Icarus says of each case."""
    with concurrent.futures.ThreadPoolExecutor(min(2, os.cpu_count() or 1)) as pool:
        return list(pool.map(lambda case: guards(case[1], case[2]), CASES))


def test_rules_are_printed(capsys):
    assert spaces.main(["hwffd_axi"]) == 0
    printed = capsys.readouterr().out.splitlines()
    assert printed == [rule.text for rule in SPACE.rules_of("hwffd_axi")] and len(printed) > 20
    assert spaces.main(["hwffd_axe"]) == 2
    assert "one of hwffd_stream, " in capsys.readouterr().err


@pytest.mark.parametrize("top", SPACE.parameters)
def test_parameters_and_defaults(top):
    defaults = module_header.read(SOURCES, top).parameters
    assert set(defaults) == set(SPACE.parameters[top])
    assert SPACE.faults(top, defaults) == []


def test_every_guard_is_in_the_sources():
    known = {guard for path in SOURCES.files.values()
             for guard in GUARD.findall(rtl_sources.strip_comments(path.read_text()))}
    patterns = {parameter.guard for top in SPACE.parameters.values() for parameter in top.values()}
    patterns |= {rule.guard for rule in SPACE.rules}
    assert len(patterns) > 40
    assert [pattern for pattern in sorted(patterns)
            if not any(re.fullmatch(pattern, guard) for guard in known)] == []


@pytest.mark.parametrize("number", range(len(CASES)), ids=lambda number: f"{CASES[number][1]}: {CASES[number][0]}")
def test_case(met, number):
    _, _, configuration, guard = CASES[number]
    if guard is None:
        assert met[number] == [], configuration
    else:
        assert any(re.fullmatch(guard, pattern) for pattern in met[number]), (configuration, guard, met[number])


def test_both_kinds_are_tried():
    refused = sum(guard is not None for _, _, _, guard in CASES)
    few_refused, few_legal = (80, 60) if SHARE == 1 else (0, 0)
    assert refused > few_refused and len(CASES) - refused > few_legal


@pytest.mark.parametrize("more", ({}, {"PAGED": 1, "PAGES": 1}, {"PAGED": 1, "AXIS": 8, "PAGES": 3}))
@pytest.mark.parametrize("latency", (12, 13, 32))
def test_lattices_alone_take_any_latency(latency, more):
    """Nothing of a vertex is kept by slots then, of which there would be more than places of a small lattice."""
    alone = {**module_header.parameters(SOURCES, "hwffd_stream"), "INTERLEAVED": 0, "AXIS": 4, "ORG": 1, "N": 1,
             "ADD_LATENCY": latency, **more}
    assert not [fault.guard for fault in SPACE.faults("hwffd_stream", alone)]
    assert guards("hwffd_stream", alone) == []
