"""The sections of a case. Fields are the keys of the case file, in its units; what is left
``None`` takes its default.

Written by ``cargo test -p cageless-io --test all derived_files`` from the declaration of the case file.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

from .section import Section

if TYPE_CHECKING:
    from .rotors import LinearRotor

__all__ = [
    "Bearing",
    "Contact",
    "Housing",
    "Material",
    "Model",
    "Operation",
    "Output",
    "Raceway",
    "Rotor",
    "Section",
    "Solver",
    "Start",
    "Support",
]


@dataclass(frozen=True, kw_only=True)
class Bearing(Section):
    """`[bearing]`: dimensions and masses of rings and balls.

    Parameters
    ----------
    balls : int
        N, number of balls.
    ball_radius_mm : float, optional
        Rw, radius of a ball.
    ball_diameter_mm : float, optional
        Dw = 2 Rw, diameter of a ball, in place of ball_radius_mm.
    inner_groove_bottom_radius_mm : float, optional
        Ri, radius of the inner ring at the bottom of its groove.
    outer_groove_bottom_radius_mm : float, optional
        Ro, radius of the outer ring at the bottom of its groove.
    pitch_diameter_mm : float, optional
        Dpw = Ri + Ro, pitch diameter, in place of Ri and Ro.
    radial_internal_clearance_um : float, optional
        Gr = 2 (Ro - Ri - 2 Rw) of ISO 5753-1, in place of Ri and Ro; below 0: preload by
        interference, half of it at each ball.
    outer_shoulder_radius_mm : float, optional
        Ros, shoulder bore radius of the outer ring; Ro - 0.2 Dw unless given.
    inner_groove_curvature_radius_mm : float, optional
        radius of the inner groove in the meridian plane.
    outer_groove_curvature_radius_mm : float, optional
        Re, radius of the outer groove in the meridian plane.
    inner_conformity : float, optional
        fi, radius of the inner groove over Dw, in place of that radius; 0.52 unless one is
        given.
    outer_conformity : float, optional
        fo = Re/Dw, in place of that radius; 0.52 unless one is given.
    inner_ring_mass_kg : float, optional
        mass of the inner ring and attached rotating parts; that of a steel ring with shoulders
        of 0.2 Dw, 0.3 Dw thick below its groove and 1.6 Dw wide unless given.
    inner_ring_damping_n_s_m : float, optional
        C of Zhao 2022, Eq. (14), viscous damping of inner-ring translation; 2000 unless given,
        0 under a [rotor].
    inner_ring_polar_inertia_kg_m2 : float, optional
        Ji of the inner ring with what turns with it, needed under a [rotor].
    inner_ring_bore_radius_mm : float, optional
        Rb, radius of the bore of the inner ring, needed under a [rotor].
    assembly : {"without-slot", "filling-slot"}, optional
        way of assembly, for the load ratings: "filling-slot" if the balls fill more than 205°
        (N - 1 times ε), else "without-slot".
    ball_radius_deviation_um : sequence of float, optional
        deviation of each ball's radius.
    outer_ring_outer_radius_mm : float, optional
        outer radius of the outer ring.
    outer_ring_width_mm : float, optional
        width of the outer ring.
    """

    balls: int
    ball_radius_mm: float | None = None
    ball_diameter_mm: float | None = None
    inner_groove_bottom_radius_mm: float | None = None
    outer_groove_bottom_radius_mm: float | None = None
    pitch_diameter_mm: float | None = None
    radial_internal_clearance_um: float | None = None
    outer_shoulder_radius_mm: float | None = None
    inner_groove_curvature_radius_mm: float | None = None
    outer_groove_curvature_radius_mm: float | None = None
    inner_conformity: float | None = None
    outer_conformity: float | None = None
    inner_ring_mass_kg: float | None = None
    inner_ring_damping_n_s_m: float | None = None
    inner_ring_polar_inertia_kg_m2: float | None = None
    inner_ring_bore_radius_mm: float | None = None
    assembly: Literal["without-slot", "filling-slot"] | None = None
    ball_radius_deviation_um: Sequence[float] | None = None
    outer_ring_outer_radius_mm: float | None = None
    outer_ring_width_mm: float | None = None


@dataclass(frozen=True, kw_only=True)
class Material(Section):
    """`[material]`: elastic material of rings and balls.

    Parameters
    ----------
    preset : {"100Cr6", "M50", "440C", "X30CrMoN15-1", "Si3N4"}, optional
        typical numbers of a bearing material, in place of the three.
    density_kg_m3 : float, optional
        density; that of the balls decides.
    youngs_modulus_gpa : float, optional
        E, Young's modulus.
    poisson_ratio : float, optional
        ν, Poisson's ratio.
    """

    preset: Literal["100Cr6", "M50", "440C", "X30CrMoN15-1", "Si3N4"] | None = None
    density_kg_m3: float | None = None
    youngs_modulus_gpa: float | None = None
    poisson_ratio: float | None = None


@dataclass(frozen=True, kw_only=True)
class Raceway(Section):
    """`[raceway]`: the discrete raceway.

    Parameters
    ----------
    axial_span_mm : float
        lC, largest axial distance between the two contact points.
    half_angle_deg : float
        θ, half the angle that the raceway takes up.
    centre_angle_deg : float, optional
        angular position of raceway centre.
    depth_error_um : float, optional
        machining error of the depth at the centre, along the normal.
    """

    axial_span_mm: float
    half_angle_deg: float
    centre_angle_deg: float | None = None
    depth_error_um: float | None = None


@dataclass(frozen=True, kw_only=True)
class Operation(Section):
    """`[operation]`: speed and load.

    Parameters
    ----------
    inner_speed_rpm : float or sequence of (float, float), optional
        speed of the inner ring, negative: clockwise, the bearing then seen from its other face;
        or [[time in s, speed], …], linear between; left out with a [rotor], else required.
    radial_load_n : float or sequence of (float, float), optional
        Fr, load on the inner ring, downwards, or [[time in s, load], …], linear between; left
        out with a [rotor], else required.
    gravity_m_s2 : float, optional
        g, downwards.
    """

    inner_speed_rpm: float | Sequence[Sequence[float]] | None = None
    radial_load_n: float | Sequence[Sequence[float]] | None = None
    gravity_m_s2: float | None = None


@dataclass(frozen=True, kw_only=True)
class Contact(Section):
    """`[contact]`: friction, damping and stiffness.

    Parameters
    ----------
    friction_coefficient : float, optional
        μ.
    friction_law : {"smooth", "coulomb", "stribeck", "table"}, optional
        friction against sliding speed.
    static_friction_coefficient : float, optional
        μs of the Stribeck law.
    stribeck_speed_m_s : float, optional
        sliding speed over which the Stribeck law falls from μs to μ.
    friction_table : sequence of (float, float), optional
        measured μ over the sliding speed, of friction_law = "table"; friction_coefficient is
        its last μ, also if it is left out.
    regularisation_speed_m_s : float, optional
        regularisation speed v_s: friction reaches 76 % of μ N at ΔV = v_s; "coulomb" does not
        use it.
    outer_friction_factor : float, optional
        friction at the outer raceway over that of the law, which holds at the inner raceway.
    ball_friction_factor : float, optional
        friction between balls over that of the law.
    damping_n_s_m1_5 : float, optional
        contact damping c of ball-raceway contacts, F = K δ^1.5 + c √δ dδ/dt.
    ball_restitution : float, optional
        coefficient of restitution between balls.
    inner_stiffness_n_m1_5 : float, optional
        K at the inner raceway, in place of Hertz.
    outer_stiffness_n_m1_5 : float, optional
        K at the outer raceway, in place of Hertz.
    ball_stiffness_n_m1_5 : float, optional
        K between balls, in place of Hertz.
    """

    friction_coefficient: float | None = None
    friction_law: Literal["smooth", "coulomb", "stribeck", "table"] | None = None
    static_friction_coefficient: float | None = None
    stribeck_speed_m_s: float | None = None
    friction_table: Sequence[Sequence[float]] | None = None
    regularisation_speed_m_s: float | None = None
    outer_friction_factor: float | None = None
    ball_friction_factor: float | None = None
    damping_n_s_m1_5: float | None = None
    ball_restitution: float | None = None
    inner_stiffness_n_m1_5: float | None = None
    outer_stiffness_n_m1_5: float | None = None
    ball_stiffness_n_m1_5: float | None = None


@dataclass(frozen=True, kw_only=True)
class Model(Section):
    """`[model]`: the set of equations.

    Parameters
    ----------
    formulation : {"physical", "paper"}, optional
        formulation of the equations of motion.
    """

    formulation: Literal["physical", "paper"] | None = None


@dataclass(frozen=True, kw_only=True)
class Start(Section):
    """`[start]`: the initial state.

    Parameters
    ----------
    state : {"settled", "rolling", "at-rest"}, optional
        kind of initial state; "at-rest" with a [rotor] unless given.
    ring_x_um : float, optional
        centre of the inner ring, only for "rolling", there 0 by default.
    ring_y_um : float, optional
        centre of the inner ring, only for "rolling", there 0 by default.
    gaps : {"uniform", "bunched", "random"} | sequence of float, optional
        gaps between neighbouring balls: equal, all balls in one group, random by solver.seed,
        or a list.
    lead_ball_angle_deg : float, optional
        initial position of ball 1.
    """

    state: Literal["settled", "rolling", "at-rest"] | None = None
    ring_x_um: float | None = None
    ring_y_um: float | None = None
    gaps: Literal["uniform", "bunched", "random"] | Sequence[float] | None = None
    lead_ball_angle_deg: float | None = None


@dataclass(frozen=True, kw_only=True)
class Solver(Section):
    """`[solver]`: integration.

    Parameters
    ----------
    method : {"abm4", "verlet", "adaptive"}, optional
        integration method.
    step_us : {"auto"} | float, optional
        step of the integration, from the stiffest contact unless it is a number.
    tolerance : float, optional
        error per step of the adaptive method.
    duration_s : float, optional
        simulated time.
    seed : int, optional
        seed of random starts (run --verify, design --search) and samples (tolerance, drop).
    """

    method: Literal["abm4", "verlet", "adaptive"] | None = None
    step_us: Literal["auto"] | float | None = None
    tolerance: float | None = None
    duration_s: float | None = None
    seed: int | None = None


@dataclass(frozen=True, kw_only=True)
class Housing(Section):
    """`[housing]`: the support of the outer ring.

    Parameters
    ----------
    mass_kg : float
        mass of housing and outer ring.
    stiffness_n_m : float
        stiffness of the support.
    damping_n_s_m : float
        damping of the support.
    """

    mass_kg: float
    stiffness_n_m: float
    damping_n_s_m: float


@dataclass(frozen=True, kw_only=True)
class Rotor(Section):
    """`[rotor]`: a rotor that falls onto the inner ring.

    Parameters
    ----------
    mass_kg : float
        m, share of the rotor mass that this bearing carries.
    polar_inertia_kg_m2 : float
        Ip of the rotor about its axis.
    speed_rpm : float
        rotor speed at the start of the drop (loss of AMB power).
    radial_clearance_um : float
        r0, touch-down clearance: radial clearance between journal and bore of the inner ring.
    eccentricity_um : float, optional
        distance of the mass centre from the centre of the journal.
    eccentricity_phase_deg : float, optional
        direction of the mass centre from the journal centre at the start, from +X.
    friction_coefficient : float
        μr between journal and bore.
    friction_law : {"smooth", "coulomb", "stribeck", "table"}, optional
        friction between journal and bore against sliding speed.
    static_friction_coefficient : float, optional
        μs of the Stribeck law between journal and bore.
    stribeck_speed_m_s : float, optional
        sliding speed over which the Stribeck law falls from μs to μr.
    friction_table : sequence of (float, float), optional
        measured μr over the sliding speed, of friction_law = "table"; friction_coefficient is
        its last μr.
    regularisation_speed_m_s : float, optional
        regularisation speed v_s: friction reaches 76 % of μr N at ΔV = v_s; "coulomb" does not
        use it.
    contact_stiffness_n_mp : float
        K of journal and bore, F = K δ^p (1 + 1.5 α dδ/dt).
    contact_exponent : float, optional
        p, 1 (conformal) to 1.5 (Hertz).
    contact_damping_s_m : float
        α, damping of the contact of journal and bore.
    x_um : float, optional
        mass centre at the start of the drop.
    y_um : float, optional
        mass centre at the start of the drop.
    vx_m_s : float, optional
        velocity of the mass centre at the start of the drop.
    vy_m_s : float, optional
        velocity of the mass centre at the start of the drop.
    drive_torque_n_m : float, optional
        torque on the rotor, drag if against the speed.
    clearance_limit_um : float, optional
        smallest radial clearance of rotor and stator here (magnetic gap, seal); a drop that
        displaces the journal further from the stator centre fails.
    """

    mass_kg: float
    polar_inertia_kg_m2: float
    speed_rpm: float
    radial_clearance_um: float
    eccentricity_um: float | None = None
    eccentricity_phase_deg: float | None = None
    friction_coefficient: float
    friction_law: Literal["smooth", "coulomb", "stribeck", "table"] | None = None
    static_friction_coefficient: float | None = None
    stribeck_speed_m_s: float | None = None
    friction_table: Sequence[Sequence[float]] | None = None
    regularisation_speed_m_s: float | None = None
    contact_stiffness_n_mp: float
    contact_exponent: float | None = None
    contact_damping_s_m: float
    x_um: float | None = None
    y_um: float | None = None
    vx_m_s: float | None = None
    vy_m_s: float | None = None
    drive_torque_n_m: float | None = None
    clearance_limit_um: float | None = None

    @staticmethod
    def from_ross(rotor: Any, nodes: Sequence[int], **options: Any) -> LinearRotor:
        """A rotor on several bearings, from ROSS: :meth:`LinearRotor.from_ross`."""
        from .rotors import LinearRotor

        return LinearRotor.from_ross(rotor, nodes, **options)


@dataclass(frozen=True, kw_only=True)
class Support(Section):
    """`[support]`: support of the outer ring under a falling rotor.

    Parameters
    ----------
    mass_kg : float
        mass of outer ring and housing.
    stiffness_n_m : float
        stiffness of the support.
    damping_n_s_m : float
        damping of the support.
    stop_gap_um : float, optional
        way of the outer ring to a hard stop; none unless given.
    stop_stiffness_n_m : float, optional
        stiffness of the hard stop.
    """

    mass_kg: float
    stiffness_n_m: float
    damping_n_s_m: float
    stop_gap_um: float | None = None
    stop_stiffness_n_m: float | None = None


@dataclass(frozen=True, kw_only=True)
class Output(Section):
    """`[output]`: what a run writes.

    Parameters
    ----------
    interval_us : float, optional
        time between rows of the result.
    """

    interval_us: float | None = None
