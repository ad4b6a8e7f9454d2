"""A core by itself: one configuration as a folder with which a design needs nothing else of the project.

    python3 -m tools.standalone --org walk --format fx17 -o my_ffd

docs/standalone.md says what is in the folder. `hwffd core` is the same program.

SPDX-License-Identifier: Apache-2.0
"""
