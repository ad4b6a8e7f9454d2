"""The program hwffd-core, which `hwffd core` runs: the generator of standalone cores, tools/standalone of the sources
that lie with the package, in the prefix where it is installed, or in the checkout.

SPDX-License-Identifier: Apache-2.0
"""

import pathlib
import sys
import typing

NAME = "hwffd core"
FAILURE = 1


def _sources() -> typing.Union[pathlib.Path, None]:
    """The folder that has tools/ and all that these read."""
    package = pathlib.Path(__file__).resolve().parent
    places = [package / "sources", *(parent / "share" / "hwffd" for parent in package.parents), *package.parents]
    return next((place for place in places if (place / "tools" / "standalone").is_dir()), None)


def main() -> int:
    """The program; its exit status."""
    sources = _sources()
    if sources is None:
        print(f"{NAME}: the sources of the core are not there; install pyhwffd again", file=sys.stderr)
        return FAILURE
    sys.path.insert(0, str(sources))
    try:
        from tools.standalone.command import main as run  # pylint: disable=import-outside-toplevel
    except ImportError as error:
        if error.name not in ("jinja2", "pyslang"):
            raise
        print(f"{NAME}: {error.name} is not there, in {sys.executable}: pip install jinja2 "
              "'pyslang>=12,<13'", file=sys.stderr)
        return FAILURE
    return run(prog=NAME)
