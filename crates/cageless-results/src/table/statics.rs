//! Results of a static equilibrium.

use std::f64::consts::TAU;

use cageless::BallAdvance;
use cageless::RacewayContact;
use cageless::equilibrium::space::SpatialEquilibrium;
use cageless::film::FilmAtRest;
use cageless::kinematics::{orbit_speed_of_rad_s, rolling_rotation_rad_s};
use cageless::rating::{EquivalentLoad, LubricatedRating, PassingFrequencies, Rating, SkfFriction};
use cageless::{ClearanceRange, OperatingClearance};

use crate::Solved;
use crate::cell::Cell;
use crate::declare::*;
use crate::group::Group;
use crate::meanings::*;
use crate::quantity::Quantity;
use crate::source::Source::Static;
use crate::table::unit::millipascal_seconds;
use crate::unit::rpm;

/// Ball advance that rounding makes of equal speeds.
const ROUNDING_RAD: f64 = 1e-9;

/// Results of a static equilibrium, with the ratings of the bearing.
#[rustfmt::skip]
pub const STATIC: &[Quantity] = &[
    group(Group::Displacement, unless_zero(means("from the centre of the outer ring, +x to the right", quantity("ring_x_um", "um", "displacement of the inner ring, x", Static(|s| some(s.equilibrium.ring_x_m * 1e6)))))),
    group(Group::Displacement, means("from the centre of the outer ring, +y upwards; a load downwards displaces the ring to negative values", quantity("ring_y_um", "um", "displacement of the inner ring, y", Static(|s| some(s.equilibrium.ring_y_m * 1e6))))),
    group(Group::Stiffness, high(quantity("stiffness_xx_n_m", "N/m", "stiffness of the bearing, kxx", Static(|s| stiffness(s, 0, 0))))),
    group(Group::Stiffness, high(quantity("stiffness_yy_n_m", "N/m", "stiffness of the bearing, kyy", Static(|s| stiffness(s, 1, 1))))),
    group(Group::Stiffness, unless_zero(quantity("stiffness_xy_n_m", "N/m", "stiffness of the bearing, kxy = kyx", Static(|s| stiffness(s, 0, 1))))),
    group(Group::Pressure, means(HERTZ_PRESSURE, low(quantity("inner_pressure_max_mpa", "MPa", "peak contact pressure, inner raceway", Static(|s| some(s.equilibrium.inner_pressure_max_pa * 1e-6)))))),
    group(Group::Pressure, means(HERTZ_PRESSURE, low(quantity("outer_pressure_max_mpa", "MPa", "peak contact pressure, outer raceway", Static(|s| some(s.equilibrium.outer_pressure_max_pa * 1e-6)))))),
    group(Group::Pressure, quantity("inner_force_max_n", "N", "largest force at the inner raceway", Static(|s| some(largest(&s.equilibrium.inner_force_n))))),
    group(Group::Pressure, quantity("outer_force_max_n", "N", "largest force at the outer raceway", Static(|s| some(largest(&s.equilibrium.outer_force_n))))),
    group(Group::Pressure, integer("loaded_balls", "balls under load", Static(|s| count(s.equilibrium.inner_force_n.iter().filter(|f| **f > 0.0).count())))),

    group(Group::Life, means("P of the external radial and axial load, with X, Y and e of the standard", low(quantity("equivalent_load_n", "N", "equivalent dynamic radial load P (ISO 281)", Static(|s| equivalent(s, |load| load.dynamic_n)))))),
    group(Group::Safety, means("P0 of the external radial and axial load, with X0 and Y0 of the standard", low(quantity("equivalent_static_load_n", "N", "equivalent static radial load P0 (ISO 76)", Static(|s| equivalent(s, |load| load.static_n)))))),
    group(Group::Safety, high(quantity("static_safety_factor", "", "static safety factor s0 = C0r/P0 (ISO 76)", Static(|s| s.rating.static_safety_factor.into())))),
    group(Group::Safety, means("on radial load, axial load and moments together, until the largest contact pressure in equilibrium reaches 4200 MPa; preload, weights and speed stay; none without load, and where a contact leaves its groove before", high(quantity("pressure_safety", "", "load factor until 4200 MPa", Static(|s| s.rating.pressure_safety.into()))))),
    file_only(text("assembly", "way of assembly", Static(|s| Cell::Text(s.case.bearing.assembly().name().to_owned())))),
    not_in_tables(quantity("rating_factor", "", "rating factor bm of ISO 281 for it", Static(|s| some(s.case.bearing.assembly().rating_factor())))),
    group(Group::Life, high(quantity("basic_dynamic_rating_n", "N", "basic dynamic radial load rating Cr (ISO 281)", Static(|s| some(s.rating.basic.dynamic_n))))),
    group(Group::Safety, high(quantity("basic_static_rating_n", "N", "basic static radial load rating C0r (ISO 76)", Static(|s| some(s.rating.basic.static_n))))),
    group(Group::Life, high(quantity("l10_mrev", "Mrev", "basic rating life L10 (ISO 281)", Static(|s| s.rating.l10_mrev.into())))),
    group(Group::Life, high(quantity("l10_h", "h", "basic rating life L10 at the speed of the case", Static(|s| hours(s, s.rating.l10_mrev))))),
    group(Group::Life, high(quantity("l10r_mrev", "Mrev", "basic reference rating life L10r (ISO 16281)", Static(|s| s.rating.l10r_mrev.into())))),
    group(Group::Life, high(quantity("l10r_h", "h", "basic reference rating life L10r at the speed of the case", Static(|s| hours(s, s.rating.l10r_mrev))))),
    group(Group::Life, high(quantity("l10r_at_speed_mrev", "Mrev", "L10r with weight and centrifugal force", Static(|s| s.rating.l10r_at_speed_mrev.into())))),
    group(Group::Life, high(quantity("l10r_at_speed_h", "h", "L10r with weight and centrifugal force, at the speed of the case", Static(|s| hours(s, s.rating.l10r_at_speed_mrev))))),

    group(Group::Frequencies, means(FTF, quantity("ftf_hz", "Hz", "FTF in pure rolling", Static(|s| some(s.rating.passing.ftf_hz))))),
    group(Group::Frequencies, means(BPFO, quantity("bpfo_hz", "Hz", "BPFO in pure rolling", Static(|s| some(s.rating.passing.bpfo_hz))))),
    group(Group::Frequencies, means(BPFI, quantity("bpfi_hz", "Hz", "BPFI in pure rolling", Static(|s| some(s.rating.passing.bpfi_hz))))),
    group(Group::Frequencies, means(BSF, quantity("bsf_hz", "Hz", "BSF in pure rolling", Static(|s| some(s.rating.passing.bsf_hz))))),
    group(Group::Frequencies, quantity("raceway_ftf_hz", "Hz", "FTF in pure rolling through the discrete raceways", Static(|s| some(s.rating.passing.raceway_ftf_hz)))),
    group(Group::Friction, means(REGULARISATION_SPEED, part(quantity("regularisation_speed_mean_m_s", "m/s", "regularisation speed of the friction, mean", Static(|s| s.regularisation_speed_mean_m_s.into()))))),
    group(Group::Friction, quantity("speed_factor_mm_rpm", "mm/min", "speed factor n·Dpw", Static(|s| some(s.rating.speed_factor_mm_rpm)))),
    group(Group::BallAdvance, means("of the balls in pure rolling, between two places of an orbit", quantity("orbit_speed_difference_rpm", "rpm", "largest difference of the orbital speed around the bearing", Static(|s| varying(s, |a| rpm(a.speed_difference_rad_s)))))),
    group(Group::BallAdvance, means("from the least to the largest angle that a ball is ahead of one of constant orbital speed, in an orbit", quantity("ball_advance_deg", "deg", "circumferential ball advance", Static(|s| varying(s, |a| a.advance_rad.to_degrees()))))),
    group(Group::BallAdvance, means("largest loss of a gap in an orbit by the ball advance; neighbours with a smaller mean gap meet in every orbit", quantity("ball_advance_clearance_deg", "deg", "mean gap for the ball advance", Static(|s| varying(s, |a| a.clearance_rad.to_degrees()))))),
    group(Group::BallAdvance, quantity("ball_advance_clearance_um", "um", "mean gap for the ball advance, on the pitch circle", Static(|s| varying(s, |a| 1e6 * a.clearance_rad * s.case.bearing.pitch_radius_m())))),
    group(Group::BallAdvance, means("in the plane, without contact, between the neighbours whose radii differ most; of equal balls between the smallest and the largest of a lot of grade G10", quantity("neighbour_drift_deg_s", "deg/s", "drift of neighbours of unequal size", Static(|s| advance(s, |a| a.neighbour_drift_rad_s.map(f64::to_degrees)))))),
    not_in_tables(means(STIFFNESS, quantity("inner_stiffness_n_m1_5", "N/m^1.5", "contact stiffness K, inner raceway", Static(|s| some(s.equilibrium.inner_stiffness_n_m1_5))))),
    not_in_tables(means(STIFFNESS, quantity("outer_stiffness_n_m1_5", "N/m^1.5", "contact stiffness K, outer raceway", Static(|s| some(s.equilibrium.outer_stiffness_n_m1_5))))),

    column("ψ", list("ball_angle_deg", "deg", "angular position ψ", Static(|s| each(&s.equilibrium.ball_angle_rad, |a| a.to_degrees())))),
    column("r", list("effective_radius_mm", "mm", "effective ball radius r", Static(|s| each(&s.equilibrium.effective_radius_m, |r| r * 1e3)))),
    column("Fi", list("inner_force_n", "N", "contact force, inner raceway", Static(|s| each(&s.equilibrium.inner_force_n, |f| *f)))),
    column("Fo", list("outer_force_n", "N", "contact force, outer raceway", Static(|s| each(&s.equilibrium.outer_force_n, |f| *f)))),
    column("pi", list("inner_pressure_mpa", "MPa", "contact pressure, inner raceway", Static(|s| each(&s.equilibrium.inner_contact, pressure_mpa)))),
    column("po", list("outer_pressure_mpa", "MPa", "contact pressure, outer raceway (of one contact point on a discrete raceway)", Static(|s| each(&s.equilibrium.outer_contact, pressure_mpa)))),
    column("ai", list("inner_semi_axis_across_mm", "mm", "contact semi-axis across the rolling direction, inner raceway", Static(|s| each(&s.equilibrium.inner_contact, |c| c.semi_axes_m[1] * 1e3)))),
    column("bi", list("inner_semi_axis_along_mm", "mm", "contact semi-axis in the rolling direction, inner raceway", Static(|s| each(&s.equilibrium.inner_contact, |c| c.semi_axes_m[0] * 1e3)))),
    column("ao", list("outer_semi_axis_across_mm", "mm", "contact semi-axis across the rolling direction, outer raceway", Static(|s| each(&s.equilibrium.outer_contact, |c| c.semi_axes_m[1] * 1e3)))),
    column("bo", list("outer_semi_axis_along_mm", "mm", "contact semi-axis in the rolling direction, outer raceway", Static(|s| each(&s.equilibrium.outer_contact, |c| c.semi_axes_m[0] * 1e3)))),
    means("around the axis of the bearing; balls without load at the inner raceway keep the energy with which they left it", column("orbital speed", list("ball_orbit_rpm", "rpm", "orbital speed in pure rolling", Static(|s| each_ball(s, |k| rpm(orbit_rad_s(s, k))))))),
    column("ball speed", list("ball_rotation_rpm", "rpm", "ball speed in pure rolling (absolute rotation)", Static(|s| each_ball(s, |k| rpm(rotation_rad_s(s, k)))))),
];

