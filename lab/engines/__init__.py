"""The recorded commands through engines that share no line of code, and what X does there.

SPDX-License-Identifier: Apache-2.0
"""
