"""Random traffic with seeds that no test has had, for so many hours.

SPDX-License-Identifier: Apache-2.0
"""
