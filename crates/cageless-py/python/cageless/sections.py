"""The sections of a case. Fields are the keys of the case file, in its units; what is left
``None`` takes its default."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from html import escape
from typing import Any, Literal

__all__ = [
    "Bearing",
    "Contact",
    "Housing",
    "Material",
    "Model",
    "Operation",
    "Output",
    "Raceway",
    "Section",
    "Solver",
    "Start",
]


def table(rows: list[tuple[str, object]], caption: str) -> str:
    """Rows of names and values as HTML."""
    body = "".join(
        f"<tr><th style='text-align:left'>{escape(name)}</th><td>{escape(str(value))}</td></tr>"
        for name, value in rows
    )
    return f"<table><caption>{escape(caption)}</caption>{body}</table>"


@dataclass(frozen=True, kw_only=True)
class Section:
    """A section of a case file."""

    def values(self) -> dict[str, Any]:
        """Keys that are given, with their values."""
        items = ((field.name, getattr(self, field.name)) for field in fields(self))
        return {name: value for name, value in items if value is not None}

    def _repr_html_(self) -> str:
        return table(list(self.values().items()), type(self).__name__)


@dataclass(frozen=True, kw_only=True)
class Bearing(Section):
    """Rings and balls.

    Parameters
    ----------
    balls : int
        N, number of balls, 3 or more.
    ball_radius_mm : float
        Rw.
    inner_groove_bottom_radius_mm, outer_groove_bottom_radius_mm : float
        Ri and Ro. Ro − Ri − 2 Rw is half the radial internal clearance Gr of ISO 5753-1.
    outer_shoulder_radius_mm : float
        Ros, bore of the outer ring's shoulder.
    inner_groove_curvature_radius_mm, outer_groove_curvature_radius_mm : float
        Radii of the grooves in the meridian plane.
    inner_ring_mass_kg : float
        Mass of the inner ring with what turns with it.
    inner_ring_drag_n_s_m : float
        Damping of the inner ring, C of Zhao 2022, Eq. (14).
    ball_radius_deviation_um : sequence of float, optional
        Deviation of each ball's radius.
    outer_ring_outer_radius_mm, outer_ring_width_mm : float, optional
        Outer ring, for the export to CAD.
    """

    balls: int
    ball_radius_mm: float
    inner_groove_bottom_radius_mm: float
    outer_groove_bottom_radius_mm: float
    outer_shoulder_radius_mm: float
    inner_groove_curvature_radius_mm: float
    outer_groove_curvature_radius_mm: float
    inner_ring_mass_kg: float
    inner_ring_drag_n_s_m: float
    ball_radius_deviation_um: Sequence[float] | None = None
    outer_ring_outer_radius_mm: float | None = None
    outer_ring_width_mm: float | None = None


@dataclass(frozen=True, kw_only=True)
class Material(Section):
    """Elastic material of rings and balls.

    Parameters
    ----------
    density_kg_m3 : float, optional
        Density of the balls.
    youngs_modulus_gpa : float, optional
        E.
    poisson_ratio : float, optional
        0 to below 0.5.
    """

    density_kg_m3: float | None = None
    youngs_modulus_gpa: float | None = None
    poisson_ratio: float | None = None


@dataclass(frozen=True, kw_only=True)
class Raceway(Section):
    """A discrete raceway.

    Parameters
    ----------
    axial_span_mm : float
        lC, axial distance of the two contact points at the raceway centre.
    half_angle_deg : float
        θ; it reaches from −θ to θ.
    centre_angle_deg : float, optional
        Angular position ψ of raceway centre; 0, the default, is the load direction.
    depth_error_um : float, optional
        Machining error of the raceway depth (positive: too deep).
    """

    axial_span_mm: float
    half_angle_deg: float
    centre_angle_deg: float | None = None
    depth_error_um: float | None = None


@dataclass(frozen=True, kw_only=True)
class Operation(Section):
    """Speed and load.

    Parameters
    ----------
    inner_speed_rpm : float
        Speed of the inner ring, counter-clockwise.
    radial_load_n : float
        Fr, downwards.
    gravity_m_s2 : float, optional
        g, downwards.
    """

    inner_speed_rpm: float
    radial_load_n: float
    gravity_m_s2: float | None = None


@dataclass(frozen=True, kw_only=True)
class Contact(Section):
    """Friction, damping and stiffness.

    Parameters
    ----------
    friction_coefficient : float, optional
        μ.
    friction_law : {"smooth", "coulomb", "stribeck"}, optional
        Friction against sliding speed.
    static_friction_coefficient : float, optional
        μs of the Stribeck law, at least μ.
    stribeck_speed_m_s : float, optional
        Sliding speed over which the Stribeck law falls from μs to μ.
    slip_scale_m_s : float, optional
        Sliding speed at the knee of the smooth and Stribeck laws; ``"coulomb"`` does not use it.
    damping : float, optional
        c of the raceway contacts, N·s·m^−1.5.
    ball_restitution : float, optional
        Coefficient of restitution between balls, above 0, at most 1.
    inner_stiffness, outer_stiffness, ball_stiffness : float, optional
        K in N·m^−1.5, in place of what Hertz gives.
    """

    friction_coefficient: float | None = None
    friction_law: Literal["smooth", "coulomb", "stribeck"] | None = None
    static_friction_coefficient: float | None = None
    stribeck_speed_m_s: float | None = None
    slip_scale_m_s: float | None = None
    damping: float | None = None
    ball_restitution: float | None = None
    inner_stiffness: float | None = None
    outer_stiffness: float | None = None
    ball_stiffness: float | None = None


@dataclass(frozen=True, kw_only=True)
class Model(Section):
    """The set of equations.

    Parameters
    ----------
    profile : {"physical", "paper"}, optional
        Consistent mechanics, or the equations as published.
    """

    profile: Literal["physical", "paper"] | None = None


@dataclass(frozen=True, kw_only=True)
class Start(Section):
    """The initial state.

    Parameters
    ----------
    state : {"settled", "rolling"}, optional
        Static equilibrium at speed; or balls in pure rolling, the ring where put.
    ring_x_um, ring_y_um : float, optional
        Centre of the inner ring, only for ``"rolling"``.
    gaps : "uniform" or sequence of float, optional
        Gaps in degrees, from each ball to the next.
    lead_ball_angle_deg : float, optional
        ψ of ball 1.
    """

    state: Literal["settled", "rolling"] | None = None
    ring_x_um: float | None = None
    ring_y_um: float | None = None
    gaps: Literal["uniform"] | Sequence[float] | None = None
    lead_ball_angle_deg: float | None = None


@dataclass(frozen=True, kw_only=True)
class Solver(Section):
    """Integration.

    Parameters
    ----------
    duration_s : float, optional
        Simulated time.
    method : {"symplectic", "abm4", "adaptive"}, optional
        Integration method.
    step_us : "auto" or float, optional
        Step.
    tolerance : float, optional
        Error per step, only for ``"adaptive"``.
    seed : int, optional
        Seed of the random starts and samples of ``run(verify=True)``, ``search`` and
        ``tolerance``; a plain run has nothing random in it.
    """

    duration_s: float | None = None
    method: Literal["symplectic", "abm4", "adaptive"] | None = None
    step_us: Literal["auto"] | float | None = None
    tolerance: float | None = None
    seed: int | None = None


@dataclass(frozen=True, kw_only=True)
class Housing(Section):
    """Support of the outer ring; with it, a run has the ring's vibration.

    Parameters
    ----------
    mass_kg, stiffness_n_m, damping_n_s_m : float
        Housing and outer ring; spring and damper in each direction.
    """

    mass_kg: float
    stiffness_n_m: float
    damping_n_s_m: float


@dataclass(frozen=True, kw_only=True)
class Output(Section):
    """Output of a run.

    Parameters
    ----------
    interval_us : float, optional
        Time between rows.
    """

    interval_us: float | None = None
