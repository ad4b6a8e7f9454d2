"""All studies, one after the other, on one commit without local changes, for a release.

SPDX-License-Identifier: Apache-2.0
"""
