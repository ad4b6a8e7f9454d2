"""A module for each report of the laboratory, as tools/reports/report_modules.py has those of the product's commands; and

    finished(reports) the report with what other reports add to it, as its command leaves it

SPDX-License-Identifier: Apache-2.0
"""
