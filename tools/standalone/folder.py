"""The folder of a standalone core: its files, and how they come there, all or none.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import shutil
import tempfile

from tools.standalone import constraints, datasheet, elaboration, mapping, model_header, simulation, testbench, verilog, words
from tools.standalone.configuration import Refused
from tools.tables import version as versions
from tools.project_root import ROOT


def files(core, vertices, target=None, simulate=False):
    """name -> text. For the data sheet `target`, one of mapping.TARGETS, is mapped, and the testbench simulated. Raises
    TableError."""
    version = versions.read(ROOT)
    try:
        design = elaboration.of_core(core)
    except ValueError as error:
        raise Refused(str(error)) from error
    sample = words.sample(core, vertices)
    source = verilog.text(core, design, version)
    run = {f"{core.prefix}.v": source, **testbench.files(core, design, sample, version)}
    texts = {
        **datasheet.files(core, design, sample, version, target, mapping.of(core, source, target) if target else None,
                          simulation.of(core, run) if simulate else None),
        **run,
        f"{core.prefix}_model.hpp": model_header.text(core, version),
        **constraints.files(core, design),
        "LICENSE": _text_of("LICENSE"),
    }
    if core.has_registers:
        texts["registers.h"] = _text_of("cores/include/hwffd/registers.h")
    return texts


def _text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def check(path):
    """Raises Refused where a folder cannot be written there: before there is work to lose."""
    path = pathlib.Path(path)
    try:
        str(path).encode("utf-8")
    except UnicodeEncodeError as error:
        raise Refused(f"{str(path)!a}: its name is not in UTF-8, as the files are; name another one") from error
    if path.is_dir() and any(path.iterdir()):
        raise Refused(f"{path}: the folder is not empty; name another one")
    if path.exists() and not path.is_dir():
        raise Refused(f"{path}: is there, and no folder; name another one")
    parent = path.resolve().parent
    if not parent.is_dir():
        raise Refused(f"{path}: there is no folder {parent}")
    if not os.access(parent, os.W_OK):
        raise Refused(f"{path}: {parent} cannot be written to")


def write(path, texts):
    """The folder with these files; where it fails there is none. Raises Refused. Of a link it is what the link names."""
    path = pathlib.Path(path).resolve()
    draft = pathlib.Path(tempfile.mkdtemp(prefix=f".{path.name}.", dir=path.parent))
    try:
        for name, text in texts.items():
            (draft / name).write_text(text, encoding="utf-8")
        draft.chmod(0o777 & ~_umask())
        os.replace(draft, path)  # a folder that is empty gives way
    except OSError:
        check(path)  # another run may have been faster
        raise
    finally:
        shutil.rmtree(draft, ignore_errors=True)


def _umask():
    mask = os.umask(0)
    os.umask(mask)
    return mask
