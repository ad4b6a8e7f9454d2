"""What tests of made files have in common: each of them, changed or absent, is noticed and mended.

SPDX-License-Identifier: Apache-2.0
"""


def expect_stale_is_noticed(case, root, names, run):
    """`run` is the command in that checkout: (exit status, complaints)."""
    case.assertEqual(run("--root", root, "check"), (0, []))
    for name in names:
        with case.subTest(name):
            path = root / name
            text = path.read_text()
            for other in (text + "\n", None):
                path.unlink() if other is None else path.write_text(other)
                status, lines = run("--root", root, "check")
                case.assertEqual(status, 1)
                case.assertEqual(len([line for line in lines if name in line]), 1, lines)
                case.assertEqual(run("--root", root, "write"), (0, []))
                case.assertEqual(path.read_text(), text)
                case.assertEqual(run("--root", root, "check"), (0, []))
