"""Sections of the site that are folders: an entry of `nav` that ends in / becomes the README of that folder and the pages
beside it, in the order in which the README links to them. MkDocs calls it as a hook.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import re

_LINK = re.compile(r"\]\(([\w-]+\.md)[)#]")


def pages(source, folder):
    """The pages of a folder, as paths from `source`; one that the README does not link to is an omitted file."""
    linked = _LINK.findall((pathlib.Path(source) / folder / "README.md").read_text(encoding="utf-8"))
    return [folder + name for name in dict.fromkeys(["README.md", *linked])]


def on_config(config):
    for section in config["nav"]:
        for title, inside in section.items():
            if isinstance(inside, str) and inside.endswith("/"):
                section[title] = pages(config["docs_dir"], inside)
    return config
