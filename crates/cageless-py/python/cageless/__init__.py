"""Simulation and design of cageless ball bearings with a discrete raceway.

A :class:`Case` is a bearing, its operation and how it is to be simulated. ``case.run()``,
``case.static()``, ``case.design()``, ``case.search()`` and ``case.tolerance()`` compute,
``case.export()`` writes the ring for CAD; :func:`sweep` computes many variants of a
case, here or on a cluster. A :class:`Result` has its numbers as attributes, arrays of NumPy,
``data_*()`` as frames of pandas and ``plot_*()`` as figures of plotly. Names end in their unit.

Examples
--------
>>> import cageless
>>> case = cageless.Case.from_toml(cageless.template(), {"solver.duration_s": 0.005})
>>> run = case.run()
>>> figure = run.plot_gaps()
"""

from . import case, computations, errors, exports, plan, result, results, rotors, sections, sweeps
from ._cageless import __version__, instruction_set
from .case import *
from .computations import *
from .errors import *
from .exports import *
from .plan import *
from .result import *
from .results import *
from .rotors import *
from .sections import *
from .sweeps import *

__all__ = ["__version__", "instruction_set"]
__all__ += case.__all__
__all__ += computations.__all__
__all__ += errors.__all__
__all__ += exports.__all__
__all__ += plan.__all__
__all__ += result.__all__
__all__ += results.__all__
__all__ += rotors.__all__
__all__ += sections.__all__
__all__ += sweeps.__all__
