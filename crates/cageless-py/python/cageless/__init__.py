"""Simulation and design of cageless ball bearings with a discrete raceway.

A :class:`Case` is a bearing, its operation and how it is to be simulated. ``case.run()``,
``case.static()``, ``case.design()``, ``case.search()`` and ``case.tolerance()`` compute,
``case.export()`` writes the ring for CAD; :func:`sweep` computes many variants of a
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
from .verifications import Verification
from .errors import CagelessError, ColumnError, InputError, UnphysicalError
from .exports import Export
from .plan import Plan, span
from .designs import Design
from .drops import Drop
from .rotor_drops import RotorDrop
from .rotors import LinearRotor, RotorCase
from .runs import Run
from .statics import Static
from .searches import SearchMap, SearchResult
from .saving import load
from .sections import (
    Bearing,
    Contact,
    Housing,
    Material,
    Model,
    Operation,
    Output,
    Raceway,
    Rotor,
    Solver,
    Start,
    Support,
)
from .sweeps import SweepReport, SweepResult, merge, report, sweep
from .comparisons import RingComparison
from .tolerances import ToleranceResult

__all__ = [
    "Bearing",
    "CagelessError",
    "Case",
    "ColumnError",
    "Verification",
    "Contact",
    "Design",
    "Drop",
    "Export",
    "Housing",
    "InputError",
    "LinearRotor",
    "Material",
    "Model",
    "Operation",
    "Output",
    "Plan",
    "Raceway",
    "RingComparison",
    "Rotor",
    "RotorCase",
    "RotorDrop",
    "Run",
    "SearchMap",
    "SearchResult",
    "Solver",
    "Start",
    "Support",
    "Static",
    "SweepReport",
    "SweepResult",
    "ToleranceResult",
    "UnphysicalError",
    "__version__",
    "instruction_set",
    "load",
    "merge",
    "report",
    "span",
    "sweep",
    "template",
]
