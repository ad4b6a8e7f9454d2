"""Every subject of make -C lab mutants names a model and programs of this build, which may not be made yet; and the module
that says for which inputs a design is made has each of its ports: an output that it left out would not be compared.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re

import pytest

from lab.mutants import __main__ as mutants
from lab.mutants import built

SUBJECTS = mutants.subjects([])


@pytest.mark.parametrize("subject", SUBJECTS, ids=[subject["name"] for subject in SUBJECTS])
def test_what_a_subject_names_is_there(arguments, subject):
    (build,) = map(pathlib.Path, arguments)
    assert built.model(build, subject["library"]).top
    for program in filter(None, (subject["program"], subject["late"])):
        assert built.commands(build, program)


def ports(path, module):
    """Names of a module's ports."""
    header = re.search(rf"^module {module}\b.*?^\);", path.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)[0]
    return re.findall(r"^  (?:input|output) .*?(\w+),?(?: *//.*)?$", header, re.MULTILINE)


@pytest.mark.parametrize("domain", sorted(pathlib.Path(mutants.__file__).parent.glob("*.v")), ids=lambda path: path.stem)
def test_a_domain_has_each_port_of_its_design(domain):
    design, = mutants.ROOT.glob(f"rtl/**/{domain.stem}.v")
    assert len(ports(design, domain.stem)) > 3
    inside = re.search(rf"^  {domain.stem} u_inside \(.*?^  \);", domain.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)[0]
    assert ports(domain, "domain") == ports(design, domain.stem)
    assert re.findall(r"^    \.(\w+) *\(", inside, re.MULTILINE) == ports(design, domain.stem)
