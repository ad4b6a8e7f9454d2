"""kubectl, which must know the cluster and the namespace: its context does.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess


class KubectlError(Exception):
    """What kubectl complained of, in one line."""


def call(*words, given=None):
    """What it prints. Raises KubectlError."""
    try:
        result = subprocess.run(["kubectl", *words], input=given, capture_output=True, text=True, check=False)
    except FileNotFoundError as error:
        raise KubectlError("kubectl not found: install it on the machine that submits") from error
    if result.returncode:
        raise KubectlError(" ".join((result.stderr or "kubectl ended without a word").split()))
    return result.stdout.strip()