/// Frequencies of defects for vibration analysts, next to those in hertz: as multiples ("orders") of the
/// rotational frequency of the inner ring.
#[rustfmt::skip]
pub const DEFECTS: &[Quantity] = &[
    group(Group::Orders, means("orbital frequency of the balls over that of the shaft: where a cage would be, and one uneven ball or group of balls; their distance in side bands of BSF", part(quantity("ftf_order", "", "FTF, multiple of the shaft frequency", Static(|s| order(s, |f| f.ftf_hz)))))),
    group(Group::Orders, means("a defect of the outer raceway", part(quantity("bpfo_order", "", "BPFO, multiple of the shaft frequency", Static(|s| order(s, |f| f.bpfo_hz)))))),
    group(Group::Orders, means("a defect of the inner raceway; side bands at the shaft frequency", part(quantity("bpfi_order", "", "BPFI, multiple of the shaft frequency", Static(|s| order(s, |f| f.bpfi_hz)))))),
    group(Group::Orders, means("a defect of a ball that meets one raceway", part(quantity("bsf_order", "", "BSF, multiple of the shaft frequency", Static(|s| order(s, |f| f.bsf_hz)))))),
    group(Group::Orders, means("a defect of a ball that meets both raceways in each rotation", part(quantity("bsf_twice_order", "", "2·BSF, multiple of the shaft frequency", Static(|s| order(s, |f| 2.0 * f.bsf_hz)))))),
    not_in_tables(part(quantity("bsf_twice_hz", "Hz", "2·BSF in pure rolling", Static(|s| some(2.0 * s.rating.passing.bsf_hz))))),
];

