"""The wheel: built from a copy of the sources, with its shared libraries bundled, and used in a new
environment that has NumPy alone.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess
import sys
import zipfile

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = pathlib.Path(sys.executable).parent
PARTS = ("api", "cmake", "cores", "docs", "driver", "geometry", "golden", "rtl", "scripts", "synth",
         "CMakeLists.txt", "LICENSE", "VERSION", "hwffd.core", "pyproject.toml")
SCENE = """
import hwffd, numpy as np
points = np.random.default_rng(1).random((100, 3))
lattice = hwffd.Lattice.around("sphere", points)
lattice.deform("twist:90")
model = hwffd.deform(lattice, points)
"""
USED = SCENE + """
lattice.set_device("reference")
assert 0 < abs(hwffd.deform(lattice, points) - model).max() < 1e-5
assert hwffd.devices("rtl") == []
print(hwffd.__version__, hwffd.__file__)
"""
WITH_HARDWARE = SCENE + """
lattice.set_device("rtl")
assert (hwffd.deform(lattice, points) == model).all()
"""


def run(*words, **more):
    done = subprocess.run([str(word) for word in words], text=True, check=False,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    assert done.returncode == 0, f"{words}\n{done.stdout}"
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Repaired: with the libraries that it needs."""
    folder = tmp_path_factory.mktemp("wheel")
    source = folder / "source"
    source.mkdir()
    for part in PARTS:
        run("cp", "-r", ROOT / part, source)
    # Beside pip's own, the environment has cmake and ninja of the system.
    run(TOOLS / "pip", "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir",
        folder / "built", source)
    (built,) = (folder / "built").glob("pyhwffd-*.whl")
    path = f"{TOOLS}{os.pathsep}{os.environ['PATH']}"
    run(TOOLS / "auditwheel", "repair", "--wheel-dir", folder / "repaired", built,
        env={**os.environ, "PATH": path})
    (repaired,) = (folder / "repaired").glob("pyhwffd-*.whl")
    return repaired


def test_it_has_the_package_and_its_libraries(wheel):
    version = (ROOT / "VERSION").read_text().strip()
    assert wheel.name.startswith(f"pyhwffd-{version}-cp3") and "manylinux" in wheel.name
    names = zipfile.ZipFile(wheel).namelist()
    for name in "__init__.py", "__init__.pyi", "py.typed", "volumes/__init__.py":
        assert f"hwffd/{name}" in names
    libraries = " ".join(names)
    for library in "libhwffd", "libassimp", "libfmt", "libhwy":
        assert library in libraries
    assert not [name for name in names if name.endswith((".hpp", ".cmake", ".cpp", ".pc", ".in"))]
    assert len(names) < 40


def test_the_simulated_hardware_is_a_package(wheel, tmp_path):
    """As pip install ./api/python/rtl makes it, of the library of this build."""
    package = tmp_path / "packages" / "hwffd_rtl"
    run("mkdir", "-p", package)
    run("cp", ROOT / "api" / "python" / "rtl" / "hwffd_rtl" / "__init__.py", package)
    (library,) = (TOOLS.parents[1] / "api").glob("libhwffd_rtl.so.[0-9]")
    run("cp", library, package)
    run(sys.executable, "-m", "pip", "install", "--quiet", "--no-deps", "--target", package.parent, wheel)
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    run(sys.executable, "-c", WITH_HARDWARE, cwd=tmp_path,
        env={**clean, "PYTHONPATH": str(package.parent)})


def test_it_is_used_in_a_new_environment(wheel, tmp_path):
    run(sys.executable, "-m", "venv", tmp_path / "env")
    python = tmp_path / "env" / "bin" / "python"
    run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", wheel)
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
    said = run(python, "-c", USED, cwd=tmp_path, env=clean)
    assert str(tmp_path / "env") in said
    version = run(python.with_name("hwffd-warp"), "--version", cwd=tmp_path, env=clean)
    assert version == said.split()[0] + "\n"
    lacks = subprocess.run([python.with_name("hwffd-warp"), "in.nrrd", "box", "out.nrrd"], env=clean,
                           cwd=tmp_path, capture_output=True, text=True, check=False)
    assert lacks.returncode == 1 and "in.nrrd: is not there" in lacks.stderr
    run(python, ROOT / "examples" / "deform.py", cwd=tmp_path, env=clean)
