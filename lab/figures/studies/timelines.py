"""make organizations, too: which unit is busy when. Drawn, not printed.

SPDX-License-Identifier: Apache-2.0
"""

TABLES = {}
