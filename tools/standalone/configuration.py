"""The configuration of a standalone core: from options to a value of each parameter of its top, and which
parameters stay free, within which range.

SPDX-License-Identifier: Apache-2.0
"""

import itertools
import re
from dataclasses import dataclass

from tools.csv_table import TableError
from tools.rtl import module_header, rtl_sources
from tools.standalone import elaboration
from tools.tables import configurations, features, formats, gone, organizations, parameter_space, register_texts

TOPS = ("hwffd_stream", "hwffd_stream_bus", "hwffd_axi", "hwffd_wishbone")
DEFAULT_ORG, DEFAULT_FORMAT, DEFAULT_FEATURES = "cg1", "fx18", "resident+interleaved"
# Options that are columns of configurations.csv, and the parameters that each sets.
ROW_OPTIONS = {"n": "N", "schedule": "SCHEDULE", "evaluator": "EVALUATOR", "mul_latency": "MUL_LATENCY",
               "add_latency": "ADD_LATENCY", "fma_latency": "FMA_LATENCY", "convert_latency": "CONVERT_LATENCY"}

# Parameters that change no bit of a result, and the values within which they stay free.
LATENCIES = ("MUL_LATENCY", "ADD_LATENCY", "FMA_LATENCY", "CONVERT_LATENCY")
MOST_LATENCY = 8
# What is in no core, and what no testbench would wait for.
MOST = {**dict.fromkeys(LATENCIES, 32), **dict.fromkeys(("IN_FLIGHT", "WAITING", "READ_DEPTH", "WRITE_DEPTH"), 1 << 15)}
LEAST_TIMEOUT = 1024  # clocks: a memory may pause, and that of the testbench does
FREE = {
    **{name: range(MOST_LATENCY + 1) for name in LATENCIES},
    "IN_FLIGHT": (0, *(1 << bit for bit in range(2, 11))),
    "WAITING": tuple(1 << bit for bit in range(1, 9)),
    "READ_OUTSTANDING": tuple(1 << bit for bit in range(1, 7)),
    "WRITE_OUTSTANDING": tuple(1 << bit for bit in range(1, 7)),
    "FLUSH_CLOCKS": range(1, 65536),
    "BUS_TIMEOUT": range(LEAST_TIMEOUT, parameter_space.TIMEOUT_MOST + 1),
    "AXI_PROT": range(8),
    "AXI_CACHE": (0, 1, 2, 3, 6, 7, 10, 11, 14, 15),
}


class Refused(TableError):
    """A core that cannot be, in one line."""


