"""A module for each report, with

    TABLES            name -> function of Reports and arguments that makes a Table
    FIGURES           name -> function of Reports: figures that follow from the report
    printed(reports)  what its command prints, where that is not its table
    missing(reports)  what a report lacks that shall be committed, '' if nothing
    finished(reports) the report with what other reports add to it, as its command leaves it
    collect(root)     where its command writes something else: makes the report of that

SPDX-License-Identifier: Apache-2.0
"""
