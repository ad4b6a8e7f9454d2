#!/usr/bin/env python3
"""Builds the library and the module under AddressSanitizer and UndefinedBehaviorSanitizer, and runs
test_fuzz.py on them.

    sanitized.py CMAKE BUILD CASES

BUILD is a folder of its own, CASES how many cases all its tests try together.

SPDX-License-Identifier: Apache-2.0
"""

import os
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
FUZZ = pathlib.Path(__file__).with_name("test_fuzz.py")
OPTIONS = ("-fsanitize=address,undefined,float-cast-overflow -fno-sanitize-recover=all "
           "-fno-omit-frame-pointer -fno-sanitize=vptr -O1 -g1 -UNDEBUG "
           "-Wno-stringop-overflow")  # of fmt's buffers, which gcc loses sight of behind a check
LIBRARIES = "libasan.so", "libubsan.so", "libstdc++.so"


def path_of(library):
    """Where the compiler has it."""
    return subprocess.run(["c++", f"-print-file-name={library}"], check=True, text=True,
                          stdout=subprocess.PIPE).stdout.strip()


def main():
    cmake, build, cases = sys.argv[1:]
    tests = FUZZ.read_text().count("\n@hypothesis.given(")
    environment = dict(
        os.environ, PYTHONPATH=f"{build}/api/python", PYTHONMALLOC="malloc",
        HWFFD_FUZZ_CASES=str(-(-int(cases) // tests)),
        # Python leaves what it has to the system; where memory is short, NULL is an answer.
        ASAN_OPTIONS="detect_leaks=0:allocator_may_return_null=1",
        LD_PRELOAD=" ".join(map(path_of, LIBRARIES)))
    for words in ([cmake, "-S", ROOT, "-B", build, "-G", "Ninja", "--log-level=NOTICE",
                   "-DHWFFD_LIBRARY_ONLY=ON", "-DCMAKE_BUILD_TYPE=Debug",
                   f"-DCMAKE_CXX_FLAGS_DEBUG={OPTIONS}"],
                  [cmake, "--build", build, "--target", "hwffd_python"]):
        subprocess.run(words, check=True)
    return subprocess.run([sys.executable, "-B", "-m", "pytest", "-p", "no:cacheprovider", FUZZ],
                          env=environment, check=False).returncode


if __name__ == "__main__":
    sys.exit(main())
