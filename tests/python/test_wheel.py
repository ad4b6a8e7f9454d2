"""The wheel: built from a copy of the sources, with its shared libraries bundled, and used in a new
environment that has NumPy alone.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess
import sys
import zipfile
from pathlib import PurePosixPath

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOOLS = pathlib.Path(sys.executable).parent
PARTS = ("api", "cmake", "cores", "docs", "geometry", "golden", "registration", "rtl", "synth", "tools",
         "CMakeLists.txt", "LICENSE", "VERSION", "hwffd.core", "pyproject.toml")
SCENE = """
import hwffd, numpy as np
points = np.random.default_rng(1).random((100, 3))
lattice = hwffd.Lattice.around("sphere", points)
lattice.deform("twist:90")
lattice.set_device("model")
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
    result = subprocess.run([str(word) for word in words], text=True, check=False,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, **more)
    assert result.returncode == 0, f"{words}\n{result.stdout}"
    return result.stdout


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
    sources = [name for name in names if name.startswith("hwffd/sources/")]
    assert {"hwffd/sources/rtl/top/hwffd_stream.v", "hwffd/sources/tools/standalone/command.py"} < set(sources)
    names = [name for name in names if name not in sources]
    for name in "__init__.py", "__init__.pyi", "py.typed", "volumes/__init__.py":
        assert f"hwffd/{name}" in names
    libraries = " ".join(names)
    for library in "libhwffd", "libassimp", "libfmt", "libhwy":
        assert library in libraries
    assert not [name for name in names if name.endswith((".hpp", ".cmake", ".cpp", ".pc", ".in"))]
    assert len(names) < 60
    for name in {PurePosixPath(name).name.split(".so")[0].split("-")[0] for name in names if ".so" in name}:
        assert sum(PurePosixPath(other).name.startswith(f"{name}.") or f"{name}-" in other
                   for other in names) == 1, f"{name}: {names}"


@pytest.fixture(scope="module")
def environment(wheel, tmp_path_factory):
    """A new one with the wheel and the packages that it needs; a function that runs a program there."""
    folder = tmp_path_factory.mktemp("environment")
    run(sys.executable, "-m", "venv", folder / "env")
    python = folder / "env" / "bin" / "python"
    run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", wheel)
    clean = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}

    def called(*words, **variables):
        return run(python.with_name(words[0]) if words[0] != "python" else python, *words[1:], cwd=folder,
                   env={**clean, **variables})
    called.programs = python.parent
    return called


@pytest.fixture(scope="module")
def hardware(tmp_path_factory):
    """The wheel that pip install ./api/python/rtl makes, of the library of this build."""
    folder = tmp_path_factory.mktemp("rtl")
    (library,) = (TOOLS.parents[1] / "api").glob("libhwffd_rtl.so.[0-9]")
    run(TOOLS / "pip", "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", folder,
        f"--config-settings=cmake.define.HWFFD_RTL_LIBRARY={library}", f"--config-settings=build-dir={folder}/build",
        ROOT / "api" / "python" / "rtl")
    (built,) = folder.glob("hwffd_rtl-*.whl")
    return built


def test_the_simulated_hardware_is_one_file(hardware):
    version = (ROOT / "VERSION").read_text().strip()
    assert hardware.name.startswith(f"hwffd_rtl-{version}-py3-none-")
    names = [name for name in zipfile.ZipFile(hardware).namelist() if ".dist-info/" not in name]
    assert sorted(names) == ["hwffd_rtl/__init__.py", f"hwffd_rtl/libhwffd_rtl.so.{version.split('.')[0]}"]


def test_both_wheels_are_used_together(environment, hardware):
    environment("pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps", hardware)
    try:
        environment("python", "-W", "error", "-c", WITH_HARDWARE)
    finally:
        environment("pip", "uninstall", "--quiet", "--yes", "hwffd-rtl")


@pytest.mark.parametrize("package, problem", [
    ("library = 1", "the package hwffd-rtl is broken: module 'hwffd_rtl' has no attribute '__version__'"),
    ("__version__ = '0.0.1'", "the package hwffd-rtl has version 0.0.1, this one "),
    ("import no_such_module", "the package hwffd-rtl is broken: No module named 'no_such_module'"),
    ("raise ValueError('two\\nlines')", "the package hwffd-rtl is broken: two lines"),
    (None, "the package hwffd-rtl is broken: 0 libraries libhwffd_rtl.so* in "),
    ("two", "the package hwffd-rtl is broken: 2 libraries libhwffd_rtl.so* in "),
    ("empty", "the package hwffd-rtl is broken: ")])
def test_a_broken_package_of_hardware_is_told_where_it_is_wanted(environment, tmp_path, package, problem):
    folder = tmp_path / "hwffd_rtl"
    folder.mkdir()
    real = (ROOT / "api" / "python" / "rtl" / "hwffd_rtl" / "__init__.py").read_text()
    for name in {"two": ("libhwffd_rtl.so.0", "libhwffd_rtl.so.0.2.0"), "empty": ("libhwffd_rtl.so.0",)}.get(package, ()):
        (folder / name).touch()
    (folder / "__init__.py").write_text(real if package in (None, "two", "empty") else package)
    output = environment("python", "-W", "error", "-c", SCENE + """
try:
    lattice.set_device("rtl")
except hwffd.UsageError as error:
    print(error)
""", PYTHONPATH=str(tmp_path))
    assert output.startswith(f"device rtl: {problem}") and output.count("\n") == 1, output


def test_it_is_used_in_a_new_environment(environment):
    output = environment("python", "-c", USED)
    assert "site-packages" in output
    assert environment("hwffd-warp", "--version") == output.split()[0] + "\n"
    lacks = environment("python", "-c", "import subprocess, sys, pathlib; print(subprocess.run([pathlib.Path("
                        "sys.executable).with_name('hwffd-warp'), 'in.nrrd', 'box', 'out.nrrd'], capture_output=True, "
                        "text=True, check=False))")
    assert "returncode=1" in lacks and "in.nrrd: is not there" in lacks
    environment("python", ROOT / "examples" / "deform.py")


def test_it_writes_standalone_cores(environment, tmp_path):
    """`pip install pyhwffd[core]`, without the clone."""
    words = ("core", "--org", "cg1", "--format", "fx18", "--axis", "4", "--features", "resident", "--vertices", "20",
             "-o", str(tmp_path / "cg1"))
    lacks = environment("python", "-c", f"import subprocess, sys; print(subprocess.run(['hwffd', *{words!r}], "
                        "capture_output=True, text=True, check=False).stderr)", PATH=str(environment.programs))
    assert lacks.startswith("hwffd core: ") and "pip install jinja2" in lacks
    environment("pip", "install", "--quiet", "--disable-pip-version-check", "-r", str(ROOT / "tools" / "requirements-core.txt"))
    assert environment("hwffd", *words).startswith(f"{tmp_path}/cg1: hwffd_stream, cg1 in fx18, resident: ")
    run("iverilog", "-g2005", "-o", "tb", "cg1.v", "cg1_tb.v", cwd=tmp_path / "cg1")
    assert run("vvp", "-N", "tb", cwd=tmp_path / "cg1").startswith("PASS 20 vertices, ")
