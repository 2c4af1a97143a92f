"""Simulation and design of cageless ball bearings with a discrete raceway.

A :class:`Case` is a bearing, its operation and how it is to be simulated. ``case.run()``,
``case.static()`` and ``case.design()`` compute; :func:`sweep` computes many variants of a
case, here or on a cluster. Results have arrays of numpy, ``data_*()`` as frames of pandas
and ``plot_*()`` as figures of plotly. Names end in their unit.

Examples
--------
>>> import cageless
>>> case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.005})
>>> run = case.run()
>>> figure = run.plot_gaps()
"""

from ._cageless import __version__, instruction_set
from .case import Case, template
from .errors import CagelessError, InputError, UnphysicalError
from .plan import Plan, span
from .results import Design, Run, Static
from .sections import (
    Bearing,
    Contact,
    Housing,
    Material,
    Model,
    Operation,
    Output,
    Raceway,
    Solver,
    Start,
)
from .sweeps import SweepReport, SweepResult, merge, report, sweep

__all__ = [
    "Bearing",
    "CagelessError",
    "Case",
    "Contact",
    "Design",
    "Housing",
    "InputError",
    "Material",
    "Model",
    "Operation",
    "Output",
    "Plan",
    "Raceway",
    "Run",
    "Solver",
    "Start",
    "Static",
    "SweepReport",
    "SweepResult",
    "UnphysicalError",
    "__version__",
    "instruction_set",
    "merge",
    "report",
    "span",
    "sweep",
    "template",
]
