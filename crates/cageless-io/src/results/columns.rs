//! Columns of the tables of runs and drops.

use std::borrow::Cow;

use super::table::{Column, ColumnKind};

const fn number(name: &'static str, unit: &'static str) -> Column {
    Column {
        name: Cow::Borrowed(name),
        unit: Cow::Borrowed(unit),
        kind: ColumnKind::Value,
    }
}

const fn ball(name: &'static str) -> Column {
    Column {
        name: Cow::Borrowed(name),
        unit: Cow::Borrowed("1"),
        kind: ColumnKind::Ordinal,
    }
}

/// Columns of `balls.parquet` of balls that move in space; from the third on as in
/// [`cageless::Snapshot::arrays`].
pub const BALLS_IN_SPACE: &[Column] = &[
    number("time_s", "s"),
    ball("ball"),
    number("angle_rad", "rad"),
    number("x_m", "m"),
    number("y_m", "m"),
    number("vx_m_s", "m/s"),
    number("vy_m_s", "m/s"),
    number("rotation_rad_s", "rad/s"),
    number("orbit_speed_rad_s", "rad/s"),
    number("gap_rad", "rad"),
    number("effective_radius_m", "m"),
    number("inner_force_n", "N"),
    number("outer_force_n", "N"),
    number("inner_sliding_m_s", "m/s"),
    number("outer_sliding_m_s", "m/s"),
    number("z_m", "m"),
    number("vz_m_s", "m/s"),
    number("omega_x_rad_s", "rad/s"),
    number("omega_y_rad_s", "rad/s"),
    number("inner_contact_angle_rad", "rad"),
    number("outer_contact_angle_rad", "rad"),
];

/// Columns of `balls.parquet` in the plane.
pub const BALLS: &[Column] = BALLS_IN_SPACE.split_at(15).0;

/// Columns of `ring.parquet` in space; from the second on as in [`cageless::RingSnapshot::values`].
pub const RING_IN_SPACE: &[Column] = &[
    number("time_s", "s"),
    number("x_m", "m"),
    number("y_m", "m"),
    number("vx_m_s", "m/s"),
    number("vy_m_s", "m/s"),
    number("ax_m_s2", "m/s^2"),
    number("ay_m_s2", "m/s^2"),
    number("outer_force_x_n", "N"),
    number("outer_force_y_n", "N"),
    number("z_m", "m"),
    number("vz_m_s", "m/s"),
    number("tilt_x_rad", "rad"),
    number("tilt_y_rad", "rad"),
];

/// Columns of `ring.parquet` in the plane.
pub const RING: &[Column] = RING_IN_SPACE.split_at(9).0;

/// Columns of `rotor.parquet` in space; from the second on as in [`cageless::RotorSnapshot::values`].
pub const ROTOR_IN_SPACE: &[Column] = &[
    number("time_s", "s"),
    number("x_m", "m"),
    number("y_m", "m"),
    number("vx_m_s", "m/s"),
    number("vy_m_s", "m/s"),
    number("angle_rad", "rad"),
    number("speed_rad_s", "rad/s"),
    number("ring_speed_rad_s", "rad/s"),
    number("housing_x_m", "m"),
    number("housing_y_m", "m"),
    number("housing_vx_m_s", "m/s"),
    number("housing_vy_m_s", "m/s"),
    number("contact_force_n", "N"),
    number("contact_sliding_m_s", "m/s"),
    number("z_m", "m"),
    number("vz_m_s", "m/s"),
    number("housing_z_m", "m"),
    number("housing_vz_m_s", "m/s"),
    number("shoulder_force_n", "N"),
];

/// Columns of `rotor.parquet` in the plane.
pub const ROTOR: &[Column] = ROTOR_IN_SPACE.split_at(14).0;

/// Columns of `collisions.parquet`.
pub const COLLISIONS: &[Column] = &[
    number("start_s", "s"),
    number("duration_s", "s"),
    ball("ball"),
    ball("next_ball"),
    number("angle_rad", "rad"),
    number("approach_speed_m_s", "m/s"),
    number("peak_force_n", "N"),
    number("impulse_n_s", "N s"),
];
