//! Columns of the tables of runs and drops.

use std::borrow::Cow;
use std::sync::LazyLock;

use cageless::{RingSnapshot, RotorSnapshot, Snapshot};

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

/// Columns of the leading time, in `balls.parquet` of time and ball, and of the fields of a snapshot.
fn behind(first: Vec<Column>, fields: &[(&'static str, &'static str)]) -> Vec<Column> {
    let fields = fields.iter().map(|(name, unit)| number(name, unit));
    first.into_iter().chain(fields).collect()
}

/// Columns of `balls.parquet`, `ring.parquet` and `rotor.parquet`, in space or in the plane: the fields of
/// [`Snapshot`], [`RingSnapshot`] and [`RotorSnapshot`] behind the time, and the number of the ball.
pub fn run_columns(in_space: bool) -> [&'static [Column]; 3] {
    static IN_SPACE: LazyLock<[Vec<Column>; 3]> = LazyLock::new(|| {
        let time = || number("time_s", "s");
        [
            behind(vec![time(), ball("ball")], &Snapshot::FIELDS),
            behind(vec![time()], &RingSnapshot::FIELDS),
            behind(vec![time()], &RotorSnapshot::FIELDS),
        ]
    });
    let planar = [
        2 + Snapshot::IN_PLANE,
        1 + RingSnapshot::IN_PLANE,
        1 + RotorSnapshot::IN_PLANE,
    ];
    std::array::from_fn(|k| match in_space {
        true => &IN_SPACE[k][..],
        false => &IN_SPACE[k][..planar[k]],
    })
}

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
