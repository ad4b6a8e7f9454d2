"""What was tried of the OpenGL extension, and what failed.

SPDX-License-Identifier: Apache-2.0
"""

import json


class Report:
    def __init__(self):
        self.commands = {}
        self.failed = []

    def add(self, name, compared, passed):
        """A row of the error table of a command; its name is "command: mistake".

        `compared`: whether Mesa made the same mistake beside it.
        """
        command = name.partition(":")[0]
        row = self.commands.setdefault(command, {"command": command, "cases": 0, "compared": 0,
                                                 "failed": 0})
        row["cases"] += 1
        row["compared"] += compared
        row["failed"] += not passed
        if not passed:
            self.failed.append(name)

    def text(self, calls, failed_checks):
        """build/reports/glapi.json, of so many calls and checks of what they do."""
        rows = [self.commands[command] for command in sorted(self.commands)]
        return json.dumps({"calls": calls, "error_cases": sum(row["cases"] for row in rows),
                           "compared_with_mesa": sum(row["compared"] for row in rows),
                           "failed": failed_checks + len(self.failed),
                           "failed_checks": failed_checks, "commands": rows}, indent=2) + "\n"

    def faults(self, called, declared):
        """A line for each error case that failed and each command that was not called."""
        return ([] if self.commands else ["no error cases tried"]) + [
            *(f"FAILED: {name}" for name in self.failed),
            *(f"not called: {name}" for name in sorted(declared - called))]


REPORT = Report()  # of this run
