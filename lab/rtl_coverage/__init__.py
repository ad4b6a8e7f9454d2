"""Which lines, branches and bits of the RTL the tests run, and which lines of the C++.

SPDX-License-Identifier: Apache-2.0
"""
