"""Bounds are tested where their tools are.

SPDX-License-Identifier: Apache-2.0
"""

import shutil

import pytest


def pytest_collection_modifyitems(items):
    """A test names its tools by a mark."""
    for item in items:
        for mark in item.iter_markers("needs"):
            for program in mark.args:
                if not shutil.which(program):
                    item.add_marker(pytest.mark.skip(reason=f"no {program}: make -C lab bounds installs it"))


def pytest_configure(config):
    config.addinivalue_line("markers", "needs(*programs): skipped where one of them is not installed")
