#!/usr/bin/env python3
"""What `cmake --install` puts into a folder of its own, used as a stranger would use it.

    test_install.py Programs|Python CMAKE BUILD PYTHON

PYTHON is the interpreter that the Python module was built for, with NumPy.

SPDX-License-Identifier: Apache-2.0
"""

import filecmp
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

TESTS, CMAKE, BUILD, PYTHON = sys.argv[1:]
ROOT = pathlib.Path(__file__).resolve().parents[2]
EXAMPLES = ROOT / "examples"

VERSION = (ROOT / "VERSION").read_text(encoding="utf-8").rpartition(".")[0]  # its first two numbers
PROJECT = f"""cmake_minimum_required(VERSION 3.18)
project(stranger LANGUAGES C CXX)
set(CMAKE_CXX_STANDARD 17)
find_package(hwffd {VERSION} REQUIRED COMPONENTS core gl)
add_executable(deform_c deform.c)
target_link_libraries(deform_c PRIVATE hwffd::hwffd)
add_executable(deform_cpp deform.cpp)
target_link_libraries(deform_cpp PRIVATE hwffd::hwffd)
add_executable(drive drive.cpp)
target_link_libraries(drive PRIVATE hwffd::hwffd)
add_executable(glffd glffd.c)
target_link_libraries(glffd PRIVATE hwffd::gl m)
"""
CORE = f"""cmake_minimum_required(VERSION 3.18)
project(core LANGUAGES C)
find_package(hwffd {VERSION} REQUIRED COMPONENTS {{}})
add_executable(deform_c deform.c)
target_link_libraries(deform_c PRIVATE hwffd::core)
"""
PROGRAM = """#include <hwffd/device/deformable_lattice.hpp>
#include <hwffd/lattice/around.hpp>
#include <cstdio>
int main() {
  const hwffd::Points points = (hwffd::Points(2, 3) << 0, 0, 0, 1, 1, 1).finished();
  hwffd::DeformableLattice lattice(hwffd::lattice_around("box", points, {4, 4, 4}));
  lattice.deform("scale:3");
  std::printf("%g\\n", lattice.carry(points)(1, 0));
}
"""
DRIVE = """#include <hwffd/driver.hpp>
#include <hwffd/error.hpp>
#include <hwffd/registers.h>
#include <cstdio>
struct Nothing : hwffd::RegisterPort {  // a bus with no core
  std::uint32_t read32(std::uint32_t) override { return 0; }
  void write32(std::uint32_t, std::uint32_t) override {}
};
int main() {
  Nothing port;
  hwffd::Driver driver(port);
  try {
    driver.probe();
  } catch (const hwffd::Error& error) {
    std::puts(error.what());
  }
}
"""
HORSE = pathlib.Path("/usr/share/glmark2/models/horse.3ds")
BLOCK = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"