/// Further results of a static equilibrium with fits and temperatures.
#[rustfmt::skip]
pub const FIT: &[Quantity] = &[
    group(Group::Clearance, means("Gr of the file, at 20 °C and at rest", part(quantity("initial_clearance_um", "um", "radial internal clearance before mounting", Static(|s| fitted(s, |f| f.initial_m * 1e6)))))),
    group(Group::Clearance, unless_zero(means("at temperatures and speed of the parts; 0 or below: a gap", part(quantity("effective_shaft_interference_um", "um", "interference of shaft and bore", Static(|s| fitted(s, |f| f.shaft_interference_m * 1e6))))))),
    group(Group::Clearance, unless_zero(means("at the temperatures of the parts; 0 or below: a gap", part(quantity("effective_housing_interference_um", "um", "interference of outer ring and housing", Static(|s| fitted(s, |f| f.housing_interference_m * 1e6))))))),
    group(Group::Clearance, unless_zero(means("Lamé, the ring up to the bottom of its groove", part(quantity("shaft_reduction_um", "um", "reduction of the clearance by the fit on the shaft", Static(|s| fitted(s, |f| f.shaft_reduction_m * 1e6))))))),
    group(Group::Clearance, unless_zero(means("Lamé, the ring up to the bottom of its groove", part(quantity("housing_reduction_um", "um", "reduction of the clearance by the fit in the housing", Static(|s| fitted(s, |f| f.housing_reduction_m * 1e6))))))),
    group(Group::Clearance, unless_zero(means("by the expansion of free rings and balls over 20 °C", part(quantity("thermal_clearance_change_um", "um", "change of the clearance by temperatures", Static(|s| fitted(s, |f| f.thermal_change_m * 1e6))))))),
    group(Group::Clearance, unless_zero(means("the inner raceway of a free ring, from its bore on; the fit on the shaft has what the speed leaves of it", part(quantity("speed_reduction_um", "um", "reduction of the clearance by the speed", Static(|s| fitted(s, |f| f.speed_reduction_m * 1e6))))))),
    group(Group::Clearance, means("with which everything is computed; below 0: preload", part(quantity("operating_clearance_um", "um", "radial internal clearance in operation", Static(|s| fitted(s, |f| f.operating_m() * 1e6)))))),
    group(Group::Clearance, unless_zero(part(quantity("shaft_fit_pressure_mpa", "MPa", "pressure between shaft and bore", Static(|s| fitted(s, |f| f.shaft_pressure_pa * 1e-6)))))),
    group(Group::Clearance, unless_zero(part(quantity("housing_fit_pressure_mpa", "MPa", "pressure between outer ring and housing", Static(|s| fitted(s, |f| f.housing_pressure_pa * 1e-6)))))),
];

