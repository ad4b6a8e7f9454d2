"""Configurations drawn at random from the legal space, and others that break one of its rules.

Small cores are drawn more often than large ones, since they are built and run in seconds.

SPDX-License-Identifier: Apache-2.0
"""

from tools.tables import features, parameter_space as spaces
from tools.tables.parameter_values import Between, Powers

TRIES = 20_000  # until a rule is broken, and no other
UNITS = 130  # Icarus elaborates what has no more in a few seconds; the largest cores take half a minute


class DrawError(Exception):
    """What cannot be drawn, in one line."""


class Draw:
    """Draws of one top; `random` is a random.Random. What is drawn has at most so many units of `size`, or
    those of an organization that is asked for, and one of these formats, by number, or any."""

    def __init__(self, space, top, random, units=UNITS, formats=None):
        self.space, self.top, self.random, self.units = space, top, random, units
        self.formats = space.formats if formats is None else {n: space.formats[n] for n in formats}
        self.parameters = space.parameters[top]

    def legal(self, **fixed):
        """A legal configuration, {name: value}, with these values. Raises DrawError."""
        most = self.units
        if "ORG" in fixed and (org := self.space.organizations[fixed["ORG"]]).n:
            most = max(most, products(org, org.n))
        for _ in range(TRIES):
            drawn = self._proposal(fixed) | fixed
            if not self.space.faults(self.top, drawn) and size(self.space, drawn) <= most:
                return drawn
        raise DrawError(f"{self.top}: no legal configuration with {fixed}")

    def beyond(self, parameter, value, **fixed):
        """A configuration that is legal, with these values, but for that value of a parameter."""
        return self.legal(**fixed) | {parameter.name: value}

    def breaking(self, rule, **fixed):
        """A configuration with these values that breaks that rule alone. Raises DrawError."""
        for _ in range(TRIES):
            drawn = self._proposal(fixed)
            if size(self.space, drawn) > self.units:
                continue
            for name in self.random.sample(rule.names, self.random.randint(1, len(rule.names))):
                drawn[name] = self._any(name)
            drawn |= fixed
            if self.space.faults(self.top, drawn) == [rule]:
                return drawn
        raise DrawError(f"{self.top}: nothing breaks only this: {rule.text}")

    def _chance(self, share):
        return self.random.random() < share

    def _any(self, name):
        """A value of a parameter's range, the larger the rarer where it has no end."""
        part = self.random.choice(self.parameters[name].values.parts)
        if isinstance(part, Powers):
            steps = (part.most // part.least).bit_length() - 1 if part.most else 16
            return part.least << self.random.randint(0, steps)
        if part.most is None:
            return part.least + min(self.random.randint(0, 30), self.random.randint(0, 30))
        return self.random.randint(part.least, part.most)

    def _proposal(self, fixed):
        """One that is legal more often than not; what is fixed decides what goes with it."""
        drawn = self._row(fixed) | self._store(fixed) | self._bus(fixed)
        return {name: drawn[name] if name in drawn else self._any(name) for name in self.parameters}

    def _row(self, fixed):
        """What a row of configurations.csv has."""
        every = self.space.organizations
        # Those whose N is chosen are as many as there are small N.
        weighed = [number for number, organization in every.items() for _ in range(1 if organization.n else 4)]
        org = every[fixed.get("ORG", self.random.choice(weighed))]
        words = ["fixed"] * 3
        words += [word for word in ("float", "block") if word in org.of_form.words]
        word = self.random.choice(words)
        number = self.random.choice([n for n, f in self.formats.items() if f.words == word])
        evaluators = (spaces.PIPELINED, *[spaces.POWERS if org.weighs_axes else spaces.ITERATIVE] * 2)
        return {
            "ORG": org.number,
            "N": org.n or 1 << self.random.choice((0, 1, 1, 2, 2, 3, 3, 4, 5)),
            "FORMAT": number,
            "SCHEDULE": int(org.formulas["paper"] is not None and self._chance(0.25)),
            "EVALUATOR": self.random.choice(evaluators),
            "MUL_LATENCY": self.random.choice((1, 1, 2, 2, 2, 3, 4, 5, 6)),
            "ADD_LATENCY": self.random.choice((1, 1, 1, 2, 2, 3, 4, 5, 7)),
            "FMA_LATENCY": self.random.randint(1, 8) if word == "float" and self._chance(0.5) else 0,
            "CONVERT_LATENCY": self.random.choice((0, 1, 1, 1, 2, 3)),
        }

    def _store(self, fixed):
        """What is built around the evaluator."""
        has = {name: self._chance(share) for name, share in {
            "resident": 0.95, "interleaved": 0.6, "derivatives": 0.5, "determinant": 0.6, "pages": 0.6,
            "spans": 0.3, "grids": 0.35, "packed": 0.35, "large": 0.06, "fourth": 0.4, "marks": 0.6,
            "halves": 0.3}.items()}
        has["interleaved"] = has["interleaved"] or not has["resident"]
        has["determinant"] = has["determinant"] and has["derivatives"]
        for name in ("pages", "grids", "packed"):
            has[name] = has[name] and has["resident"]
        for name in ("large", "fourth", "marks", "halves"):
            has[name] = has[name] and has["pages"]
        has |= {name: bool(fixed[parameter]) for name, parameter in features.PARAMETERS.items() if parameter in fixed}
        axis = self.random.choice((4, 4, 4, 5, 6, 7, 8, 9, 12, 16, 17, 20))
        return {
            **{parameter: int(has[name]) for name, parameter in features.PARAMETERS.items()},
            "AXIS": self.random.choice((33, 40, 64)) if has["large"] else axis,
            "PAGES": self.random.choice((1, 1, 2, 2, 3, 3, 4, 5, 7)) if has["pages"] else 2,
            "SPANS": self.random.choice((2, 3, 4, 5, 8, 13, 16)) if has["spans"] else 1,
            "IN_FLIGHT": self.random.choice((0, 0, 0, 4, 8, 16, 32)),
            "WAITING": self.random.choice((2, 2, 4, 8, 16)),
            "HARDENED": int(self._chance(0.35)),
        }

    def _bus(self, fixed):
        """Of the DMA, what goes together."""
        burst = fixed.get("MAX_BURST", 2 << self.random.randint(0, 7))
        bits = fixed.get("ID_WIDTH", 16 if "ID" in fixed else self.random.randint(1, 16))
        return {
            "MAX_BURST": burst,
            "READ_DEPTH": burst << self.random.randint(1, 3),
            "WRITE_DEPTH": burst << self.random.randint(1, 3),
            "READ_OUTSTANDING": 2 << self.random.randint(0, 4),
            "WRITE_OUTSTANDING": 2 << self.random.randint(0, 4),
            "ID_WIDTH": bits,
            "ID": self.random.randrange(1 << bits),
        }


def products(organization, n):
    """Multiplications of sums that it does side by side."""
    return (organization.units or n) * 3 / organization.fold * (organization.lanes if organization.fold == 3 else 1)


def size(space, configuration):
    """Of a configuration's arithmetic: about how many multipliers of 18 bits. The transpose has no organization."""
    if "ORG" not in configuration:
        return 63 if configuration["ROWS"] == 0 else 43
    number_format = space.formats[configuration["FORMAT"]]
    return products(space.organizations[configuration["ORG"]], configuration["N"]) * (4 if number_format.words != "fixed" else 1 if number_format.width <= 18 else 3)


def ends(parameter):
    """The ends of a parameter's values, and a value within where a range has no end."""
    values = set(parameter.values.ends())
    for part in parameter.values.parts:
        if part.most is None and isinstance(part, Between):
            values.add(part.least + 3)
    return sorted(values)
