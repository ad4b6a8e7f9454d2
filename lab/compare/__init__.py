"""What evaluates equation (1), on one core of this processor and in hardware.

SPDX-License-Identifier: Apache-2.0
"""