/// Further results of a static equilibrium with tolerances of shaft, housing or clearance.
#[rustfmt::skip]
pub const CLEARANCE_RANGE: &[Quantity] = &[
    group(Group::Clearance, means("three standard deviations below that of the middles, a sixth of a tolerance being one; 99.7 % of bearings lie between both", part(quantity("operating_clearance_least_um", "um", "least radial internal clearance in operation", Static(|s| end_um(s, |r| r.probable_m[0])))))),
    group(Group::Clearance, means("three standard deviations above", part(quantity("operating_clearance_largest_um", "um", "largest radial internal clearance in operation", Static(|s| end_um(s, |r| r.probable_m[1])))))),
    group(Group::Life, part(high(quantity("l10r_least_clearance_h", "h", "L10r at the least clearance", Static(|s| hours(s, s.l10r_of_range_mrev[0])))))),
    group(Group::Life, part(high(quantity("l10r_largest_clearance_h", "h", "L10r at the largest clearance", Static(|s| hours(s, s.l10r_of_range_mrev[1])))))),
    means("all tolerances at their worst limits together: least and largest", file_only(range("operating_clearance_extremes_um", "um", "extreme radial internal clearances in operation", Static(|s| s.particulars.fit.and_then(|fit| fit.range).map_or(Cell::Null, |r| Cell::Numbers(r.extreme_m.map(|m| m * 1e6).to_vec())))))),
];

