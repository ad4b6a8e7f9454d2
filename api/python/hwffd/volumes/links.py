"""Names that any library takes.

SPDX-License-Identifier: Apache-2.0
"""

import contextlib
import os
import pathlib
import tempfile
from collections.abc import Iterator


@contextlib.contextmanager
def plain_link(path: os.PathLike[str] | str, name: str) -> Iterator[str]:
    """A link of that name to a file or folder, whose own name may be any bytes."""
    with tempfile.TemporaryDirectory(prefix="hwffd-") as folder:
        link = os.path.join(folder, name)
        os.symlink(pathlib.Path(path).absolute(), link)
        yield link
