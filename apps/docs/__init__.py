"""The texts as a site.

SPDX-License-Identifier: Apache-2.0
"""
