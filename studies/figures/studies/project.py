"""What the sources themselves say of the project.

SPDX-License-Identifier: Apache-2.0
"""

import configurations
import organizations
import rtl
import version

TABLES = {}
FIGURES = {
    "version": lambda reports: str(version.read(reports.root)),
    "configurations": lambda reports: len(
        configurations.read(reports.root / "rtl" / "configurations.csv")),
    "organizations": lambda reports: len(organizations.read(reports.root / "rtl")),
    "modules": lambda reports: len(rtl.Sources(reports.root).modules()),
}
