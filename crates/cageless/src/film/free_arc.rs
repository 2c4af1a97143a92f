//! What the film takes from a ball that the outer raceway alone carries.
//!
//! The ball rolls on the plain outer raceway under its centrifugal force, Q = m v²/ρ, and
//!
//!   1.4 m dv/dt = −2 F_R u/v,   u = v Ro/(Ro − Rw).

use super::Film;
use super::contact::LubricatedContact;
use super::rolling_force::Rolling;
use crate::bearing::Bearing;

/// Steps over an arc.
const STEPS: usize = 400;
/// Speed over that at the start at which a ball has stopped.
const STANDSTILL: f64 = 1e-5;
/// Mass of a rolling ball over its own.
const ROLLING_MASS: f64 = 1.4;

/// Ball that rolls on the plain outer raceway alone.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FreeBall {
    film: Film,
    contact: LubricatedContact,
    mass_kg: f64,
    orbit_radius_m: f64,
    /// Ro/(Ro − Rw).
    speed_ratio: f64,
    load_n: Option<f64>,
}

/// Motion of a free ball over an arc.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct FreeArc {
    /// Angle by which it falls behind one that keeps its speed.
    pub lag_rad: f64,
    /// Share of its speed that it loses; 1 of a ball that stops.
    pub speed_deficit: f64,
}

impl FreeBall {
    /// A nominal ball of a bearing under its centrifugal force.
    pub(crate) fn new(bearing: &Bearing, film: &Film) -> Self {
        let orbit_radius_m = bearing.outer_orbit_radius_m();
        let groove_m = bearing.dimensions().outer_groove_bottom_radius_m;
        Self {
            film: *film,
            contact: LubricatedContact::outer(bearing, 1.0),
            mass_kg: bearing.ball_mass_kg(),
            orbit_radius_m,
            speed_ratio: groove_m / orbit_radius_m,
            load_n: None,
        }
    }

    /// This ball under a constant load in N, in place of its centrifugal force.
    #[cfg(test)]
    pub(crate) fn under(self, load_n: f64) -> Self {
        Self {
            load_n: Some(load_n),
            ..self
        }
    }

    /// Q at an orbital speed, N.
    pub(crate) fn load_n(&self, speed_m_s: f64) -> f64 {
        let centrifugal_n = self.mass_kg * speed_m_s.powi(2) / self.orbit_radius_m;
        self.load_n.unwrap_or(centrifugal_n)
    }

    /// Force that brakes the orbit, 2 F_R u/v, N.
    pub(crate) fn brake_n(&self, speed_m_s: f64) -> f64 {
        let rolling = Rolling {
            load_n: self.load_n(speed_m_s),
            speed_m_s: self.speed_ratio * speed_m_s,
        };
        2.0 * self.film.rolling_force_n(&self.contact, rolling) * self.speed_ratio
    }

    /// dv/dt, m/s².
    fn acceleration_m_s2(&self, speed_m_s: f64) -> f64 {
        -self.brake_n(speed_m_s) / (ROLLING_MASS * self.mass_kg)
    }

    /// Speed after a time, m/s.
    #[cfg(test)]
    pub(crate) fn speed_after_m_s(&self, speed_m_s: f64, time_s: f64) -> f64 {
        let rate = |v: f64| [self.acceleration_m_s2(v), 0.0];
        let end = integrated([speed_m_s, 0.0], time_s, |[v, _]| rate(v));
        end[0]
    }

    /// Motion over an arc, rad, that it enters at a speed.
    pub(crate) fn over(&self, arc_rad: f64, speed_m_s: f64) -> FreeArc {
        // dv/dψ = ρ v̇/v, and the lag of Ω₀ t behind ψ.
        let rate = |v: f64| match v > STANDSTILL * speed_m_s {
            true => [
                self.acceleration_m_s2(v) * self.orbit_radius_m / v,
                speed_m_s / v - 1.0,
            ],
            false => [0.0, f64::INFINITY],
        };
        let [end_m_s, lag_rad] = integrated([speed_m_s, 0.0], arc_rad, |[v, _]| rate(v));
        match lag_rad.is_finite() && end_m_s > 0.0 {
            true => FreeArc {
                lag_rad,
                speed_deficit: 1.0 - end_m_s / speed_m_s,
            },
            false => FreeArc {
                lag_rad: f64::INFINITY,
                speed_deficit: 1.0,
            },
        }
    }
}

/// Runge–Kutta steps from a start over a span.
fn integrated(start: [f64; 2], span: f64, rate: impl Fn([f64; 2]) -> [f64; 2]) -> [f64; 2] {
    let h = span / STEPS as f64;
    let ahead = |y: [f64; 2], k: [f64; 2], part: f64| [y[0] + part * k[0], y[1] + part * k[1]];
    (0..STEPS).fold(start, |y, _| {
        let k1 = rate(y);
        let k2 = rate(ahead(y, k1, h / 2.0));
        let k3 = rate(ahead(y, k2, h / 2.0));
        let k4 = rate(ahead(y, k3, h));
        [0, 1].map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]))
    })
}
