"""What measures and proves the product. Each study in Python is a package: python3 -m lab.STUDY.

SPDX-License-Identifier: Apache-2.0
"""
