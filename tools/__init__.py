"""What makes, checks and maps the product: tables, RTL, synthesis, rules.

A command is a module, run in the root of the checkout or with it in PYTHONPATH:
python3 -m tools.checks.lint.

SPDX-License-Identifier: Apache-2.0
"""
