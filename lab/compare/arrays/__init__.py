"""Ten million points through a lattice, from array to array, by libraries of Python.

SPDX-License-Identifier: Apache-2.0
"""
