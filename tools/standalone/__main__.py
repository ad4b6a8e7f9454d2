"""See tools/standalone/__init__.py.

SPDX-License-Identifier: Apache-2.0
"""

import sys

from tools.standalone.command import main

sys.exit(main())
