"""Every subject of make mutants names a model and programs of this build, which may not be made yet.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib

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
