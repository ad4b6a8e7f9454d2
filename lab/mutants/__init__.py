"""Single changes of the RTL, and whether the tests see them.

SPDX-License-Identifier: Apache-2.0
"""
