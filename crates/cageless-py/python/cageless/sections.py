"""The sections of a case. Fields are the keys of the case file, in its units, with their meaning; what
is left ``None`` takes its default.

Written by ``cargo test -p cageless-io --test all derived_files`` from the declaration of the case file.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Annotated, Any, Literal, TypedDict

from .section import Section

if TYPE_CHECKING:
    from typing_extensions import Required

    from .rotors import LinearRotor

__all__ = ["Bearing", "Contact", "Film", "Fit", "Housing", "Limit", "Lubrication", "Material", "Model", "Operation", "Output", "Raceway", "Rotor", "Row", "Section", "Solver", "Start", "Steady", "Support", "Thermal"]

Keys = Mapping[str, Any]


@dataclass(frozen=True, kw_only=True)
class Bearing(Section):
    """`[bearing]`: dimensions and masses of rings and balls."""

    balls: Annotated[int, "N, number of balls"]
    ball_radius_mm: Annotated[float | None, "Rw, radius of a ball"] = None
    ball_diameter_mm: Annotated[float | None, "Dw = 2 Rw, diameter of a ball, in place of ball_radius_mm"] = None
    inner_groove_bottom_radius_mm: Annotated[float | None, "Ri, radius of the inner ring at the bottom of its groove"] = None
    outer_groove_bottom_radius_mm: Annotated[float | None, "Ro, radius of the outer ring at the bottom of its groove"] = None
    pitch_diameter_mm: Annotated[float | None, "Dpw = Ri + Ro, pitch diameter, in place of Ri and Ro"] = None
    radial_internal_clearance_um: Annotated[float | None, "Gr = 2 (Ro - Ri - 2 Rw) of ISO 5753-1, in place of Ri and Ro; below 0: preload by interference, half of it at each ball"] = None
    contact_angle_deg: Annotated[float | None, "α0, free contact angle of an angular-contact bearing: grooves without clearance are opened about the pitch circle until unloaded balls touch them there; 0, a radial bearing, unless given"] = None
    outer_shoulder_radius_mm: Annotated[float | None, "Ros, shoulder bore radius of the outer ring; Ro - 0.2 Dw unless given"] = None
    inner_shoulder_radius_mm: Annotated[float | None, "Ris, radius of the shoulders of the inner ring; Ri + 0.2 Dw unless given"] = None
    inner_groove_curvature_radius_mm: Annotated[float | None, "radius of the inner groove in the meridian plane"] = None
    outer_groove_curvature_radius_mm: Annotated[float | None, "Re, radius of the outer groove in the meridian plane"] = None
    inner_conformity: Annotated[float | None, "fi, radius of the inner groove over Dw, in place of that radius; 0.52 unless one is given"] = None
    outer_conformity: Annotated[float | None, "fo = Re/Dw, in place of that radius; 0.52 unless one is given"] = None
    inner_ring_mass_kg: Annotated[float | None, "mass of the inner ring and attached rotating parts; that of a steel ring with its shoulders, 0.3 Dw thick below its groove and 1.6 Dw wide for each row unless given"] = None
    inner_ring_damping_n_s_m: Annotated[float | None, "C of Zhao 2022, Eq. (14), viscous damping of inner-ring translation; 2000 unless given, 0 under a [rotor]"] = None
    inner_ring_polar_inertia_kg_m2: Annotated[float | None, "Ji of the inner ring with what turns with it, needed under a [rotor]"] = None
    inner_ring_bore_radius_mm: Annotated[float | None, "Rb, radius of the bore of the inner ring, needed under a [rotor], and d/2 of SKF's rules of friction"] = None
    assembly: Annotated[Literal["without-slot", "filling-slot"] | None, "way of assembly, for the load ratings: \"filling-slot\" if the balls of a bearing without a contact angle fill more than 205° (N - 1 times ε), else \"without-slot\""] = None
    ball_radius_deviation_um: Annotated[Sequence[float] | None, "deviation of each ball's radius, the same in every [[row]]"] = None
    outer_ring_outer_radius_mm: Annotated[float | None, "outer radius of the outer ring, for `export`, and D/2 of SKF's model of friction"] = None
    outer_ring_width_mm: Annotated[float | None, "width of the outer ring"] = None


@dataclass(frozen=True, kw_only=True)
class Material(Section):
    """`[material]`: elastic material of rings and balls."""

    preset: Annotated[Literal["100Cr6", "M50", "440C", "X30CrMoN15-1", "Si3N4"] | None, "typical numbers of a bearing material, in place of the three; its specific heat and thermal expansion as well"] = None
    density_kg_m3: Annotated[float | None, "density; that of the balls decides"] = None
    youngs_modulus_gpa: Annotated[float | None, "E, Young's modulus"] = None
    poisson_ratio: Annotated[float | None, "ν, Poisson's ratio"] = None


@dataclass(frozen=True, kw_only=True)
class Raceway(Section):
    """`[raceway]`: the discrete raceway."""

    axial_span_mm: Annotated[float | None, "lC, largest axial distance between the two contact points; that of a profile unless given, which stretches it"] = None
    half_angle_deg: Annotated[float | None, "θ, half the angle that the raceway takes up; that of a profile unless given, which stretches it"] = None
    centre_angle_deg: Annotated[float | None, "angular position of raceway centre"] = None
    shape: Annotated[Literal["quartic", "ellipse", "shuttle", "steady", "measured", "spline", "slot"] | None, "angle of the flanks along the raceway; \"quartic\": contact path of Zhao 2022, \"ellipse\": α0 √(1 − (ψ/θ)²), \"shuttle\": α0 (1 − (ψ/θ)²), \"steady\": orbital speed that changes at a constant rate, \"measured\": fitted to the profile, \"spline\": a spline through the rows of the profile, \"slot\": of a ball on the edges of a slot, all but the first only in \"physical\""] = None
    profile: Annotated[Sequence[Sequence[float]] | None, "flank angle over ψ from the middle of the raceway up to the ends, where it is 0: of shape = \"measured\", fitted to 5 rows or more of one side or both; of shape = \"spline\", met by 5 to 30 rows of one side from the middle, ψ = 0"] = None
    blend_mm: Annotated[float | None, "length of the blend into the plain raceway before each end, along the bottom of the groove; 0: none; unless given that of `export` on elastic flanks, 0.5 or a fifth of half the raceway, and 0 on rigid ones; more than 0 only in \"physical\""] = None
    depth_um: Annotated[float | None, "how much deeper a ball in the middle sits than on the plain raceway, running out at the ends: in a deep raceway balls leave the inner ring; only in \"physical\""] = None
    edge_radius_mm: Annotated[float | None, "radius of the rounded edges on which balls roll, of shape = \"slot\", which is computed in space"] = None
    slot_depth_mm: Annotated[float | None, "depth of the floor below the bottom of the plain groove, of shape = \"slot\"; for `export` alone, balls do not reach it. At least edge_radius_mm and the depth by which a ball sinks between the edges; edge_radius_mm more unless given"] = None
    depth_error_um: Annotated[float | None, "machining error of the depth at the centre, along the normal"] = None
    contact_angle_deg: Annotated[float | None, "angle by which the section is turned about the centre of the ball, for a bearing of this contact angle; 0 unless given"] = None


@dataclass(frozen=True, kw_only=True)
class Row(Section):
    """`[row]`: a row of balls, where one inner ring has several."""

    axial_position_mm: Annotated[float, "z of the middle of the row"]
    contact_sign: Annotated[float | None, "1: its balls press the outer ring towards +z; -1: towards -z. 1 below -1: back to back; -1 below 1: face to face; equal: tandem"] = None
    preload_um: Annotated[float | None, "preload by displacement of its outer ring against the contact sign; with [fit] that before fits and temperatures"] = None
    preload_n: Annotated[float | None, "preload by a soft spring, in place of preload_um: force on its outer ring against the contact sign, whatever its displacement; the ring slides along the axis, the other rows are held"] = None
    sliding_mass_kg: Annotated[float | None, "with preload_n: mass that slides with its outer ring in motion; that of a ring 0.3 Dw thick behind its groove and 1.6 Dw wide unless given"] = None
    sliding_damping_n_s_m: Annotated[float | None, "with preload_n: viscous damping of its outer ring in the housing, without dry friction; that of a film of oil of 0.03 Pa·s, 5 µm thick, on the seat of such a ring unless given"] = None
    balls: Annotated[int | None, "balls of the row, evenly spaced if fewer than those of [bearing], which it has unless given, and in motion always"] = None


@dataclass(frozen=True, kw_only=True)
class Operation(Section):
    """`[operation]`: speed and load."""

    inner_speed_rpm: Annotated[float | Sequence[Sequence[float]] | None, "speed of the inner ring, not 0, negative: clockwise, the bearing then seen from its other face; or [[time in s, speed], …], linear between; left out with a [rotor], else required"] = None
    radial_load_n: Annotated[float | Sequence[Sequence[float]] | None, "Fr, load on the inner ring, downwards, or [[time in s, load], …], linear between; left out with a [rotor], else required"] = None
    gravity_m_s2: Annotated[float | None, "g, downwards"] = None
    unbalance_g_mm: Annotated[float | None, "m·e, unbalance of what turns with the inner ring, from +X at t = 0; not with a [rotor]"] = None
    axial_load_n: Annotated[float | None, "Fa, load on the inner ring along the axis, +z; 0 unless given"] = None
    moment_x_n_m: Annotated[float | None, "moment on the inner ring about x, which is then free to tilt"] = None
    moment_y_n_m: Annotated[float | None, "moment on the inner ring about y, which is then free to tilt"] = None
    shaft_transverse_inertia_kg_m2: Annotated[float | None, "moment of inertia of inner ring and shaft about a diameter through the middle of the ring, with which moments turn it in a run"] = None
    shaft_polar_inertia_kg_m2: Annotated[float | None, "moment of inertia of inner ring and shaft about their axis, of the gyroscopic moment in a run"] = None
    tilt_x_mrad: Annotated[float | None, "tilt of the inner ring about x that the shaft holds; 0 unless given or a moment is"] = None
    tilt_y_mrad: Annotated[float | None, "tilt of the inner ring about y that the shaft holds; 0 unless given or a moment is"] = None


@dataclass(frozen=True, kw_only=True)
class Contact(Section):
    """`[contact]`: friction, damping and stiffness."""

    friction_law: Annotated[Literal["smooth", "coulomb", "stribeck", "table"] | None, "friction against sliding speed"] = None
    friction_coefficient: Annotated[float | None, "μ"] = None
    static_friction_coefficient: Annotated[float | None, "μs of the Stribeck law"] = None
    stribeck_speed_m_s: Annotated[float | None, "sliding speed over which the Stribeck law falls from μs to μ"] = None
    friction_table: Annotated[Sequence[Sequence[float]] | None, "measured μ over the sliding speed, of friction_law = \"table\"; friction_coefficient is its last μ, also if it is left out"] = None
    regularisation_speed_m_s: Annotated[float | None, "regularisation speed v_s: friction reaches 76 % of μ N at ΔV = v_s; a thousandth of the speed of rolling balls unless given, at most 0.02, and 0.02 in a drop; \"coulomb\" does not use it"] = None
    regularisation: Annotated[Literal["speed", "kalker"] | None, "where v_s at the raceways comes from; \"speed\": regularisation_speed_m_s; \"kalker\": creep of each rolling contact after Kalker, μ N V/(G ab C11), regularisation_speed_m_s between balls; not with \"coulomb\" or in \"paper\""] = None
    outer_friction_factor: Annotated[float | None, "friction at the outer raceway over that of the law, which holds at the inner raceway"] = None
    ball_friction_factor: Annotated[float | None, "friction between balls over that of the law"] = None
    friction_strips: Annotated[int | None, "strips across the groove over which friction acts in space: with 1 there is no differential sliding, and the lag may be 8 % off; with 3 it is within 3.5 % of that of many"] = None
    damping_n_s_m1_5: Annotated[float | None, "contact damping c of ball-raceway contacts, F = K δ^1.5 + c √δ dδ/dt"] = None
    ball_restitution: Annotated[float | None, "coefficient of restitution between balls"] = None
    inner_stiffness_n_m1_5: Annotated[float | None, "K at the inner raceway, in place of Hertz"] = None
    outer_stiffness_n_m1_5: Annotated[float | None, "K at the outer raceway, in place of Hertz"] = None
    ball_stiffness_n_m1_5: Annotated[float | None, "K between balls, in place of Hertz"] = None


@dataclass(frozen=True, kw_only=True)
class Model(Section):
    """`[model]`: the set of equations."""

    formulation: Annotated[Literal["physical", "paper"] | None, "formulation of the equations of motion"] = None
    motion: Annotated[Literal["auto", "space"] | None, "\"auto\": in the plane, or in space where axial load, tilt, moments or contact angles need it; \"space\": in space in any case"] = None
    flanks: Annotated[Literal["rigid", "elastic"] | None, "flanks of the discrete raceways in the plane; \"elastic\": contact angle under load, sliding along the flanks and spin on them; \"rigid\": as published, also unless given in \"paper\" and with friction_law = \"coulomb\", which have no others"] = None


@dataclass(frozen=True, kw_only=True)
class Start(Section):
    """`[start]`: the initial state."""

    state: Annotated[Literal["settled", "rolling", "at-rest"] | None, "kind of initial state; \"at-rest\" with a [rotor] unless given"] = None
    ring_x_um: Annotated[float | None, "centre of the inner ring, only for \"rolling\", there 0 by default"] = None
    ring_y_um: Annotated[float | None, "centre of the inner ring, only for \"rolling\", there 0 by default"] = None
    gaps: Annotated[Literal["uniform", "bunched", "random"] | Sequence[float] | None, "gaps between neighbouring balls: equal, all balls in one group, random by solver.seed, or a list; the same in every [[row]]"] = None
    lead_ball_angle_deg: Annotated[float | None, "initial position of ball 1"] = None


@dataclass(frozen=True, kw_only=True)
class Solver(Section):
    """`[solver]`: integration."""

    method: Annotated[Literal["abm4", "verlet", "adaptive"] | None, "integration method"] = None
    step_us: Annotated[Literal["auto"] | float | None, "step of the integration, from the stiffest contact unless it is a number"] = None
    tolerance: Annotated[float | None, "error per step of the adaptive method"] = None
    duration_s: Annotated[float | None, "simulated time"] = None
    transient_s: Annotated[float | None, "time at the start that results leave out; two orbits of the balls, at most half, unless given"] = None
    seed: Annotated[int | None, "seed of random starts (run --verify, design --search) and samples (tolerance, drop)"] = None


@dataclass(frozen=True, kw_only=True)
class Housing(Section):
    """`[housing]`: the support of the outer ring."""

    mass_kg: Annotated[float, "mass of housing and outer ring"]
    stiffness_n_m: Annotated[float, "stiffness of the support"]
    damping_n_s_m: Annotated[float, "damping of the support"]


@dataclass(frozen=True, kw_only=True)
class Rotor(Section):
    """`[rotor]`: a rotor that falls onto the inner ring."""

    mass_kg: Annotated[float, "m, share of the rotor mass that this bearing carries"]
    polar_inertia_kg_m2: Annotated[float, "Ip of the rotor about its axis"]
    speed_rpm: Annotated[float, "rotor speed at the start of the drop (loss of AMB power)"]
    radial_clearance_um: Annotated[float, "r0, touch-down clearance: radial clearance between journal and bore of the inner ring"]
    eccentricity_um: Annotated[float | None, "distance of the mass centre from the centre of the journal"] = None
    eccentricity_phase_deg: Annotated[float | None, "direction of the mass centre from the journal centre at the start, from +X"] = None
    friction_law: Annotated[Literal["smooth", "coulomb", "stribeck", "table"] | None, "friction between journal and bore against sliding speed"] = None
    friction_coefficient: Annotated[float, "μr between journal and bore"]
    static_friction_coefficient: Annotated[float | None, "μs of the Stribeck law between journal and bore"] = None
    stribeck_speed_m_s: Annotated[float | None, "sliding speed over which the Stribeck law falls from μs to μr"] = None
    friction_table: Annotated[Sequence[Sequence[float]] | None, "measured μr over the sliding speed, of friction_law = \"table\"; friction_coefficient is its last μr"] = None
    regularisation_speed_m_s: Annotated[float | None, "regularisation speed v_s: friction reaches 76 % of μr N at ΔV = v_s; \"coulomb\" does not use it"] = None
    shaft: Annotated[Literal["horizontal", "vertical"] | None, "\"horizontal\", or \"vertical\" with weights along -z, in space"] = None
    axial_clearance_um: Annotated[float | None, "axial touch-down clearance of either shoulder of the rotor to the face of the inner ring, with the rotor in the middle; the drop is then in space"] = None
    shoulder_radius_mm: Annotated[float | None, "mean radius of shoulder and face; halfway between bore and raceway unless given"] = None
    axial_load_n: Annotated[float | None, "thrust on the rotor along +z"] = None
    z_um: Annotated[float | None, "place of the rotor along the axis at the start of the drop, from the middle between its shoulders"] = None
    vz_m_s: Annotated[float | None, "velocity of the rotor along +z at the start of the drop"] = None
    contact_stiffness_n_mp: Annotated[float, "K of journal and bore, F = K δ^p (1 + 1.5 α dδ/dt), and of shoulder and face"]
    contact_exponent: Annotated[float | None, "p, 1 (conformal) to 1.5 (Hertz)"] = None
    contact_damping_s_m: Annotated[float, "α, damping of the contact of journal and bore"]
    x_um: Annotated[float | None, "mass centre at the start of the drop"] = None
    y_um: Annotated[float | None, "mass centre at the start of the drop"] = None
    vx_m_s: Annotated[float | None, "velocity of the mass centre at the start of the drop"] = None
    vy_m_s: Annotated[float | None, "velocity of the mass centre at the start of the drop"] = None
    drive_torque_n_m: Annotated[float | None, "torque on the rotor, drag if against the speed"] = None
    clearance_limit_um: Annotated[float | None, "smallest radial clearance of rotor and stator here (magnetic gap, seal); a drop that displaces the journal further from the stator centre fails"] = None

    @staticmethod
    def from_ross(rotor: Any, nodes: Sequence[int], **options: Any) -> LinearRotor:
        """A rotor on several bearings, from ROSS: :meth:`LinearRotor.from_ross`."""
        from .rotors import LinearRotor

        return LinearRotor.from_ross(rotor, nodes, **options)


@dataclass(frozen=True, kw_only=True)
class Support(Section):
    """`[support]`: support of the outer ring under a falling rotor."""

    mass_kg: Annotated[float, "mass of outer ring and housing"]
    stiffness_n_m: Annotated[float, "stiffness of the support"]
    damping_n_s_m: Annotated[float, "damping of the support"]
    stop_gap_um: Annotated[float | None, "way of the outer ring to a hard stop; none unless given"] = None
    stop_stiffness_n_m: Annotated[float | None, "stiffness of the hard stop"] = None


@dataclass(frozen=True, kw_only=True)
class Thermal(Section):
    """`[thermal]`: what the heat of drops warms."""

    outer_ring_mass_kg: Annotated[float | None, "mass of the outer ring; that of a ring 0.3 Dw thick behind its groove and 1.6 Dw wide unless given"] = None
    ring_specific_heat_j_kg_k: Annotated[float | None, "specific heat of the rings; 460, bearing steel, unless given; needed of rings of another material"] = None
    ball_specific_heat_j_kg_k: Annotated[float | None, "specific heat of the balls; 460, bearing steel, unless given; needed of balls of another material"] = None
    pause_s: Annotated[float | None, "time from the standstill of the rotor to the next drop"] = None
    cooling_time_s: Annotated[float | None, "time constant with which the bearing cools in the pause towards its temperature before the first drop; without one it keeps all heat"] = None


@dataclass(frozen=True, kw_only=True)
class Limit(Section):
    """`[limit]`: a limit on a result, with whose it is."""

    result: Annotated[str, "name of a number among the results of static, run, design, compare or drop: l10_h, operating_clearance_um, rotor_force_max_n, …"]
    value: Annotated[float, "the most that it may be in magnitude, of a temperature with its sign, in the unit of the result; the least where more is better"]
    side: Annotated[Literal["at-most", "at-least"] | None, "which side of the value is allowed, with its sign; by the result unless given"] = None
    source: Annotated[str, "whose limit it is: a specification, a maker"]


@dataclass(frozen=True, kw_only=True)
class Fit(Section):
    """`[fit]`: fits and temperatures, from which the clearance in operation follows."""

    bore_diameter_mm: Annotated[float | None, "d, bore diameter of the inner ring; twice bearing.inner_ring_bore_radius_mm unless given; needed with a fit on the shaft"] = None
    outside_diameter_mm: Annotated[float | None, "D, outside diameter of the outer ring; twice bearing.outer_ring_outer_radius_mm unless given; needed with a fit in the housing"] = None
    shaft: Annotated[str | None, "tolerance class of the shaft by ISO 286, \"k5\" say, in place of shaft_interference_um: d, e, f, g, h, js, k, m, n, p or r with grade 4 to 9, j5 to j7; the middles of the tolerances of shaft and bore make the fit, their limits the range of the clearance"] = None
    housing: Annotated[str | None, "tolerance class of the bore of the housing by ISO 286, \"H7\" say, in place of housing_interference_um: D, E, F, G, H, JS, M, N, P or R with grade 4 to 9, J6 to J8, K4 to K8"] = None
    tolerance_class: Annotated[Literal["normal", "6", "5"] | None, "tolerance class of the bearing by ISO 492, for its bore and outside diameter; \"normal\" unless given; with shaft or housing"] = None
    smoothing_um: Annotated[float | None, "interference lost by smoothing of the surfaces, with shaft or housing; 1.75 unless given, the middle of NTN's 1.0 to 2.5 of ground shafts; turned ones 5 to 7"] = None
    clearance_tolerance_um: Annotated[float | None, "tolerance of Gr before mounting, ±: half the width of its group of ISO 5753-1"] = None
    shaft_interference_um: Annotated[float | None, "effective interference of shaft and bore on the diameter, smoothing of the surfaces deducted; below 0: a gap; 0 unless given"] = None
    housing_interference_um: Annotated[float | None, "effective interference of outer ring and housing on the diameter; below 0: a gap; 0 unless given"] = None
    shaft_bore_diameter_mm: Annotated[float | None, "bore of a hollow shaft; 0: a solid one"] = None
    housing_outside_diameter_mm: Annotated[float | None, "outside diameter of the housing; a thick one unless given"] = None
    shaft_youngs_modulus_gpa: Annotated[float | None, "modulus of the shaft; that of the rings unless given"] = None
    shaft_poisson_ratio: Annotated[float | None, "Poisson's ratio of the shaft; that of the rings unless given"] = None
    housing_youngs_modulus_gpa: Annotated[float | None, "modulus of the housing; that of the rings unless given"] = None
    housing_poisson_ratio: Annotated[float | None, "Poisson's ratio of the housing; that of the rings unless given"] = None
    inner_ring_temperature_c: Annotated[float | None, "temperature of the inner ring; 20 °C unless given"] = None
    outer_ring_temperature_c: Annotated[float | None, "temperature of the outer ring; 20 °C unless given"] = None
    ball_temperature_c: Annotated[float | None, "temperature of the balls; the mean of both rings unless given"] = None
    shaft_temperature_c: Annotated[float | None, "temperature of the shaft; that of the inner ring unless given"] = None
    housing_temperature_c: Annotated[float | None, "temperature of the housing; that of the outer ring unless given"] = None
    ring_expansion_per_k: Annotated[float | None, "coefficient of thermal expansion of the rings; 12.5e-6, bearing steel, unless given; needed of warm rings of another material"] = None
    ball_expansion_per_k: Annotated[float | None, "coefficient of thermal expansion of the balls; 12.5e-6, bearing steel, unless given; needed of warm balls of another material"] = None
    shaft_expansion_per_k: Annotated[float | None, "coefficient of thermal expansion of the shaft; that of the rings unless given"] = None
    housing_expansion_per_k: Annotated[float | None, "coefficient of thermal expansion of the housing; that of the rings unless given"] = None


@dataclass(frozen=True, kw_only=True)
class Lubrication(Section):
    """`[lubrication]`: the lubricant, for modified life and minimum load of `static`."""

    viscosity_mm2_s: Annotated[float | None, "ν, kinematic viscosity at the temperature of operation, of a grease that of its base oil; required, but with [film], whose oil gives it"] = None
    contamination_factor: Annotated[float, "eC of ISO 281: 1 extreme cleanliness, 0.8 to 0.6 high, 0.6 to 0.5 normal, 0.5 to 0.3 slight and 0.3 to 0.1 typical contamination, 0.1 to 0 severe, below a pitch diameter of 100 mm"]
    fatigue_load_limit_n: Annotated[float | None, "Cu (SKF: Pu) of the catalogue; from a contact pressure of 1500 MPa unless given"] = None
    minimum_load_factor: Annotated[float | None, "kr of SKF's catalogue, for the minimum load; none unless given"] = None
    skf_series: Annotated[Literal["filling-slot", "42", "60", "62", "63", "64", "160", "618", "619"] | None, "series of the bearing for SKF's friction model: \"62\" for 62 and 622 and so on; not computed unless given; SKF has no constants for a full complement of balls"] = None
    lubricant: Annotated[Literal["oil", "grease"] | None, "for SKF's friction model: \"oil\", a low bath or a jet, or \"grease\", or oil with air"] = None
    film_friction_coefficient: Annotated[float | None, "μEHL of SKF's friction model, in a full film: 0.05 mineral oil, 0.04 synthetic oil, 0.1 transmission fluid"] = None


@dataclass(frozen=True, kw_only=True)
class Film(Section):
    """`[film]`: oil film of the rolling contacts, which resists rolling and spaces balls."""

    supply: Annotated[Literal["flooded", "two-drops"] | float | None, "share of the rolling force of a flooded contact, for which there is no safe assumption: \"flooded\" is 1, an oil bath or jet at low speed; \"two-drops\" is 0.65, balls measured with two drops of oil; 0.1 is nearly dry or greased, of which no measurement is known; give 0 or a number from 0.001 to 1, and try the others; needed unless inlet_film_um is given"] = None
    inlet_film_um: Annotated[float | None, "thickness of the oil on the track before a contact, in place of supply, which follows from S, that thickness over the least flooded film of all contacts at the speed and load of the case; S from 2 on is computed, below is said"] = None
    oil: Annotated[Literal["iso-vg-10", "iso-vg-22", "iso-vg-32", "iso-vg-68", "fva-3", "mil-l-23699"] | None, "oil by name, with temperature_c; or the viscosities"] = None
    viscosity_40_mpa_s: Annotated[float | None, "dynamic viscosity at 40 °C, with viscosity_100_mpa_s and temperature_c"] = None
    viscosity_100_mpa_s: Annotated[float | None, "dynamic viscosity at 100 °C"] = None
    viscosity_mpa_s: Annotated[float | None, "dynamic viscosity at the temperature of the inlet, with viscosity_temperature_1_k"] = None
    viscosity_temperature_1_k: Annotated[float | None, "fall of the logarithm of the viscosity with the temperature, 0.02 to 0.06 of mineral oils, for the heat of the inlet; 0: none"] = None
    temperature_c: Annotated[float | None, "temperature of the oil at the inlet of the contacts, that of the rings; needed unless viscosity_mpa_s is given"] = None
    pressure_viscosity_1_pa: Annotated[float | None, "pressure-viscosity coefficient α, for the thickness of the film alone; that of the oil unless given, of mineral oil with viscosities"] = None
    thermal_conductivity_w_m_k: Annotated[float | None, "thermal conductivity of the oil; that of the oil unless given, 0.14 with viscosities"] = None
    density_kg_m3: Annotated[float | None, "density of the oil, for the kinematic viscosity of [lubrication]; that of the oil unless given, 860 with viscosities"] = None
    roughness_um: Annotated[float | None, "Rq, composite roughness of ball and raceway, for Λ"] = None
    hysteresis: Annotated[Literal["no", "yes"] | None, "whether the hysteresis of the steel resists rolling as well; its heat is part of rolling_resistance"] = None
    traction: Annotated[Literal["law", "film"] | None, "friction at the raceways; \"law\": that of [contact]; \"film\": the film is sheared, and asperities have the smooth law of [contact] for the share of the load that they carry, for which contact.friction_coefficient = 0.11 is measured"] = None
    traction_coefficient: Annotated[float | None, "limit of the friction of a sheared film over its load, with traction = \"film\"; 0.03 to 0.05 of mineral oils, 0.05 unless given"] = None


@dataclass(frozen=True, kw_only=True)
class Output(Section):
    """`[output]`: what a run writes."""

    interval_us: Annotated[float | None, "time between rows of the result"] = None


@dataclass(frozen=True, kw_only=True)
class Steady(Section):
    """`[steady]`: steady operation with real balls, for `compare`."""

    grade: Annotated[int | None, "grade of the balls by ISO 3290-1: radii evenly within a lot, unless bearing.ball_radius_deviation_um gives them"] = None
    start: Annotated[Literal["queue", "random"] | None, "start: all balls in the queue in which a conventional ring ends, or random gaps"] = None
    transient_orbits: Annotated[float | None, "orbits of the balls that are left out"] = None
    measured_orbits: Annotated[float | None, "orbits of the balls that are measured"] = None
    weight_contacts: Annotated[float | None, "weight of fewer contacts in the benefit of a remedy"] = None
    weight_spacing: Annotated[float | None, "weight of even spacing in the benefit of a remedy"] = None
    weight_force: Annotated[float | None, "weight of a steady force on the outer ring in the benefit of a remedy"] = None


class OfCase:
    """Sections of a case, None where it has none."""

    bearing: Bearing
    material: Material
    ball_material: Material | None
    ring_material: Material | None
    operation: Operation
    contact: Contact
    model: Model
    start: Start
    solver: Solver
    housing: Housing | None
    rotor: Rotor | None
    support: Support | None
    thermal: Thermal | None
    fit: Fit | None
    lubrication: Lubrication | None
    film: Film | None
    output: Output
    steady: Steady | None


class Arguments(TypedDict, total=False):
    """Keywords of a case: its sections, or mappings of their keys."""

    schema: int
    title: str
    seed: int
    bearing: Required[Bearing | Keys]
    material: Material | Keys | None
    ball_material: Material | Keys | None
    ring_material: Material | Keys | None
    raceway: Raceway | Keys | Sequence[Raceway | Keys] | None
    row: Row | Keys | Sequence[Row | Keys] | None
    operation: Required[Operation | Keys]
    contact: Contact | Keys | None
    model: Model | Keys | None
    start: Start | Keys | None
    solver: Solver | Keys | None
    housing: Housing | Keys | None
    rotor: Rotor | Keys | None
    support: Support | Keys | None
    thermal: Thermal | Keys | None
    limit: Limit | Keys | Sequence[Limit | Keys] | None
    fit: Fit | Keys | None
    lubrication: Lubrication | Keys | None
    film: Film | Keys | None
    output: Output | Keys | None
    steady: Steady | Keys | None
    search: Keys | None