/// Further results of a static equilibrium with a lubricant.
#[rustfmt::skip]
pub const LUBRICATION: &[Quantity] = &[
    group(Group::Life, means("κ = ν/ν1, viscosity over the one for an adequate film (ISO 281)", part(high(quantity("viscosity_ratio", "", "viscosity ratio κ", Static(|s| lubricated(s, |l| Some(l.viscosity_ratio)))))))),
    group(Group::Life, means("the load that no fatigue follows from, given or from a contact pressure of 1500 MPa", part(high(quantity("fatigue_load_limit_n", "N", "fatigue load limit Cu (ISO 281)", Static(|s| lubricated(s, |l| Some(l.fatigue_load_limit_n)))))))),
    group(Group::Life, means("from κ and eC Cu/P; none below κ = 0.1", part(high(quantity("life_modification_factor", "", "life modification factor aISO (ISO 281)", Static(|s| lubricated(s, |l| l.life_modification_factor))))))),
    group(Group::Life, means("aISO L10, of 90 % of the bearings", part(high(quantity("l10m_mrev", "Mrev", "modified rating life L10m (ISO 281)", Static(|s| lubricated(s, |l| l.l10m_mrev))))))),
    group(Group::Life, part(high(quantity("l10m_h", "h", "modified rating life L10m at the speed of the case", Static(|s| hours(s, s.lubricated.and_then(|l| l.l10m_mrev))))))),
    group(Group::Life, means("aISO L10r, with aISO at the load of the basic reference rating life", part(high(quantity("l10mr_mrev", "Mrev", "modified reference rating life L10mr (ISO 16281)", Static(|s| lubricated(s, |l| l.l10mr_mrev))))))),
    group(Group::Life, part(high(quantity("l10mr_h", "h", "modified reference rating life L10mr at the speed of the case", Static(|s| hours(s, s.lubricated.and_then(|l| l.l10mr_mrev))))))),
    group(Group::Safety, means("below which balls may slide, by SKF's rule for deep groove ball bearings with a cage", part(quantity("minimum_radial_load_n", "N", "minimum radial load (SKF)", Static(|s| lubricated(s, |l| l.minimum_radial_load_n)))))),
    group(Group::Friction, means("φish φrs Mrr of SKF's model for deep groove ball bearings with a cage", part(low(quantity("skf_rolling_torque_n_m", "N m", "rolling friction torque (SKF)", Static(|s| skf(s, |f| f.rolling_n_m))))))),
    group(Group::Friction, means("Msl of SKF's model for deep groove ball bearings with a cage", part(low(quantity("skf_sliding_torque_n_m", "N m", "sliding friction torque (SKF)", Static(|s| skf(s, |f| f.sliding_n_m))))))),
    group(Group::Friction, means("of SKF's model, without seals and drag; next to the friction of the motion and no part of it", part(low(quantity("skf_model_torque_n_m", "N m", "friction torque (SKF model)", Static(|s| skf(s, SkfFriction::torque_n_m))))))),
    group(Group::Friction, part(low(quantity("skf_model_power_w", "W", "power loss (SKF model)", Static(|s| s.lubricated.and_then(|l| l.skf_friction).map(|f| f.torque_n_m() * s.case.operation.inner_speed_rad_s.abs()).into()))))),
];

