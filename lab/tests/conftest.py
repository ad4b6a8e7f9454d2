"""The fixtures of the product's tests.

SPDX-License-Identifier: Apache-2.0
"""

pytest_plugins = ["tests.conftest"]
