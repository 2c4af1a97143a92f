"""Attributes of results with their types: scalar results with label and unit, NaN where there is no
number; figures.

Written by ``cargo test -p cageless-report --test all attributes`` from the table of quantities.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np
import numpy.typing as npt

if TYPE_CHECKING:
    import plotly.graph_objects as go

Floats = npt.NDArray[np.float64]


class RunAttributes:
    """Attributes of a result of this kind."""

    verdict: str  # verdict
    passes: bool | None  # passes
    headline: str  # verdict with its reason
    criterion: str | None  # criterion that decides
    margin: float  # margin to the nearest limit
    friction_torque_n_m: float  # friction torque in the model, rolling in oil included, N m
    friction_torque_skf_n_m: float  # friction torque with lubricant and cage, SKF ½ μ P d, N m
    power_loss_w: float  # power loss in the model, damping included, W
    power_loss_inner_friction_w: float  # friction at the inner raceway, W
    power_loss_outer_friction_w: float  # friction at the outer raceway, W
    power_loss_ball_friction_w: float  # friction between balls, W
    rolling_resistance_power_w: float  # rolling resistance at both raceways, W
    power_loss_damping_w: float  # damping of the contacts (an assumed constant), W
    power_loss_inner_ring_damping_w: float  # drag on the inner ring, W
    power_loss_rotor_friction_w: float  # friction between rotor and inner ring, W
    power_loss_rotor_damping_w: float  # damping between rotor and inner ring, W
    power_loss_support_damping_w: float  # damping of the support, W
    power_loss_stored_w: float  # stored, less work of loads, W
    regularisation_speed_mean_m_s: float  # regularisation speed of the friction, mean, m/s
    rolling_resistance_torque_n_m: float  # torque of rolling resistance, N m
    half_turn_lag_deg: float  # lag of the balls over the half orbit away from the load, deg
    half_turn_deficit_fraction: float  # share of its speed that a ball loses over that half orbit
    inner_pressure_max_mpa: float  # peak contact pressure, inner raceway, MPa
    outer_pressure_max_mpa: float  # peak contact pressure, outer raceway, MPa
    ball_pressure_max_mpa: float  # peak contact pressure, ball on ball, MPa
    inner_force_max_n: float  # largest force at the inner raceway, N
    outer_force_max_n: float  # largest force at the outer raceway, N
    ball_force_max_n: float  # largest force between balls, N
    inner_pressure_velocity_max_mpa_m_s: float  # pressure × sliding speed, inner raceway, MPa m/s
    outer_pressure_velocity_max_mpa_m_s: float  # pressure × sliding speed, outer raceway, MPa m/s
    ball_pressure_velocity_max_mpa_m_s: float  # pressure × sliding speed, ball on ball, MPa m/s
    ring_x_mean_um: float  # mean displacement of the inner ring, x, um
    ring_y_mean_um: float  # mean displacement of the inner ring, y, um
    ring_z_mean_um: float  # mean displacement of the inner ring, z, um
    tilt_x_mean_mrad: float  # mean tilt of the inner ring about X, mrad
    tilt_y_mean_mrad: float  # mean tilt of the inner ring about Y, mrad
    inner_contact_angle_mean_deg: float  # contact angle at the inner raceway, mean, deg
    outer_contact_angle_mean_deg: float  # contact angle at the outer raceway, mean, deg
    inner_ellipse_edge_max_deg: float  # edge of contact ellipses, inner raceway, largest angle, deg
    outer_ellipse_edge_max_deg: float  # edge of contact ellipses, outer raceway, largest angle, deg
    row_preload_start_um: Floats  # preload of the rows by displacement, at the start, um
    row_preload_mean_um: Floats  # preload of the rows by displacement, mean, um
    row_axial_force_mean_n: Floats  # axial force of the rows, mean, N
    collisions: int | None  # collisions between balls
    collisions_above_0_1_m_s: int | None  # collisions above 0.1 m/s
    collisions_above_0_5_m_s: int | None  # collisions above 0.5 m/s
    collisions_above_1_m_s: int | None  # collisions above 1 m/s
    gap_min_deg: float  # smallest gap, deg
    gap_max_deg: float  # largest gap, deg
    gap_deviation_deg: float  # standard deviation of the gaps, deg
    gap_deviation_change_deg: float  # change of that from the first to the second half of the run, deg
    outer_ring_force_deviation_n: float  # standard deviation of the force on the outer ring, N
    sliding_max_m_s: float  # largest sliding speed under load, m/s
    orbit_speed_rpm: float  # orbital speed of the balls, mean, rpm
    rotation_speed_rpm: float  # rotational speed of the balls, mean, rpm
    ftf_hz: float  # FTF in pure rolling, Hz
    bpfo_hz: float  # BPFO in pure rolling, Hz
    bpfi_hz: float  # BPFI in pure rolling, Hz
    bsf_hz: float  # BSF in pure rolling, Hz
    ftf_observed_hz: float  # FTF in the motion (orbits of the balls), Hz
    bpfo_observed_hz: float  # BPFO in the motion, Hz
    bpfi_observed_hz: float  # BPFI in the motion, Hz
    bsf_observed_hz: float  # BSF in the motion, Hz
    passages: int | None  # passages through a discrete raceway
    passage_duration_mean_ms: float  # time of a passage, mean, ms
    lag_per_pass_deg: float  # lag of a ball per pass of a discrete raceway, mean, deg
    passage_collisions_mean: float  # contacts per passage, mean
    double_collision_fraction: float  # passages with a double collision
    passage_sliding_mean_m_s: float  # largest sliding speed in a passage, mean, m/s
    passage_unloaded_fraction: float  # time in raceways without force at the inner raceway, share
    passage_gap_min_mean_deg: float  # smallest gap ahead in a passage, mean, deg
    settled_after_s: float  # end of the transient, s
    averaged_orbits: int | None  # orbits of mean powers and speeds
    energy_residual_relative: float  # energy balance error (relative)
    simulated_s: float  # simulated, s
    steps: int | None  # steps
    rhs_evaluations: int | None  # force evaluations
    wall_s: float  # time of the computation, s
    plot_gap_map: Callable[..., go.Figure]  # smallest gap of each pair of neighbours over time, as colours
    plot_gaps: Callable[..., go.Figure]  # gaps between neighbours over time
    plot_collisions: Callable[..., go.Figure]  # contacts between balls: where, when, how hard
    plot_load_profile: Callable[..., go.Figure]  # loads and pressures of all balls around the bearing, of the last orbits
    plot_ring_orbit: Callable[..., go.Figure]  # orbit of the inner ring's centre
    plot_energy: Callable[..., go.Figure]  # energy balance of the whole run
    plot_orbit_speed: Callable[..., go.Figure]  # orbital speed of the balls over time
    plot_sliding: Callable[..., go.Figure]  # sliding speeds at the raceways
    plot_loads: Callable[..., go.Figure]  # forces on a ball at the raceways over ψ
    plot_contact_angles: Callable[..., go.Figure]  # contacts of a ball on the unrolled grooves, of a run in space
    plot_groove: Callable[..., go.Figure]  # a ball with its contact track on the outer groove in three dimensions, of a run in space
    plot_phase: Callable[..., go.Figure]  # phase portrait of a ball
    plot_vibration: Callable[..., go.Figure]  # vibration of the outer ring on its housing, spectrum of the whole run


class DropAttributes:
    """Attributes of a result of this kind."""

    verdict: str  # verdict
    passes: bool | None  # passes
    headline: str  # verdict with its reason
    end_state_text: str  # state at the end in words
    end_state: str  # state at the end
    first_contact_ms: float  # first contact, ms
    impacts: int | None  # impacts of the rotor
    contact_fraction: float  # time in contact after the first, share
    rotor_force_max_n: float  # largest force on the rotor, N
    rotor_force_max_over_weight: float  # largest force on the rotor / its weight
    shoulder_force_max_n: float  # largest axial force of a shoulder, N
    housing_force_max_n: float  # largest force on the housing, N
    housing_force_max_over_weight: float  # largest force on the housing / rotor's weight
    rotor_displacement_max_um: float  # largest displacement of the journal from the stator centre, um
    rotor_axial_displacement_max_um: float  # largest displacement of the rotor along the axis, um
    clearance_margin_um: float  # margin of the journal to its clearance, um
    housing_displacement_max_um: float  # largest displacement of the outer ring, um
    rotor_sliding_max_m_s: float  # largest sliding speed of the rotor, m/s
    spin_up_ms: float  # spin-up of the inner ring, ms
    ring_speed_rpm: float  # inner ring at the end, rpm
    rotor_speed_rpm: float  # rotor at the end, rpm
    backward_whirl_max_hz: float  # largest backward speed of the journal (whirl or swing), Hz
    backward_whirl_hz: float  # backward whirl round the bore, largest, Hz
    backward_whirl_end_hz: float  # backward whirl at the end, Hz
    inner_pressure_max_mpa: float  # peak contact pressure, inner raceway, MPa
    outer_pressure_max_mpa: float  # peak contact pressure, outer raceway, MPa
    ball_pressure_max_mpa: float  # peak contact pressure, ball on ball, MPa
    inner_ellipse_edge_max_deg: float  # edge of contact ellipses, inner raceway, largest angle, deg
    outer_ellipse_edge_max_deg: float  # edge of contact ellipses, outer raceway, largest angle, deg
    collisions: int | None  # collisions between balls
    collisions_above_0_1_m_s: int | None  # collisions above 0.1 m/s
    collisions_above_0_5_m_s: int | None  # collisions above 0.5 m/s
    collisions_above_1_m_s: int | None  # collisions above 1 m/s
    end_collision_rate_hz: float  # collisions between balls per second, at the end, Hz
    end_collision_rate_above_0_1_m_s_hz: float  # collisions above 0.1 m/s per second, at the end, Hz
    end_collision_rate_above_0_5_m_s_hz: float  # collisions above 0.5 m/s per second, at the end, Hz
    end_collision_rate_above_1_m_s_hz: float  # collisions above 1 m/s per second, at the end, Hz
    ball_force_max_n: float  # largest force between balls, N
    ball_sliding_max_m_s: float  # largest sliding speed of a ball, m/s
    dissipated_j: float  # heat of all interfaces, J
    ball_friction_total_j: float  # heat of friction at the balls, J
    rotor_friction_j: float  # friction between rotor and inner ring, J
    rotor_damping_j: float  # damping between rotor and inner ring, J
    inner_friction_j: float  # friction at the inner raceway, J
    outer_friction_j: float  # friction at the outer raceway, J
    ball_friction_j: float  # friction between balls, J
    contact_damping_j: float  # damping of the balls' contacts, J
    support_damping_j: float  # damping of the support, J
    braking_torque_n_m: float  # torque of the bearing that brakes the rotor, at the end, N m
    braking_torque_change_fraction: float  # change of the torque that brakes the rotor
    end_power_w: float  # heat of all interfaces per second, at the end, W
    inner_ring_power_w: float  # into the inner ring, W
    ball_power_w: float  # into the balls, W
    outer_ring_power_w: float  # into the outer ring, W
    inner_ring_temperature_c: float  # temperature of the inner ring at the end, C
    ball_temperature_c: float  # temperature of the balls at the end, C
    outer_ring_temperature_c: float  # temperature of the outer ring at the end, C
    inner_force_max_of_ball_n: Floats  # largest force of each ball at the inner raceway, N
    outer_force_max_of_ball_n: Floats  # largest force of each ball at the outer raceway, N
    energy_residual_relative: float  # energy balance error (relative)
    simulated_s: float  # simulated, s
    plot_orbit: Callable[..., go.Figure]  # path of the journal in the bore of the inner ring
    plot_displacement: Callable[..., go.Figure]  # path of the journal from the centre of the stator, with its clearance
    plot_spin_up: Callable[..., go.Figure]  # speeds of rotor and inner ring over time
    plot_forces: Callable[..., go.Figure]  # forces of the rotor on the inner ring and of the balls on the outer ring over time
    plot_whirl: Callable[..., go.Figure]  # whirl frequency and contact over time
    plot_along_axis: Callable[..., go.Figure]  # motion of rotor and inner ring along the axis and force of a shoulder over time, of a drop in space
    plot_loads: Callable[..., go.Figure]  # largest forces of each ball
    plot_heat: Callable[..., go.Figure]  # heat of each interface
    plot_temperatures: Callable[..., go.Figure]  # temperatures of rings and balls drop after drop
    plot_end_states: Callable[..., go.Figure]  # states at the end of scattered drops over friction and support damping


class StaticAttributes:
    """Attributes of a result of this kind."""

    ring_x_um: float  # displacement of the inner ring, x, um
    ring_y_um: float  # displacement of the inner ring, y, um
    stiffness_xx_n_m: float  # stiffness of the bearing, kxx, N/m
    stiffness_yy_n_m: float  # stiffness of the bearing, kyy, N/m
    stiffness_xy_n_m: float  # stiffness of the bearing, kxy = kyx, N/m
    inner_pressure_max_mpa: float  # peak contact pressure, inner raceway, MPa
    outer_pressure_max_mpa: float  # peak contact pressure, outer raceway, MPa
    inner_force_max_n: float  # largest force at the inner raceway, N
    outer_force_max_n: float  # largest force at the outer raceway, N
    loaded_balls: int | None  # balls under load
    equivalent_load_n: float  # equivalent dynamic radial load P (ISO 281), N
    equivalent_static_load_n: float  # equivalent static radial load P0 (ISO 76), N
    static_safety_factor: float  # static safety factor s0 = C0r/P0 (ISO 76)
    pressure_safety: float  # load factor until 4200 MPa
    assembly: str  # way of assembly
    rating_factor: float  # rating factor bm of ISO 281 for it
    basic_dynamic_rating_n: float  # basic dynamic radial load rating Cr (ISO 281), N
    basic_static_rating_n: float  # basic static radial load rating C0r (ISO 76), N
    l10_mrev: float  # basic rating life L10 (ISO 281), Mrev
    l10_h: float  # basic rating life L10 at the speed of the case, h
    l10r_mrev: float  # basic reference rating life L10r (ISO 16281), Mrev
    l10r_h: float  # basic reference rating life L10r at the speed of the case, h
    l10r_at_speed_mrev: float  # L10r with weight and centrifugal force, Mrev
    l10r_at_speed_h: float  # L10r with weight and centrifugal force, at the speed of the case, h
    ftf_hz: float  # FTF in pure rolling, Hz
    bpfo_hz: float  # BPFO in pure rolling, Hz
    bpfi_hz: float  # BPFI in pure rolling, Hz
    bsf_hz: float  # BSF in pure rolling, Hz
    raceway_ftf_hz: float  # FTF in pure rolling through the discrete raceways, Hz
    regularisation_speed_mean_m_s: float  # regularisation speed of the friction, mean, m/s
    speed_factor_mm_rpm: float  # speed factor n·Dpw, mm/min
    orbit_speed_difference_rpm: float  # largest difference of the orbital speed around the bearing, rpm
    ball_advance_deg: float  # circumferential ball advance, deg
    ball_advance_clearance_deg: float  # mean gap for the ball advance, deg
    ball_advance_clearance_um: float  # mean gap for the ball advance, on the pitch circle, um
    neighbour_drift_deg_s: float  # drift of neighbours of unequal size, deg/s
    inner_stiffness_n_m1_5: float  # contact stiffness K, inner raceway, N/m^1.5
    outer_stiffness_n_m1_5: float  # contact stiffness K, outer raceway, N/m^1.5
    ball_angle_deg: Floats  # angular position ψ, deg
    effective_radius_mm: Floats  # effective ball radius r, mm
    inner_force_n: Floats  # contact force, inner raceway, N
    outer_force_n: Floats  # contact force, outer raceway, N
    inner_pressure_mpa: Floats  # contact pressure, inner raceway, MPa
    outer_pressure_mpa: Floats  # contact pressure, outer raceway (of one contact point on a discrete raceway), MPa
    inner_semi_axis_across_mm: Floats  # contact semi-axis across the rolling direction, inner raceway, mm
    inner_semi_axis_along_mm: Floats  # contact semi-axis in the rolling direction, inner raceway, mm
    outer_semi_axis_across_mm: Floats  # contact semi-axis across the rolling direction, outer raceway, mm
    outer_semi_axis_along_mm: Floats  # contact semi-axis in the rolling direction, outer raceway, mm
    ball_orbit_rpm: Floats  # orbital speed in pure rolling, rpm
    ball_rotation_rpm: Floats  # ball speed in pure rolling (absolute rotation), rpm
    ftf_order: float  # FTF, multiple of the shaft frequency
    bpfo_order: float  # BPFO, multiple of the shaft frequency
    bpfi_order: float  # BPFI, multiple of the shaft frequency
    bsf_order: float  # BSF, multiple of the shaft frequency
    bsf_twice_order: float  # 2·BSF, multiple of the shaft frequency
    bsf_twice_hz: float  # 2·BSF in pure rolling, Hz
    initial_clearance_um: float  # radial internal clearance before mounting, um
    effective_shaft_interference_um: float  # interference of shaft and bore, um
    effective_housing_interference_um: float  # interference of outer ring and housing, um
    shaft_reduction_um: float  # reduction of the clearance by the fit on the shaft, um
    housing_reduction_um: float  # reduction of the clearance by the fit in the housing, um
    thermal_clearance_change_um: float  # change of the clearance by temperatures, um
    speed_reduction_um: float  # reduction of the clearance by the speed, um
    operating_clearance_um: float  # radial internal clearance in operation, um
    shaft_fit_pressure_mpa: float  # pressure between shaft and bore, MPa
    housing_fit_pressure_mpa: float  # pressure between outer ring and housing, MPa
    operating_clearance_least_um: float  # least radial internal clearance in operation, um
    operating_clearance_largest_um: float  # largest radial internal clearance in operation, um
    l10r_least_clearance_h: float  # L10r at the least clearance, h
    l10r_largest_clearance_h: float  # L10r at the largest clearance, h
    operating_clearance_extremes_um: Floats  # extreme radial internal clearances in operation, um
    viscosity_ratio: float  # viscosity ratio κ
    fatigue_load_limit_n: float  # fatigue load limit Cu (ISO 281), N
    life_modification_factor: float  # life modification factor aISO (ISO 281)
    l10m_mrev: float  # modified rating life L10m (ISO 281), Mrev
    l10m_h: float  # modified rating life L10m at the speed of the case, h
    l10mr_mrev: float  # modified reference rating life L10mr (ISO 16281), Mrev
    l10mr_h: float  # modified reference rating life L10mr at the speed of the case, h
    minimum_radial_load_n: float  # minimum radial load (SKF), N
    skf_rolling_torque_n_m: float  # rolling friction torque (SKF), N m
    skf_sliding_torque_n_m: float  # sliding friction torque (SKF), N m
    skf_model_torque_n_m: float  # friction torque (SKF model), N m
    skf_model_power_w: float  # power loss (SKF model), W
    oil_viscosity_mpa_s: float  # viscosity of the oil, mPa s
    film_thickness_min_um: float  # least film thickness, um
    film_thickness_mean_um: float  # film thickness, mean, um
    film_parameter_min: float  # film parameter Λ, least
    film_parameter_mean: float  # film parameter Λ, mean
    asperity_load_fraction: float  # share of the load on asperities
    mixed_friction_coefficient: float  # friction coefficient of film and asperities
    rolling_resistance_torque_n_m: float  # torque of rolling resistance, N m
    hysteresis_torque_n_m: float  # part of hysteresis, N m
    rolling_resistance_power_w: float  # power of rolling resistance, W
    free_arc_deg: float  # angle without inner contact, deg
    film_lag_per_turn_deg: float  # lag of a ball by the film per orbit, deg
    film_speed_deficit_fraction: float  # share d of its speed that a ball loses by the film
    film_opening_gap_deg: float  # gap that the film opens, deg
    free_share: float  # share that balls leave free
    film_range_exceeded: str  # range exceeded
    inner_film_parameter: Floats  # film parameter Λ, inner raceway
    outer_film_parameter: Floats  # film parameter Λ, outer raceway (the lesser of two contact points on a discrete raceway)
    ring_z_um: float  # displacement of the inner ring, z, um
    tilt_x_mrad: float  # tilt of the inner ring about x, mrad
    tilt_y_mrad: float  # tilt of the inner ring about y, mrad
    stiffness_zz_n_m: float  # axial stiffness of the bearing, kzz, N/m
    stiffness_xz_n_m: float  # stiffness of the bearing, kxz = kzx, N/m
    stiffness_yz_n_m: float  # stiffness of the bearing, kyz = kzy, N/m
    tilt_stiffness_xx_n_m_rad: float  # tilting stiffness about x, N m/rad
    tilt_stiffness_yy_n_m_rad: float  # tilting stiffness about y, N m/rad
    loaded_contact_angle_deg: float  # contact angle of the loaded bearing, deg
    loaded_ftf_hz: float  # FTF of the loaded bearing, Hz
    loaded_bpfo_hz: float  # BPFO of the loaded bearing, Hz
    loaded_bpfi_hz: float  # BPFI of the loaded bearing, Hz
    loaded_bsf_hz: float  # BSF of the loaded bearing, Hz
    stiffness_matrix: Floats  # stiffness matrix
    row: Floats  # row of the ball, from 1
    row_preload_um: Floats  # preload of the rows by displacement, um
    row_axial_force_n: Floats  # axial force of the rows, N
    inner_ellipse_edge_max_deg: float  # edge of contact ellipses, inner raceway, largest angle, deg
    outer_ellipse_edge_max_deg: float  # edge of contact ellipses, outer raceway, largest angle, deg
    inner_contact_angle_deg: Floats  # contact angle, inner raceway, deg
    outer_contact_angle_deg: Floats  # contact angle, outer raceway, deg
    flank_plus_force_n: Floats  # force at the outer groove, or at the flank towards +z, N
    flank_minus_force_n: Floats  # force at the flank towards -z, N
    plot_loads: Callable[..., go.Figure]  # contact forces and pressures of each ball over ψ


class DesignAttributes:
    """Attributes of a result of this kind."""

    epsilon_deg: float  # ball angle ε, deg
    uniform_gap_deg: float  # nominal gap, deg
    axial_span_limit_mm: float  # largest lC, Eq. (8), mm
    beta0_deg: float  # β0, Eq. (11), deg
    beta0_polar_deg: float  # β0 with the true polar angle, deg
    half_angle_for_span_deg: float  # θ by Eq. (11) for the span, deg
    steady_gap_deg: float  # steady-state gap, outside the raceway, deg
    speed_change_max_per_rad: float  # largest change of the orbital speed in the raceway, fraction of it per rad
    balls_in_raceway_max: int | None  # most balls inside at once
    slope_discontinuity_deg: float  # slope discontinuity at the raceway ends (at 45° groove angle), deg
    kinematic_lag_per_pass_deg: float  # lag per pass in pure rolling, estimate, deg
    contact_angle_three_quarters_deg: float  # contact angle that leaves three quarters of the lag, estimate, deg
    contact_angle_half_deg: float  # contact angle that leaves half of the lag, estimate, deg
    contact_angle_none_deg: float  # contact angle that leaves nothing of the lag, estimate, deg
    profile_flank_angle_deg: float  # flank angle in the middle of the measured raceway, deg
    profile_half_angle_deg: float  # half angle θ of the measured raceway, deg
    profile_deviation_deg: float  # deviation of the profile from the function that is fitted to it, deg
    profile_deviation_max_deg: float  # largest deviation of a row of the profile, deg
    verdict: str  # verdict
    passes: bool | None  # passes
    headline: str  # verdict with its reason
    criterion: str | None  # criterion that decides
    margin: float  # margin to the nearest limit
    critical_gap_deg: float  # critical gap, deg
    judged_steady_gap_deg: float  # steady-state gap of the verdict, deg
    pressure_at_rest_mpa: float  # peak contact pressure at rest, MPa
    gap_reserve_deg: float  # gap reserve, deg
    plot_curve: Callable[..., go.Figure]  # θ over lC by Eq. (11), with the raceway and the limits
    plot_contact_track: Callable[..., go.Figure]  # contact track of the first raceway
    plot_surface: Callable[..., go.Figure]  # surface of the first raceway
    plot_axial_load: Callable[..., go.Figure]  # lag in the raceway over the axial load, of a design with axial loads
    plot_axial_gap: Callable[..., go.Figure]  # critical gap over the axial load, of a design with axial loads


class SearchAttributes:
    """Attributes of a result of this kind."""

    critical_gap_min_fraction: float  # smallest critical gap, share of the steady-state gap
    axial_load_max_n: float  # largest axial load, N
    starts: int | None  # uneven initial states of each structure
    seed: int | None  # seed
    curve_axial_span_mm: Floats  # axial span lC of the curve of Eq. (11), mm
    curve_half_angle_deg: Floats  # half angle θ of the curve of Eq. (11), deg
    plot_verdicts: Callable[..., go.Figure]  # feasible designs and reasons for exclusion
    plot_critical_gaps: Callable[..., go.Figure]  # critical gap over lC and θ
    plot_trade_offs: Callable[..., go.Figure]  # trade-offs of the Pareto front


class ToleranceAttributes:
    """Attributes of a result of this kind."""

    title: str  # title
    software: str  # program and instruction set
    ball_grade: int | None  # grade of the balls (ISO 3290-1), 0 for equal balls
    passes: bool | None  # passes
    headline: str  # verdict with its reason
    nominal_passes: bool | None  # nominal bearing passes
    dry_passes: bool | None  # nominal bearing passes without oil
    dry_headline: str  # verdict with its reason on the nominal bearing without oil
    nominal_verdict: str  # verdict on the nominal bearing
    nominal_critical_gap_deg: float  # critical gap, nominal, deg
    nominal_judged_steady_gap_deg: float  # steady-state gap of the verdict, nominal, deg
    nominal_lag_fraction: float  # lag of the row and raceway with the least, share of rolling, nominal
    nominal_double_collision_fraction: float  # passages with a double collision, nominal
    nominal_sliding_m_s: float  # largest sliding speed in a passage, mean, nominal, m/s
    uniform_gap_deg: float  # nominal gap, deg
    plot_influences: Callable[..., go.Figure]  # range of the critical gap over each influence
    plot_samples: Callable[..., go.Figure]  # critical gaps of the bearings in which everything deviates, by verdict


class ComparisonAttributes:
    """Attributes of a result of this kind."""

    plot_spacing: Callable[..., go.Figure]  # standard deviation of the gaps over time
    plot_ring: Callable[..., go.Figure]  # height of the inner ring over time
    plot_loads: Callable[..., go.Figure]  # largest loads at the inner raceway around the bearing


class AnalysisAttributes:
    """Attributes of a result of this kind."""

    plot_shares: Callable[..., go.Figure]  # sensitivity (main effects)
    plot_effects: Callable[..., go.Figure]  # means of an output over the inputs that explain most of it
    plot_map: Callable[..., go.Figure]  # mean of an output over the two inputs that explain most of it
