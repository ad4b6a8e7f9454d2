"""The RTL as its tools see it: files, headers, elaborated designs, keys.

SPDX-License-Identifier: Apache-2.0
"""
