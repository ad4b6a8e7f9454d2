"""The live page as one file.

SPDX-License-Identifier: Apache-2.0
"""