/// Further results of a static equilibrium with an oil film.
#[rustfmt::skip]
pub const FILM: &[Quantity] = &[
    group(Group::Film, means("dynamic, at the inlet of the contacts: given, or that of the oil at `film.temperature_c`", in_oil(quantity("oil_viscosity_mpa_s", "mPa s", "viscosity of the oil", Static(|s| s.case.film.map(|film| millipascal_seconds(film.oil.viscosity_pa_s)).into()))))),
    group(Group::Film, means("of a flooded, isothermal contact: an upper bound (Hamrock & Dowson)", in_oil(high(quantity("film_thickness_min_um", "um", "least film thickness", Static(|s| film(s, |f| f.thickness_min_m * 1e6))))))),
    group(Group::Film, means("mean of the film in the middle of all loaded contacts; flooded and isothermal", in_oil(high(quantity("film_thickness_mean_um", "um", "film thickness, mean", Static(|s| film(s, |f| f.thickness_mean_m * 1e6))))))),
    group(Group::Film, means("least film thickness over the roughness", in_oil(high(quantity("film_parameter_min", "", "film parameter Λ, least", Static(|s| film(s, |film| film.film_parameter_min))))))),
    group(Group::Film, means("film thickness in the middle of the contacts over the roughness, mean", in_oil(high(quantity("film_parameter_mean", "", "film parameter Λ, mean", Static(|s| film(s, |film| film.film_parameter_mean))))))),
    group(Group::Film, means("largest of all contacts, from Λ of the middle of the contact (Zhou & Hoeprich)", in_oil(low(quantity("asperity_load_fraction", "", "share of the load on asperities", Static(|s| film(s, |film| film.asperity_share_max))))))),
    group(Group::Film, means("of all contacts under load, sliding at 1 % of the speed of rolling; with `film.traction = \"film\"`", in_oil(low(quantity("mixed_friction_coefficient", "", "friction coefficient of film and asperities", Static(|s| s.film.as_ref().and_then(|f| f.mixed_friction_coefficient).into())))))),
    group(Group::Film, means("of the oil film, with `film.hysteresis` also of the steel: power over the speed of the inner ring; without sliding", in_oil(low(quantity("rolling_resistance_torque_n_m", "N m", "torque of rolling resistance", Static(|s| film(s, |f| f.torque_n_m))))))),
    group(Group::Film, means("elastic hysteresis of the steel, part of `rolling_resistance_torque_n_m`; with `film.hysteresis`", part(low(quantity("hysteresis_torque_n_m", "N m", "  part of hysteresis", Static(|s| s.film.as_ref().and_then(|f| f.hysteresis_torque_n_m).into())))))),
    group(Group::Film, means("that torque times the speed of the inner ring", in_oil(low(quantity("rolling_resistance_power_w", "W", "power of rolling resistance", Static(|s| film(s, |f| f.power_w))))))),
    group(Group::Film, means("over which the outer raceway alone carries a ball, from the place of the ring", part(quantity("free_arc_deg", "deg", "angle without inner contact", Static(|s| film(s, |f| f.free_arc_rad.to_degrees())))))),
    group(Group::Film, means("against rolling, over the angle without inner contact", in_oil(quantity("film_lag_per_turn_deg", "deg", "lag of a ball by the film per orbit", Static(|s| film(s, |f| f.lag_rad.to_degrees())))))),
    group(Group::Film, means("by the film alone, of a ball that the outer raceway alone carries; balls queue from some 1.3 times `free_share` on, never below 1.1", in_oil(quantity("film_speed_deficit_fraction", "", "share d of its speed that a ball loses by the film", Static(|s| film(s, |f| f.speed_deficit)))))),
    group(Group::Film, means("0.85 d 360°/N, behind a ball that enters the load zone; none without one, and of a ball that stops", in_oil(quantity("film_opening_gap_deg", "deg", "gap that the film opens", Static(|s| film(s, |f| f.opening_gap_rad.to_degrees())))))),
    group(Group::Film, means("of the pitch circle, 1 − N ε/360°", in_oil(quantity("free_share", "", "share that balls leave free", Static(|s| film(s, |f| f.free_share)))))),
    means("of the fit of the rolling force, with the factor, of the contact furthest outside; none within", part(text("film_range_exceeded", "range exceeded", Static(|s| s.film.as_ref().and_then(FilmAtRest::range_exceeded).map_or(Cell::Null, Cell::Text))))),
    column("Λi", part(list("inner_film_parameter", "", "film parameter Λ, inner raceway", Static(|s| films(s, |film| &film.inner_film_parameters))))),
    column("Λo", part(list("outer_film_parameter", "", "film parameter Λ, outer raceway (the lesser of two contact points on a discrete raceway)", Static(|s| films(s, |film| &film.outer_film_parameters))))),
];