@dataclass(frozen=True)
class Free:
    """A parameter that stays free: what it may be."""

    name: str
    values: object  # a range, or a tuple of values

    @property
    def text(self):
        """In words."""
        if isinstance(self.values, range):
            return f"{self.values[0]} to {self.values[-1]}"
        *some, last = map(str, self.values)
        return f"{', '.join(some)} or {last}"

    @property
    def forbidden(self):
        """The condition, in Verilog, of a value that it must not have."""
        if isinstance(self.values, range):
            return f"{self.name} < {self.values[0]} || {self.name} > {self.values[-1]}"
        return " && ".join(f"{self.name} != {value}" for value in self.values)

    def samples(self):
        """Values at its ends and between them."""
        values = list(self.values) if len(self.values) < 64 else [
            self.values[0], self.values[1], self.values[len(self.values) // 2], self.values[-1]]
        return values


@dataclass(frozen=True)
class Core:
    """What a folder is made of."""

    top: str  # hwffd_stream and so on
    prefix: str  # name of its top, and in front of all its modules
    parameters: dict  # name -> value, all of the top
    defaults: dict  # those of the RTL
    free: dict  # name -> Free
    organization: organizations.Organization
    number_format: formats.Format
    command: str  # the line that makes the folder

    @property
    def has(self):
        """Names of its features."""
        return features.names_of(self.parameters)

    @property
    def evaluator(self):
        return configurations.evaluator_of(self.parameters["EVALUATOR"])

    @property
    def schedule(self):
        return configurations.SCHEDULES[self.parameters["SCHEDULE"]]

    @property
    def has_registers(self):
        return self.top in ("hwffd_axi", "hwffd_wishbone")

    @property
    def fixed(self):
        return {name: value for name, value in self.parameters.items() if name not in self.free}


def _row(options, known):
    """The row of configurations.csv that gives what no option says. Raises TableError."""
    rows = configurations.read()
    if options.row:
        return configurations.find(rows, options.row)
    org = options.org or DEFAULT_ORG
    if org not in known:
        gone.refuse(org)
        raise Refused(f"--org {org}: unknown organization: one of {', '.join(known)}")
    rows = [row for row in rows if row.org == org]
    for column in ("format", "n", "schedule", "evaluator"):
        wanted = getattr(options, column) or (DEFAULT_FORMAT if column == "format" and not options.org else None)
        rows = [row for row in rows if wanted is None or getattr(row, column) == wanted] or rows
    # Overlapped is what a core is made for; the paper's schedule is there to compare with.
    return sorted(rows, key=lambda row: row.schedule != configurations.SCHEDULES[0])[0]


def _features(options):
    """The names of what is built: those asked for, or the usual ones and what other options want."""
    if options.features:
        return options.features
    wanted = DEFAULT_FEATURES
    return wanted + ("+pages" if (options.axis or 0) > 32 or options.pages not in (None, 2) else "")


def _settings(options, known):
    """name -> value of --set NAME=VALUE. Raises Refused."""
    values = {}
    for text in options.set:
        name, _, value = text.partition("=")
        if name not in known or not re.fullmatch("[0-9]{1,10}", value):
            raise Refused(f"--set {text}: NAME=NUMBER wanted, of a parameter of the top: {', '.join(known)}")
        values[name] = int(value)
    return values


def _modelled(organization, number_format, fma_latency, evaluator):
    """Raises Refused where no bit-true model has the arithmetic, so that no expected words could be."""
    kinds = {configurations.texts.model_kind(row.organization, row.number_format, row.fma_latency, row.evaluator)
             for row in configurations.read()}
    def known(of):
        return configurations.texts.model_kind(organization, of, fma_latency, evaluator) in kinds
    if not known(number_format):
        names = [of.name for of in formats.read().by_name.values() if known(of)]
        raise Refused(f"no bit-true model of {organization.name} in {number_format.name} with these units: "
                      f"{'it has ' + ', '.join(names) if names else 'see rtl/configurations.csv'}")


def _latencies(space, top, parameters):
    """Those latencies that stay free, name -> Free: as far as any combination of them is legal."""
    names = [name for name in LATENCIES if name != "FMA_LATENCY" or parameters[name] > 0]

    def alone(name, most):
        if parameters[name] > MOST_LATENCY:
            return [parameters[name]]
        lowest = 1 if name == "FMA_LATENCY" else 0
        legal = [value for value in range(lowest, most + 1)
                 if not space.faults(top, {**parameters, name: value})]
        return legal or [parameters[name]]

    for most in range(MOST_LATENCY, 0, -1):
        legal = {name: alone(name, max(most, parameters[name])) for name in names}
        corners = itertools.product(*({values[0], parameters[name], values[-1]} for name, values in legal.items()))
        if all(not space.faults(top, {**parameters, **dict(zip(names, corner))}) for corner in corners):
            return {name: Free(name, range(values[0], values[-1] + 1))
                    for name, values in legal.items() if len(values) > 1}
    return {}


def _free(space, top, parameters):
    """name -> Free of a configuration."""
    found = _latencies(space, top, parameters)
    for name, values in FREE.items():
        if name in LATENCIES or name not in parameters or parameters[name] not in values:
            continue
        if isinstance(values, range):
            found[name] = Free(name, values)
        else:
            legal = tuple(value for value in values if not space.faults(top, {**parameters, name: value}))
            found[name] = Free(name, legal)
    return {name: found[name] for name in parameters if name in found}


def core(options):
    """The core that options ask for. Raises TableError."""
    known = organizations.read()
    row = _row(options, known)
    space, sources = parameter_space.Space(), rtl_sources.Sources()
    defaults = module_header.parameters(sources, options.top)
    number_format = formats.read().find(options.format) if options.format else row.number_format
    organization = known[options.org] if options.org else row.organization
    parameters = {**defaults, **row.parameters, "ORG": organization.number, "FORMAT": number_format.number}
    for option, name in ROW_OPTIONS.items():
        if getattr(options, option) is not None:
            parameters[name] = value_of(option, getattr(options, option))
    parameters.update(features.parameters_of(features.value(_features(options), "--features")))
    for name in ("axis", "pages", "spans", "data_width"):
        if getattr(options, name) is not None:
            if name.upper() not in defaults:
                raise Refused(f"--{name.replace('_', '-')}: {options.top} has none")
            parameters[name.upper()] = getattr(options, name)
    parameters.update(_settings(options, defaults))
    for name, most in MOST.items():
        if parameters.get(name, 0) > most:
            raise Refused(f"{name} is {parameters[name]}: {most} at most wanted of a core by itself")
    for name in features.followed(options.features or ""):
        if not features.has(parameters, name):
            raise Refused(f"--features {options.features}: {name} needs {register_texts.condition(name)}")
    refuse_faults(space, options.top, parameters)
    return of_parameters(space, options.top, options.prefix, parameters, options.command_line)


def value_of(option, text):
    """Of an option that has words, the number of its word."""
    words = {"schedule": {word: at for at, word in enumerate(configurations.SCHEDULES)},
             "evaluator": configurations.EVALUATORS}.get(option)
    return words[text] if words else text


def refuse_faults(space, top, parameters):
    """Raises Refused, with the guard of the RTL, where a configuration cannot be."""
    for kind in gone.KINDS:
        number = parameters[kind.upper()]
        one = gone.find(kind, number=number)
        if one:
            raise Refused(f"{kind.upper()} is {number}: {one}")
    for fault in space.faults(top, parameters):
        if isinstance(fault, parameter_space.Rule):
            values = ", ".join(f"{name} is {parameters[name]}" for name in fault.names)
            text = f"{fault.text} ({values})"
        else:
            text = f"{fault.name} is {parameters[fault.name]}: {fault.values} wanted"
        guards = [name for name in elaboration.Design(top).guards(parameters)
                  if re.fullmatch(f"ERROR_(?:{fault.guard})", name)]
        raise Refused(text + (f"; the RTL refuses it by {guards[0]}" if guards else ""))


def of_parameters(space, top, prefix, parameters, command=""):
    """The core of a legal configuration. Raises Refused where it has no model."""
    defaults = module_header.parameters(rtl_sources.Sources(), top)
    parameters = {name: parameters.get(name, default) for name, default in defaults.items()}
    if 0 < parameters.get("BUS_TIMEOUT", 0) < LEAST_TIMEOUT:
        raise Refused(f"BUS_TIMEOUT is {parameters['BUS_TIMEOUT']}: the memory of the testbench pauses for longer; "
                      f"0, or {LEAST_TIMEOUT} or more wanted")
    if parameters.get("BESIDE"):
        raise Refused(f"BESIDE is {parameters['BESIDE']}: that is hwffd_stream inside hwffd_adjoint; 0 wanted")
    if parameters.get("RESULT_WIDTH", 128) != 128:
        raise Refused(f"RESULT_WIDTH is {parameters['RESULT_WIDTH']}: that is hwffd_stream inside hwffd_stream_bus; "
                      "--top hwffd_stream_bus --data-width 256 wanted")
    organization, number_format = space.organizations[parameters["ORG"]], space.formats[parameters["FORMAT"]]
    _modelled(organization, number_format, parameters["FMA_LATENCY"],
              configurations.evaluator_of(parameters["EVALUATOR"]))
    return Core(top, prefix, parameters, defaults, _free(space, top, parameters), organization, number_format, command)
