"""Tables and pictures of what has been measured, and the blocks of the texts (lab/docs/figures.md).

    modules      by name, what makes the tables of each report, and the pictures
    studies/     a module a report: its tables, the figures that follow from it, what is printed
    charts/      a module a picture, the only ones that need matplotlib and pandas

tools/reports/results.py reads reports, tools/reports/text_blocks.py writes and checks the blocks.

SPDX-License-Identifier: Apache-2.0
"""