/// Further results of a static equilibrium in space: under an axial load, moments or a tilt, with a
/// contact angle or several rows.
#[rustfmt::skip]
pub const SPACE: &[Quantity] = &[
    group(Group::Displacement, means("along the axis, from where unloaded balls touch at the free contact angle", quantity("ring_z_um", "um", "displacement of the inner ring, z", Static(|s| space(s, |e| e.ring_z_m * 1e6))))),
    group(Group::Displacement, unless_zero(means("-1000 times the y component of the axis of the ring", quantity("tilt_x_mrad", "mrad", "tilt of the inner ring about x", Static(|s| space(s, |e| e.tilt_x_rad * 1e3)))))),
    group(Group::Displacement, unless_zero(means("1000 times the x component of the axis of the ring", quantity("tilt_y_mrad", "mrad", "tilt of the inner ring about y", Static(|s| space(s, |e| e.tilt_y_rad * 1e3)))))),
    group(Group::Stiffness, high(quantity("stiffness_zz_n_m", "N/m", "axial stiffness of the bearing, kzz", Static(|s| entry(s, 2, 2))))),
    group(Group::Stiffness, unless_zero(quantity("stiffness_xz_n_m", "N/m", "stiffness of the bearing, kxz = kzx", Static(|s| entry(s, 0, 2))))),
    group(Group::Stiffness, unless_zero(quantity("stiffness_yz_n_m", "N/m", "stiffness of the bearing, kyz = kzy", Static(|s| entry(s, 1, 2))))),
    group(Group::Stiffness, high(quantity("tilt_stiffness_xx_n_m_rad", "N m/rad", "tilting stiffness about x", Static(|s| entry(s, 3, 3))))),
    group(Group::Stiffness, high(quantity("tilt_stiffness_yy_n_m_rad", "N m/rad", "tilting stiffness about y", Static(|s| entry(s, 4, 4))))),
    group(Group::Displacement, means("mean of both contacts of the balls that carry, without sign; frequencies of the loaded bearing are at this angle, those above at the free contact angle", part(quantity("loaded_contact_angle_deg", "deg", "contact angle of the loaded bearing", Static(|s| s.rating.loaded_contact_angle_rad.map(f64::to_degrees).into()))))),
    group(Group::Frequencies, means(FTF, part(quantity("loaded_ftf_hz", "Hz", "FTF of the loaded bearing", Static(|s| loaded(s, |f| f.ftf_hz)))))),
    group(Group::Frequencies, means(BPFO, part(quantity("loaded_bpfo_hz", "Hz", "BPFO of the loaded bearing", Static(|s| loaded(s, |f| f.bpfo_hz)))))),
    group(Group::Frequencies, means(BPFI, part(quantity("loaded_bpfi_hz", "Hz", "BPFI of the loaded bearing", Static(|s| loaded(s, |f| f.bpfi_hz)))))),
    group(Group::Frequencies, means(BSF, part(quantity("loaded_bsf_hz", "Hz", "BSF of the loaded bearing", Static(|s| loaded(s, |f| f.bsf_hz)))))),
    means("force or moment on the inner ring over its displacement or tilt, row by row over x, y, z, tilt about x, tilt about y; N/m, N/rad and N, N·m/rad", part(list("stiffness_matrix", "", "stiffness matrix", Static(|s| match s.space.and_then(|e| e.stiffness) {
        Some(matrix) => Cell::Numbers(matrix.concat()),
        None => Cell::Null,
    })))),
    part(list("row", "", "row of the ball, from 1", Static(|s| of_space(s, |e| e.row.iter().map(|row| (row + 1) as f64).collect())))),
    group(Group::Displacement, unless_zero(means("by which the outer ring of each row is displaced against its contact sign, given or by its spring", part(few("row_preload_um", "um", "preload of the rows by displacement", Static(|s| of_space(s, |e| e.row_preload_m.iter().map(|m| m * 1e6).collect()))))))),
    group(Group::Pressure, means("of the balls of each row on its outer ring, along z", part(few("row_axial_force_n", "N", "axial force of the rows", Static(|s| of_space(s, |e| e.row_axial_force_n.clone())))))),
    group(Group::Pressure, means(ELLIPSE_EDGE, part(quantity("inner_ellipse_edge_max_deg", "deg", "edge of contact ellipses, inner raceway, largest angle", Static(|s| space(s, |e| e.ellipse_edge_max_rad[0].to_degrees())))))),
    group(Group::Pressure, means(ELLIPSE_EDGE, part(quantity("outer_ellipse_edge_max_deg", "deg", "edge of contact ellipses, outer raceway, largest angle", Static(|s| space(s, |e| e.ellipse_edge_max_rad[1].to_degrees())))))),
    means("positive where the inner ring is pushed towards +z", column("αi", part(list("inner_contact_angle_deg", "deg", "contact angle, inner raceway", Static(|s| of_space(s, |e| in_degrees(&e.inner_contact_angle_rad))))))),
    means("angle of the force on the outer ring, on a discrete raceway of both flanks together", column("αo", part(list("outer_contact_angle_deg", "deg", "contact angle, outer raceway", Static(|s| of_space(s, |e| in_degrees(&e.outer_contact_angle_rad))))))),
    column("F+", part(list("flank_plus_force_n", "N", "force at the outer groove, or at the flank towards +z", Static(|s| of_space(s, |e| e.flank_force_n.iter().map(|f| f[0]).collect()))))),
    column("F-", part(list("flank_minus_force_n", "N", "force at the flank towards -z", Static(|s| of_space(s, |e| e.flank_force_n.iter().map(|f| f[1]).collect()))))),
];

fn space(solved: &Solved<'_>, value: fn(&SpatialEquilibrium) -> f64) -> Cell {
    solved.space.map(value).into()
}

fn of_space(solved: &Solved<'_>, values: fn(&SpatialEquilibrium) -> Vec<f64>) -> Cell {
    let values = solved.space.map(values);
    values.map_or(Cell::Null, Cell::Numbers)
}

fn entry(solved: &Solved<'_>, row: usize, column: usize) -> Cell {
    let matrix = solved.space.and_then(|e| e.stiffness);
    matrix.map(|k| k[row][column]).into()
}

fn in_degrees(angles: &[f64]) -> Vec<f64> {
    angles.iter().map(|a| a.to_degrees()).collect()
}

