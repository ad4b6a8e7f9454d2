"""What a vertex costs in an evaluator of standard cells, by the toggles of its nets.

SPDX-License-Identifier: Apache-2.0
"""
