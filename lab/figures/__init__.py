"""Tables, pictures and figures in texts, drawn from what the studies have measured.

A study is a program that measures and writes build/reports/NAME.json. This package prints it as a
table, draws it, and takes it into docs/reports/NAME.json, which is committed: from there come the
pictures in docs/ and every figure that stands between markers in a text (docs/figures.md).

    catalogue    what reports there are: the command that measures each, and the sources it measures
    sources      the key of these sources, the same where only comments, blanks or places change
    reports      reports of a folder, read once
    measure      runs a study, stamps its report with that hash, and takes it into docs/reports/
    expressions  what a marker says: a field of a row, a sum, a quotient, and its format
    markers      texts with their markers filled; table: Markdown and columns for a terminal
    check        what lint says: texts that differ from their reports, reports that are stale
    lab/     a module a report: its tables, the figures that follow from it, what is printed
    charts/      a module a picture, the only ones that need matplotlib and pandas

SPDX-License-Identifier: Apache-2.0
"""