fn stiffness(solved: &Solved<'_>, row: usize, column: usize) -> Cell {
    let matrix = solved.equilibrium.stiffness_n_m;
    matrix.map(|k| k[row][column]).into()
}

/// A frequency over that of the inner ring; none at standstill.
fn order(solved: &Solved<'_>, value: fn(&PassingFrequencies) -> f64) -> Cell {
    let shaft_hz = solved.case.operation.inner_speed_rad_s.abs() / TAU;
    (shaft_hz > 0.0)
        .then(|| value(&solved.rating.passing) / shaft_hz)
        .into()
}

/// A frequency at the contact angle of the loaded bearing.
fn loaded(solved: &Solved<'_>, value: fn(&PassingFrequencies) -> f64) -> Cell {
    let angle = solved.rating.loaded_contact_angle_rad;
    angle
        .map(|angle| value(&PassingFrequencies::at_contact_angle(solved.case, angle)))
        .into()
}

fn fitted(solved: &Solved<'_>, value: fn(&OperatingClearance) -> f64) -> Cell {
    solved.particulars.fit.as_ref().map(value).into()
}

fn end_um(solved: &Solved<'_>, value: fn(&ClearanceRange) -> f64) -> Cell {
    let range = solved.particulars.fit.and_then(|fit| fit.range);
    range.map(|range| value(&range) * 1e6).into()
}

fn lubricated(s: &Solved<'_>, value: fn(&LubricatedRating) -> Option<f64>) -> Cell {
    s.lubricated.as_ref().and_then(value).into()
}

/// A torque of SKF's model, where it has one.
fn skf(s: &Solved<'_>, torque_n_m: fn(&SkfFriction) -> f64) -> Cell {
    let friction = s.lubricated.as_ref().and_then(|l| l.skf_friction.as_ref());
    friction.map(torque_n_m).into()
}

/// An equivalent load of the external ones, where there is one.
fn equivalent(s: &Solved<'_>, load_n: fn(&EquivalentLoad) -> f64) -> Cell {
    s.rating.equivalent.as_ref().map(load_n).into()
}

fn film(s: &Solved<'_>, value: impl Fn(&FilmAtRest) -> f64) -> Cell {
    s.film.as_ref().map(value).into()
}

/// Λ of the films at a raceway.
fn films(s: &Solved<'_>, of: fn(&FilmAtRest) -> &Vec<f64>) -> Cell {
    let numbers = s.film.as_ref().map(|at_rest| of(at_rest).clone());
    numbers.map_or(Cell::Null, Cell::Numbers)
}

fn hours(solved: &Solved<'_>, life_mrev: Option<f64>) -> Cell {
    life_mrev
        .and_then(|life| Rating::hours(solved.case, life))
        .into()
}

fn each<T>(values: &[T], value: fn(&T) -> f64) -> Cell {
    Cell::Numbers(values.iter().map(value).collect())
}

fn each_ball(solved: &Solved<'_>, value: impl Fn(usize) -> f64) -> Cell {
    let balls = solved.equilibrium.ball_angle_rad.len();
    Cell::Numbers((0..balls).map(value).collect())
}

fn pressure_mpa(contact: &RacewayContact) -> f64 {
    contact.pressure_pa * 1e-6
}

fn advance(solved: &Solved<'_>, value: impl Fn(&BallAdvance) -> Option<f64>) -> Cell {
    solved.advance.as_ref().and_then(value).into()
}

/// Value of the ball advance where the speeds of the balls differ by more than rounding.
fn varying(solved: &Solved<'_>, value: impl Fn(&BallAdvance) -> f64) -> Cell {
    advance(solved, |a| (a.advance_rad > ROUNDING_RAD).then(|| value(a)))
}

/// Orbital speed of a ball; on Rm where nothing drives the balls.
fn orbit_rad_s(solved: &Solved<'_>, ball: usize) -> f64 {
    if let Some(advance) = &solved.advance {
        return advance.orbit_speed_rad_s[ball];
    }
    if let Some(space) = solved.space {
        return space.orbit_speed_rad_s[ball];
    }
    let case = solved.case;
    let inner = case.operation.inner_speed_rad_s;
    let r = solved.equilibrium.effective_radius_m[ball];
    orbit_speed_of_rad_s(&case.bearing, case.bearing.ball(ball).radius_m, inner, r)
}

fn rotation_rad_s(solved: &Solved<'_>, ball: usize) -> f64 {
    if let Some(advance) = &solved.advance {
        return advance.rotation_rad_s[ball];
    }
    let r = solved.equilibrium.effective_radius_m[ball];
    rolling_rotation_rad_s(&solved.case.bearing, orbit_rad_s(solved, ball), r)
}
