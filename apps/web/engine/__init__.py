"""What the live page knows of the cores' designs.

SPDX-License-Identifier: Apache-2.0
"""
