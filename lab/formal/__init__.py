"""Proves the properties of lab/formal/properties.csv, and that each proof finds a planted bug.

SPDX-License-Identifier: Apache-2.0
"""
