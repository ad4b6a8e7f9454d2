"""The end of the interpreter, forks and subinterpreters while threads are in the library: nothing hangs or ends
the process.

SPDX-License-Identifier: Apache-2.0
"""

import os
import subprocess
import sys
import textwrap

import pytest

BUSY = """
import os, sys, threading, time
import hwffd
import numpy as np
points = np.random.default_rng(0).random((50000, 3))
lattice = hwffd.Lattice.around("sphere", points)
idle = hwffd.Lattice.around("box", points)
lattice.set_device("reference")
inside = threading.Event()
def forever():
    inside.set()
    while True:
        work()
def work():
    {work}
threading.Thread(target=forever, daemon=True).start()
inside.wait()
time.sleep({delay})
"""
WORK = {"deform": "hwffd.deform(lattice, points)", "embed": "lattice.embed(points)",
        "floats": "hwffd.deform(idle, points.astype(np.float32))",
        "wait": "hwffd.deform(lattice, points[:10])"}


def run(program, **names):
    result = subprocess.run([sys.executable, "-B", "-X", "faulthandler", "-W", "ignore", "-c",
                             BUSY.format(**names) + textwrap.dedent(program)],
                            text=True, check=False, capture_output=True, timeout=100)
    assert (result.returncode, result.stderr) == (0, ""), result
    return result.stdout


@pytest.mark.parametrize("work", WORK)
@pytest.mark.parametrize("delay", [0, 0.2])
def test_a_daemon_thread_inside_at_exit(work, delay):
    assert run('print("ends")', work=WORK[work], delay=delay) == "ends\n"


def test_the_main_thread_works_on_while_the_interpreter_ends():
    output = run("""
        import atexit
        atexit._run_exitfuncs()  # those of hwffd among them
        print(hwffd.deform(idle, points[:4]).shape)
        """, work=WORK["deform"], delay=0.1)
    assert output == "(4, 3)\n"


def test_many_daemon_threads_at_exit():
    output = run("""
        for _ in range(3):
            threading.Thread(target=forever, daemon=True).start()
        time.sleep(0.2)
        print("ends")
        """, work="hwffd.deform(idle, points[:3000]); lattice.dims", delay=0.1)
    assert output == "ends\n"


FORKS = """
    def in_child(call):
        child = os.fork()
        if child == 0:
            try:
                call()
                status = 0
            except hwffd.Error as error:
                text = str(error)
                status = 1 if "\\n" not in text and "when the process was forked" in text else 2
            os._exit(status)
        limit = time.monotonic() + 20
        while time.monotonic() < limit:
            done, status = os.waitpid(child, os.WNOHANG)
            if done:
                return os.waitstatus_to_exitcode(status)
            time.sleep(0.01)
        os.kill(child, 9)
        os.waitpid(child, 0)
        return "hangs"
"""


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_forks_while_a_thread_is_inside():
    output = run(textwrap.dedent(FORKS) + textwrap.dedent("""
        few = points[:10]
        embedding = idle.embed(few)
        seen = {}
        for name, call in {
                "busy": lambda: hwffd.deform(lattice, few), "dims": lambda: lattice.dims,
                "control points": lambda: lattice.control_points, "repr": lambda: repr(lattice),
                "idle": lambda: hwffd.deform(idle, points), "embedded": lambda: embedding.deform(idle),
                "new": lambda: hwffd.deform(hwffd.Lattice.around("sphere", points), few)}.items():
            seen[name] = {in_child(call) for _ in range(3)}
        print(sorted(name for name, all in seen.items() if all == {0}))
        print(sorted(name for name, all in seen.items() if all <= {0, 1}))
        """), work=WORK["embed"], delay=0.1)
    good, ended = output.splitlines()
    assert good == "['embedded', 'idle', 'new']"
    assert ended == "['busy', 'control points', 'dims', 'embedded', 'idle', 'new', 'repr']"


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_child_ends_as_a_program_does():
    """With the functions of atexit, while its parent has a thread inside."""
    output = run("""
        for _ in range(3):
            child = os.fork()
            if child == 0:
                threading.Thread(target=forever, daemon=True).start()
                hwffd.deform(idle, points)
                sys.exit(0)
            start = time.monotonic()
            assert os.waitpid(child, 0)[1] == 0
            assert time.monotonic() - start < 20
        print("ends")
        """, work="hwffd.deform(hwffd.Lattice.around('sphere', points), points)", delay=0.1)
    assert output == "ends\n"


SUBINTERPRETER = """
import hwffd
try:
    import _interpreters as interpreters
except ImportError:
    import _xxsubinterpreters as interpreters
code = '''
try:
    import hwffd
except ImportError as error:
    print(str(error).count(chr(10)), "subinterpreter" in str(error), flush=True)
else:
    print("imported", flush=True)
'''
for _ in range(2):
    interpreters.run_string(interpreters.create(), code)
print(hwffd.Lattice.around("box", [[0, 0, 0], [1, 1, 1]]).dims, flush=True)
"""


@pytest.mark.parametrize("first", ["import hwffd", "import sys"])
def test_a_subinterpreter_is_refused(first):
    program = SUBINTERPRETER.replace("import hwffd", first, 1)
    if first != "import hwffd":
        program = program.replace("print(hwffd.Lattice", "import hwffd; print(hwffd.Lattice")
    result = subprocess.run([sys.executable, "-B", "-W", "ignore", "-c", program], text=True, check=False,
                            capture_output=True, timeout=60)
    assert (result.returncode, result.stderr) == (0, "")
    assert result.stdout == "0 True\n" * 2 + "[4, 4, 4]\n"