def run(*words, cwd=None, env=None):
    result = subprocess.run([str(word) for word in words], cwd=cwd, env=env, text=True,
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
    if result.returncode != 0:
        raise AssertionError(f"{' '.join(map(str, words))}: {result.returncode}\n{result.stdout}")
    return result.stdout


def copied_from_readme(language):
    """The one block of the README in that language."""
    text = (ROOT / "README.md").read_text()
    (block,) = re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
    return block


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        cls.prefix = cls.folder / "hwffd"
        run(CMAKE, "--install", BUILD, "--prefix", cls.prefix)
        cls.installed = pathlib.Path(BUILD, "install_manifest.txt").read_text().splitlines()

    def stranger(self):
        """Where programs of another project are, built with what was installed."""
        source = self.folder / "stranger"
        source.mkdir()
        (source / "CMakeLists.txt").write_text(PROJECT)
        (source / "deform.cpp").write_text(PROGRAM)
        (source / "drive.cpp").write_text(DRIVE)
        for example in ("deform.c", "glffd.c"):
            (source / example).write_text((EXAMPLES / example).read_text())
        run(CMAKE, "-S", source, "-B", source / "build", f"-DCMAKE_PREFIX_PATH={self.prefix}")
        run(CMAKE, "--build", source / "build")
        return source / "build"


class Programs(Installed):
    def test_deform_on_rtl_and_model(self):
        block = self.folder / "block.obj"
        block.write_text(BLOCK)
        for mesh in (block, HORSE):
            if not mesh.is_file():
                continue
            for device in ("rtl", "model"):
                (self.folder / device).mkdir(exist_ok=True)
                run(self.prefix / "bin" / "hwffd", "deform", "--lattice", "sphere", "--deform",
                    "twist:90", "--device", device, mesh, "-o", "out.ply", cwd=self.folder / device)
            self.assertTrue(filecmp.cmp(self.folder / "rtl" / "out.ply",
                                        self.folder / "model" / "out.ply", shallow=False))

    def test_everything_is_below_the_prefix(self):
        self.assertGreater(len(self.installed), 200)
        self.assertEqual([name for name in self.installed if not name.startswith(f"{self.prefix}/")], [])
        there = {str(path) for path in self.prefix.rglob("*") if not path.is_dir()}
        self.assertEqual(there, set(self.installed))
        for name in ("share/man/man1/hwffd.1", "share/bash-completion/completions/hwffd", "bin/hwffd-sim",
                     "share/zsh/site-functions/_hwffd", "share/fish/vendor_completions.d/hwffd.fish"):
            self.assertIn(f"{self.prefix}/{name}", self.installed)

    @unittest.skipUnless(HORSE.is_file(), "no models of glmark2: tools/install build")
    def test_code_of_the_readme(self):
        """As the README says it, below $HOME/hwffd."""
        work = self.folder / "work"
        work.mkdir()
        (work / "deform.py").write_text(copied_from_readme("python"))
        (work / "deform.cpp").write_text(copied_from_readme("cpp"))
        lines = [line for line in copied_from_readme("sh").splitlines()
                 if not line.startswith("hwffd view")]  # it waits for the mouse
        self.assertEqual(len(lines), 6)
        path = f"{pathlib.Path(PYTHON).parent}:{os.environ['PATH']}"
        output = run("sh", "-ec", "\n".join(lines), cwd=work, env=dict(os.environ, HOME=str(self.folder), PATH=path))
        moved = [float(line) for line in output.splitlines()[-2:]]
        self.assertTrue(all(0.1 < coordinate < 10 for coordinate in moved), output)
        for name in ("cat.glb", "bent.obj"):
            self.assertGreater((work / name).stat().st_size, 1000)

    def test_rtl(self):
        rtl = self.prefix / "share" / "hwffd" / "rtl"
        run("verilator", "--lint-only", "-Wall", "-F", rtl / "hwffd.f", "--top-module", "hwffd_stream", cwd=self.folder)
        listed = run(rtl / "file_list", cwd=self.folder).splitlines()
        self.assertGreater(len(listed), 100)
        missing = [line for line in listed if not pathlib.Path(line.removeprefix("+incdir+")).exists()]
        self.assertEqual(missing, [])

    def test_sim_is_a_command(self):
        output = run(self.prefix / "bin" / "hwffd", "sim", "--help", cwd=self.folder)
        self.assertIn("Usage: hwffd-sim", output)

    def core(self, components):
        """A project in C for which neither OpenGL nor Eigen is there; the words that build it."""
        source = self.folder / components.replace(" ", "-")
        source.mkdir()
        (source / "CMakeLists.txt").write_text(CORE.format(components))
        (source / "deform.c").write_text((EXAMPLES / "deform.c").read_text())
        return source, (CMAKE, "-S", source, "-B", source / "build",
                        f"-DCMAKE_PREFIX_PATH={self.prefix}",
                        "-DCMAKE_DISABLE_FIND_PACKAGE_OpenGL=ON",
                        "-DCMAKE_DISABLE_FIND_PACKAGE_Eigen3=ON")

    def test_core_needs_neither_opengl_nor_eigen(self):
        source, words = self.core("core")
        run(*words)
        run(CMAKE, "--build", source / "build")
        self.assertEqual(len(run(source / "build" / "deform_c").splitlines()), 3)

    def test_components_that_are_not_there_are_refused(self):
        for components, part in ("core plot", "plot"), ("core gl", "OpenGL"):
            _, words = self.core(components)
            with self.assertRaisesRegex(AssertionError, part):
                run(*words)

    def test_pkg_config(self):
        (folder,) = self.prefix.glob("lib*/**/pkgconfig")
        env = dict(os.environ, PKG_CONFIG_PATH=str(folder))
        flags = run("pkg-config", "--cflags", "--libs", "hwffd", env=env).split()
        program = self.folder / "deform_by_pkg_config"
        run("cc", EXAMPLES / "deform.c", "-o", program, *flags, f"-Wl,-rpath,{folder.parent}")
        self.assertEqual(len(run(program).splitlines()), 3)

    def test_find_package(self):
        build = self.stranger()
        self.assertEqual(run(build / "deform_cpp"), "2\n")
        self.assertEqual(run(build / "drive"), "no hwffd here: ID reads 0\n")
        self.assertNotEqual(run(build / "glffd"), "")
        self.assertEqual(len(run(build / "deform_c").splitlines()), 3)


class Python(Installed):
    def python(self, script):
        (module,) = self.prefix.glob("lib*/**/python")
        return run(PYTHON, script, env=dict(os.environ, PYTHONPATH=str(module)))

    def test_example_says_what_that_in_c_says(self):
        self.assertEqual(self.python(EXAMPLES / "deform.py"), run(self.stranger() / "deform_c"))

    def test_the_command_runs_the_program_of_the_package(self):
        version = run(self.prefix / "bin" / "hwffd", "--version")
        path = f"{pathlib.Path(PYTHON).parent}:{os.environ['PATH']}"
        output = run(self.prefix / "bin" / "hwffd", "warp", "--version", env=dict(os.environ, PATH=path))
        self.assertEqual(output, version)
        for script in self.prefix.glob("bin/*"):
            self.assertNotIn(str(ROOT).encode(), script.read_bytes()[:200], script)

    def test_simulated_hardware(self):
        self.python(pathlib.Path(__file__).with_name("python_module.py"))


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], TESTS], verbosity=2)
