"""Texts of a standalone core, of the templates beside.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib

import jinja2

_FOLDER = pathlib.Path(__file__).resolve().parent / "templates"
_ENVIRONMENT = jinja2.Environment(
    loader=jinja2.FileSystemLoader(_FOLDER), undefined=jinja2.StrictUndefined, keep_trailing_newline=True,
    trim_blocks=True, lstrip_blocks=True, autoescape=False)


def text(name, **values):
    """The template of that name, filled in."""
    return _ENVIRONMENT.get_template(name).render(**values)
