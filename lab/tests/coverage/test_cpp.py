"""Lines and branches of a small program, compiled here, as gcov and gcovr count them.

SPDX-License-Identifier: Apache-2.0
"""

import os
import subprocess

import pytest

from lab.rtl_coverage import counts as counting, cpp

# Each instance of `sum` goes one way at its branch; what is `idle` goes none.
PROGRAM = """#include <cstdio>
template <class T>
T sum(int count, int limit) {
  T total = 0;
  for (int i = 0; i < count; ++i) {
    if (i > limit) std::puts("more");
    total += static_cast<T>(i);
  }
  return total;
}
int idle() {
  return 4;
}
int main() {
  return sum<int>(3, 5) + static_cast<int>(sum<double>(3, -1)) - 6;
}
"""


@pytest.fixture
def build(tmp_path):
    """Rows of these folders, each with that program, which has run."""
    (tmp_path / "build").mkdir()

    def made(folders):
        for folder in folders:
            (tmp_path / folder).mkdir()
            (tmp_path / folder / "main.cpp").write_text(PROGRAM)
            subprocess.run(["c++", "-O0", "-fprofile-arcs", "-ftest-coverage", "-o", f"{folder}-main",
                            f"../{folder}/main.cpp"], cwd=tmp_path / "build", check=True)
            subprocess.run([tmp_path / "build" / f"{folder}-main"], cwd=tmp_path / "build", check=True,
                           stdout=subprocess.DEVNULL)
        return cpp.rows(tmp_path, tmp_path / "build")
    return made


def test_a_line_of_a_template_is_one_line(build):
    for row in build(cpp.FOLDERS):
        assert (row["lines"], row["line"], row["branches"], row["branch"]) == (10, 80.0, 4, 100.0), row


def test_counts_of_what_was_compiled_anew_are_forgotten(build, tmp_path):
    build(cpp.FOLDERS)
    kept, outdated = (next(tmp_path.rglob(f"{folder}-main-*.gcda")) for folder in cpp.FOLDERS[:2])
    os.utime(outdated, (0, 0))
    cpp.forget_outdated(tmp_path / "build")
    assert kept.exists() and not outdated.exists()


def test_a_folder_of_which_nothing_was_counted(build):
    with pytest.raises(counting.CoverageError, match="golden/: no line was counted"):
        build(cpp.FOLDERS[:-1])


def test_what_gcovr_complains_of_is_passed_on(tmp_path):
    with pytest.raises(counting.CoverageError, match="gcovr: "):
        cpp.rows(tmp_path / "none", tmp_path / "none")
