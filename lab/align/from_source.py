"""Packages of programs that the index has as sources only: compiled once, and where that fails it is said why.

SPDX-License-Identifier: Apache-2.0
"""

import importlib.metadata
import os
import subprocess
import sys

# Versions, and what their builds want of the environment. NiftyReg asks for a CMake older than any that works here.
SOURCES = {"niftyreg": ("1.5.70rc1", {"CMAKE_POLICY_VERSION_MINIMUM": "3.5"})}


def installed(package, folder):
    """'' where a package is there or is none of these; else why it could not be compiled, in one line. What the
    installation printed is kept in the folder."""
    if package not in SOURCES:
        return ""
    version, environment = SOURCES[package]
    try:
        importlib.metadata.version(package)
        return ""
    except importlib.metadata.PackageNotFoundError:
        pass
    if os.environ.get("HWFFD_NO_INSTALL", "0") not in ("", "0"):
        return f"{package} {version} is not in build/venv, and HWFFD_NO_INSTALL forbids to compile it"
    log = folder / f"{package}-install.log"
    print(f"align: compiling {package} {version}, some minutes; what it prints: {log}", file=sys.stderr, flush=True)
    with open(log, "w", encoding="utf-8") as file:
        status = subprocess.call([sys.executable, "-m", "pip", "install", "--disable-pip-version-check",
                                  f"{package}=={version}"], stdout=file, stderr=subprocess.STDOUT,
                                 env={**os.environ, **environment})
    if not status:
        return ""
    lines = [line for line in log.read_text(encoding="utf-8", errors="replace").splitlines() if "error" in line.lower()]
    return f"{package} {version} does not compile here: {(lines or ['no message'])[-1].strip()}"
