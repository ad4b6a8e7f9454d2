"""The tables of the project, CSV, and what is made of them: RTL, C, C++, texts.

SPDX-License-Identifier: Apache-2.0
"""
