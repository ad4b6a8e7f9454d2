"""Reports that commands have written, and results of releases: tables of them, and texts with their figures.

SPDX-License-Identifier: Apache-2.0
"""
