"""The iterates of minimize() are those of L-BFGS-B in SciPy, which has the same line search, without bounds.

SPDX-License-Identifier: Apache-2.0
"""

import subprocess

import numpy as np
import pytest
from scipy.optimize import minimize


def quadratic(x):
    n = np.arange(1, len(x) + 1)
    coupled = np.diff(x)
    gradient = n * (x - n)
    gradient[1:] += coupled
    gradient[:-1] -= coupled
    return (n * (x - n) ** 2).sum() / 2 + (coupled ** 2).sum() / 2, gradient


def rosenbrock(x):
    a = x[1:] - x[:-1] ** 2
    gradient = np.zeros_like(x)
    gradient[:-1] = -400 * x[:-1] * a - 2 * (1 - x[:-1])
    gradient[1:] += 200 * a
    return (100 * a ** 2 + (1 - x[:-1]) ** 2).sum(), gradient


@pytest.mark.parametrize("function", (quadratic, rosenbrock))
@pytest.mark.parametrize("size", (2, 5, 20))
@pytest.mark.parametrize("memory", (3, 8))
def test_iterates(arguments, function, size, memory):
    words = [arguments[0], function.__name__, str(size), str(memory)]
    lines = subprocess.run(words, check=True, capture_output=True, text=True).stdout.splitlines()
    ours = np.array([line.split() for line in lines], np.float64)
    evaluations, iterates = [], []
    counted = [0]

    def value(x):
        counted[0] += 1
        return function(x)

    def visit(x):
        evaluations.append(counted[0])
        iterates.append(x.copy())

    start = np.where(np.arange(size) % 2 == 0, -1.2, 1.0)
    minimize(value, start, jac=True, method="L-BFGS-B", callback=visit,
             options={"maxcor": memory, "ftol": 0, "gtol": 1e-8, "maxiter": 1000})
    # Both round differently, and what is rounded grows from step to step: the first ones are the same, as long as
    # they are not at the minimum, where what is rounded is all that is left of the gradient.
    moving = [np.abs(x - iterates[-1]).max() > 1e-4 for x in iterates[:15]]
    same = moving.index(False) if False in moving else len(moving)
    assert same >= 4
    assert ours[:same, 0].tolist() == evaluations[:same]
    assert np.abs(ours[:same, 1:] - iterates[:same]).max() < 1e-6
    assert np.abs(ours[-1, 1:] - iterates[-1]).max() < 1e-6
