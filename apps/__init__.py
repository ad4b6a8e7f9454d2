"""Programs of the product; those in Python are packages.

SPDX-License-Identifier: Apache-2.0
"""
