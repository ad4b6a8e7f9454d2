"""What looks at the checkout: lint with its rules, tests that were skipped, packages that are missing.

SPDX-License-Identifier: Apache-2.0
"""
