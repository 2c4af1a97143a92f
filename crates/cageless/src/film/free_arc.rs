//! Loss of speed to the film of a ball on the outer raceway alone.
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
pub(crate) struct FreeArc {
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
        let film = &self.film;
        self.brake_by_n(speed_m_s, |at| film.rolling_force_n(&self.contact, at))
    }

    /// [`Self::brake_n`] by a rolling force.
    fn brake_by_n(&self, speed_m_s: f64, force_n: impl Fn(Rolling) -> f64) -> f64 {
        let rolling = Rolling {
            load_n: self.load_n(speed_m_s),
            speed_m_s: self.speed_ratio * speed_m_s,
        };
        2.0 * force_n(rolling) * self.speed_ratio
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

#[cfg(test)]
mod tests {
    use super::super::Oil;
    use super::super::rolling_force::RollingForce;
    use super::*;
    use crate::reference;

    /// Speed at the start, m/s, and time of coasting, s.
    const START: f64 = 11.0;
    const TIME_S: f64 = 10e-3;

    /// Ball in 5 mPa·s under either limit of the force: its rate at the start, m/s², and its speed after a time.
    fn coasting(load_n: Option<f64>, limit: fn(&RollingForce) -> f64, time_s: f64) -> (f64, f64) {
        let film = Film::flooded(Oil::mineral(5e-3, 0.035));
        let ball = FreeBall {
            load_n,
            ..FreeBall::new(&reference::bearing(), &film)
        };
        let rate = |v: f64| {
            let force = |at: Rolling| limit(&ball.contact.rolling_force(&film.oil, at));
            -ball.brake_by_n(v, force) / (ROLLING_MASS * ball.mass_kg)
        };
        let [end, _] = integrated([START, 0.0], time_s, |[v, _]| [rate(v), 0.0]);
        (rate(START), end)
    }

    /// With dv/dt = −A vⁿ, v^(1−n) falls by (1 − n) A t: n = 2/3 and 3/4 under a held load, 4/3 and 17/12 under
    /// Q = m v²/ρ.
    #[test]
    fn either_limit_of_the_force_has_a_closed_form() {
        let rigid: fn(&RollingForce) -> f64 = |force| force.rigid_n;
        let elastic: fn(&RollingForce) -> f64 = |force| force.elastohydrodynamic_n;
        for (load_n, limit, exponent, expected) in [
            (Some(20.0), rigid, 2.0 / 3.0, 10.436815),
            (Some(20.0), elastic, 0.75, 10.747679),
            (None, rigid, 4.0 / 3.0, 10.458271),
            (None, elastic, 17.0 / 12.0, 10.755120),
        ] {
            let (rate, end) = coasting(load_n, limit, TIME_S);
            let rest: f64 = 1.0 - exponent;
            let closed = START * (1.0 + rest * rate * TIME_S / START).powf(1.0 / rest);
            assert!(
                (closed - expected).abs() < 1e-6,
                "{closed}, expected {expected}"
            );
            assert!((end - closed).abs() < 1e-9, "{end}, expected {closed}");
        }
    }

    /// The elastohydrodynamic contact stops a ball under 20 N; after half of that time it has a sixteenth of its speed.
    #[test]
    fn standstill_under_a_held_load() {
        let limit = |force: &RollingForce| force.elastohydrodynamic_n;
        let stop_s = -4.0 * START / coasting(Some(20.0), limit, TIME_S).0;
        assert!((stop_s - 1.7287).abs() < 5e-5, "{stop_s}");
        let (_, half) = coasting(Some(20.0), limit, 0.5 * stop_s);
        assert!((16.0 * half / START - 1.0).abs() < 1e-9, "{half}");
    }
}
