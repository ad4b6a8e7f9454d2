"""Pairs of volumes aligned by hwffd and by programs of others, each pair with its truth.

SPDX-License-Identifier: Apache-2.0
"""
