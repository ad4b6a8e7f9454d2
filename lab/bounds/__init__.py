"""Bounds of the errors of weights and of every form, proved, beside errors that are reached.

SPDX-License-Identifier: Apache-2.0
"""
