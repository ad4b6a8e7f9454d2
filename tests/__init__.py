"""The product's tests.

SPDX-License-Identifier: Apache-2.0
"""
