"""The laboratory's tests.

SPDX-License-Identifier: Apache-2.0
"""
