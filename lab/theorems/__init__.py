"""The arithmetic units against what they should compute, for all operands.

SPDX-License-Identifier: Apache-2.0
"""
