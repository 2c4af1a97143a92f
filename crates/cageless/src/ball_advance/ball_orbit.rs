//! One orbit of a ball: its speed, its time and how far it is ahead at every place.

use std::f64::consts::TAU;

use super::rolling_energy::RollingEnergy;
use super::rolling_row::RollingRow;
use crate::case::Case;
use crate::equilibrium::space::{RollingBall, SpatialEquilibrium};
use crate::numerics::root::brent;

/// Places around the bearing, at least.
const PLACES: usize = 360;

/// Error of the place at which the inner raceway releases or meets a ball, rad.
const EDGE_RAD: f64 = 1e-9;

/// Radius of the orbit that turns vt into Ω: |rb|; Rm in the equations as published (Zhao 2022, Eq. (1) and (2)).
pub(super) fn orbit_radius_m(case: &Case, distance_m: f64) -> f64 {
    match case.formulation.equations().orbits_on_pitch_circle {
        true => case.bearing.pitch_radius_m(),
        false => distance_m,
    }
}

/// A place of a ball in its orbit.
#[derive(Debug, Clone, Copy)]
struct Place {
    /// ψ, rad, beyond that of the first place.
    angle_rad: f64,
    /// Ω, rad/s.
    orbit_speed_rad_s: f64,
    /// Twice the energy over the mass, m²/s².
    energy_m2_s2: f64,
    /// Time from the first place, s.
    time_s: f64,
}

/// One orbit of a ball, from a place where the inner raceway drives it.
#[derive(Debug, Clone)]
pub(super) struct BallOrbit {
    /// ψ of the first place, rad.
    first_rad: f64,
    /// Places up to the first one again.
    places: Vec<Place>,
}

impl BallOrbit {
    pub(super) fn new(
        case: &Case,
        settled: &SpatialEquilibrium,
        row: usize,
        deviation_m: f64,
    ) -> Option<Self> {
        let mut rolling = RollingRow::new(case, settled, row, deviation_m)?;
        let balls = settled.row.iter().filter(|of| **of == row).count();
        let parts = PLACES.div_ceil(balls);
        let part_rad = TAU / (balls * parts) as f64;
        let lead_rad = case.start.lead_ball_angle_rad;
        let leads = (0..parts).map(|part| rolling.balls(lead_rad + part as f64 * part_rad));
        let leads: Vec<_> = leads.collect();
        let around = (0..balls).flat_map(|k| leads.iter().map(move |seated| seated[k]));
        let mut around: Vec<RollingBall> = around.collect();
        let first = around.iter().position(|ball| ball.inner_depth_m > 0.0)?;
        around.rotate_left(first);
        around.push(around[0]);
        let first_rad = around[0].angle_rad;
        let mut orbit = Self {
            first_rad,
            places: Vec::with_capacity(around.len() + 8),
        };
        for pair in around.windows(2) {
            let [here, next] = [&pair[0], &pair[1]];
            orbit.push(case, here, here.inner_depth_m > 0.0);
            let [leaves, meets] = [here, next].map(|ball| ball.inner_depth_m > 0.0);
            if leaves != meets {
                let edge = edge(&mut rolling, here, part_rad);
                orbit.push(case, &edge, leaves);
                orbit.push(case, &edge, meets);
            }
        }
        orbit.push(case, &around[0], true);
        Some(orbit)
    }

    /// Adds a place, at which the inner raceway drives the ball or does not.
    fn push(&mut self, case: &Case, ball: &RollingBall, is_driven: bool) {
        let energy = RollingEnergy::new(case, ball);
        let before = self.places.last().copied();
        let kept = before.filter(|_| !is_driven);
        let kept = kept.and_then(|before| energy.speed_m_s(before.energy_m2_s2));
        let speed_m_s = kept.unwrap_or(ball.speed_m_s);
        let orbit_speed_rad_s = speed_m_s / orbit_radius_m(case, ball.distance_m);
        let beyond_rad = (ball.angle_rad - self.first_rad).rem_euclid(TAU);
        // Rounding takes no place back, and the last one is at the end of the orbit.
        let angle_rad = match &before {
            Some(before) if beyond_rad < before.angle_rad - 1.0 => TAU,
            Some(before) => beyond_rad.max(before.angle_rad),
            None => 0.0,
        };
        let time_s = before.map_or(0.0, |before| {
            let slowness = 0.5 / before.orbit_speed_rad_s + 0.5 / orbit_speed_rad_s;
            before.time_s + (angle_rad - before.angle_rad) * slowness
        });
        self.places.push(Place {
            angle_rad,
            orbit_speed_rad_s,
            energy_m2_s2: energy.at_speed_m2_s2(speed_m_s),
            time_s,
        });
    }

    /// T, s.
    fn period_s(&self) -> f64 {
        self.places.last().map_or(f64::NAN, |place| place.time_s)
    }

    /// Ω̄, rad/s.
    pub(super) fn mean_rad_s(&self) -> f64 {
        TAU / self.period_s()
    }

    pub(super) fn speed_difference_rad_s(&self) -> f64 {
        span(self.places.iter().map(|place| place.orbit_speed_rad_s))
    }

    /// a at a place.
    fn ahead_rad(&self, place: &Place) -> f64 {
        place.angle_rad - self.mean_rad_s() * place.time_s
    }

    pub(super) fn advance_rad(&self) -> f64 {
        span(self.places.iter().map(|place| self.ahead_rad(place)))
    }

    /// a at a time, rad.
    fn ahead_at_rad(&self, time_s: f64) -> f64 {
        let time_s = time_s.rem_euclid(self.period_s());
        let next = self.places.partition_point(|place| place.time_s <= time_s);
        let k = next.clamp(1, self.places.len() - 1);
        let [before, after] = [&self.places[k - 1], &self.places[k]];
        let part = (time_s - before.time_s) / (after.time_s - before.time_s);
        self.ahead_rad(before) * (1.0 - part) + self.ahead_rad(after) * part
    }

    /// Largest loss of the gap of one of `balls` to the next in an orbit.
    pub(super) fn closing_rad(&self, balls: usize) -> f64 {
        let lag_s = self.period_s() / balls as f64;
        let lost = |place: &Place| self.ahead_rad(place) - self.ahead_at_rad(place.time_s + lag_s);
        self.places.iter().map(lost).fold(0.0, f64::max)
    }

    /// Twice the energy over the mass at ψ, m²/s²: that of the place before it.
    pub(super) fn energy_at_m2_s2(&self, angle_rad: f64) -> f64 {
        let beyond_rad = (angle_rad - self.first_rad).rem_euclid(TAU);
        let next = self
            .places
            .partition_point(|place| place.angle_rad <= beyond_rad);
        self.places[next.max(1) - 1].energy_m2_s2
    }
}

/// Ball where the inner raceway releases or meets it, within `part_rad` after `here`.
fn edge(rolling: &mut RollingRow, here: &RollingBall, part_rad: f64) -> RollingBall {
    let depth = |beyond_rad: f64| rolling.balls(here.angle_rad + beyond_rad)[0].inner_depth_m;
    let beyond_rad = brent(depth, 0.0, part_rad, EDGE_RAD).unwrap_or(part_rad);
    rolling.balls(here.angle_rad + beyond_rad)[0]
}

/// Largest less least value.
fn span(values: impl Iterator<Item = f64>) -> f64 {
    let ends = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], v| {
        [least.min(v), most.max(v)]
    });
    ends[1] - ends[0]
}
