"""Made from VERSION by tools/tables/generated_files.py; changes here are lost.

SPDX-License-Identifier: Apache-2.0
"""

VERSION = "0.3.0"
