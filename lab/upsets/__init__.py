"""Single bits of registers and memories flip while traffic runs, and what becomes of each.

SPDX-License-Identifier: Apache-2.0
"""
