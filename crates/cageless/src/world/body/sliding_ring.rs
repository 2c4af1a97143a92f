//! An outer ring that slides in its housing along the axis, pushed by the preload spring of its row:
//! coordinates, constants and work.

use super::{ContactStiffness, FastestRates};
use crate::case::{Case, Row};
use crate::dynamics::coordinates::{Coordinate, Kind, coordinate};

/// Index of a coordinate of an outer ring that slides in its housing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum SlidingCoordinate {
    /// z of the ring, from where no preload displaces it.
    Z,
    /// ż of the ring.
    Vz,
}

/// Coordinates of each outer ring that slides in its housing.
pub(crate) const TABLE: [Coordinate; 2] = [
    coordinate("outer_ring_z_m", "m", 1e-5, Kind::Position),
    coordinate("outer_ring_vz_m_s", "m/s", 0.1, Kind::VelocityOf(0)),
];

/// z of each ring that slides at the start, with the displacements by preload of all rows, m.
pub(crate) fn start_m(rows: &[Row], preload_m: &[f64]) -> impl Iterator<Item = f64> {
    let sliding = rows.iter().zip(preload_m);
    let sliding = sliding.filter(|(row, _)| row.preload_n > 0.0);
    sliding.map(|(row, preload_m)| -row.contact_sign * preload_m)
}

/// Largest load of a ring over that of its spring.
const OVERLOAD: f64 = 1.25;

/// Contribution of these rings to the fastest rates of a case. All balls of a row push its ring, at the contact
/// angle that its spring gives them: Σ sin²α over the mass of the ring.
pub(super) fn fastest_rates(case: &Case, contacts: &ContactStiffness) -> FastestRates {
    let sprung = || case.rows.iter().filter(|row| row.preload_n > 0.0);
    let balls = case.bearing.balls() as f64;
    let along = sprung().map(|row| {
        let [mass, _] = row.sliding(&case.bearing);
        let [_, sine] = case.thrust_on_ball(OVERLOAD * row.preload_n);
        balls * sine * sine / mass
    });
    let along = along.fold(0.0, f64::max);
    let decay = sprung().map(|row| {
        let [mass, damping] = row.sliding(&case.bearing);
        damping / mass
    });
    let decay = decay.fold(0.0, f64::max);
    FastestRates {
        square_1_s2: along * contacts.outer_n_m,
        decay_1_s: along * contacts.outer_n_s_m + decay,
    }
}

/// Constants of an outer ring that slides.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct SlidingRing {
    /// Row of the ring, from 0.
    pub row: usize,
    /// m, kg.
    pub mass: f64,
    /// c, N·s/m.
    pub damping: f64,
    /// Force of the spring along +Z, −σP, N.
    pub spring_n: f64,
}

/// Speed and force of a sliding outer ring at the last evaluation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct SlidingWork {
    /// Speed against the housing, m/s.
    pub speed: f64,
    /// Force of its balls along +Z, N.
    pub force_n: f64,
}

impl SlidingRing {
    /// Sliding outer rings of a case, row by row.
    pub(crate) fn of_case(case: &Case) -> Vec<Self> {
        let sprung = case.sprung_rows().into_iter();
        sprung
            .map(|row| (row, &case.rows[row]))
            .map(|(k, row)| {
                let [mass, damping] = row.sliding(&case.bearing);
                Self {
                    row: k,
                    mass,
                    damping,
                    spring_n: -row.contact_sign * row.preload_n,
                }
            })
            .collect()
    }
}
