//! An estimate of the verdict on a raceway from closed forms, without simulating.

use super::search::SPREAD_MIN;
use super::{Eq11, steady_gap_rad, theoretical_gap_rad};
use crate::case::Case;
use crate::contact::hertz::STRESS_LIMIT_PA;
use crate::equilibrium::Equilibrium;
use crate::kinematics::{rolling_orbit_speed_rad_s, rolling_spin_rad_s};
use crate::raceway::Raceway;

/// One term of an estimate, a dimensionless value against its limit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EstimateTerm {
    /// Name in files.
    pub name: &'static str,
    /// Meaning of the value.
    pub meaning: &'static str,
    /// The value.
    pub value: f64,
    /// Limit of the value.
    pub limit: f64,
    /// Whether the limit is the least value, else it is the largest.
    pub at_least: bool,
}

impl EstimateTerm {
    /// Distance from the limit as a fraction of it, negative beyond it.
    pub fn margin(&self) -> f64 {
        let excess = (self.value - self.limit) / self.limit;
        if self.at_least { excess } else { -excess }
    }
}

/// What rolling balls in static equilibrium say about the raceways of a case. The motion of all
/// balls, which decides, is not looked at: see [`super::judge`].
#[derive(Debug, Clone, PartialEq)]
pub struct Estimate {
    terms: Vec<EstimateTerm>,
}

/// Largest friction demand of an estimate. Balls may slide for a moment: of the ten structures of
/// Zhao 2022, in the `physical` profile, those that pass stay below 1.40 and those that slip
/// begin at 1.51.
const FRICTION_DEMAND_MAX: f64 = 1.45;
/// Largest 2θ of an estimate over the angle of three evenly spaced balls. Of the same structures
/// those that pass stay below 1.07, those hit from both sides begin at 1.18.
const LENGTH_MAX: f64 = 1.12;
/// Points over half a raceway at which the friction demand is evaluated.
const POINTS: usize = 48;

impl Estimate {
    /// Estimate for a case and its static equilibrium; of several raceways, the worst of each
    /// term. Without a discrete raceway only the contact stress remains.
    pub fn new(case: &Case, equilibrium: &Equilibrium) -> Self {
        let bearing = &case.bearing;
        let mut terms = vec![];
        if !case.raceways.is_empty() {
            let largest = |value: &dyn Fn(&Raceway) -> f64| {
                case.raceways.iter().map(value).fold(0.0, f64::max)
            };
            let steady = steady_gap_rad(bearing, &case.raceways);
            let three = 2.0 * (bearing.ball_angle_rad() + bearing.nominal_gap_rad());
            terms.push(EstimateTerm {
                name: "separation",
                meaning: "β0 of Eq. (11) over the gap outside the raceways",
                value: largest(&|r| theoretical_gap_rad(bearing, r, Eq11::Published) / steady),
                limit: SPREAD_MIN,
                at_least: true,
            });
            terms.push(EstimateTerm {
                name: "sliding",
                meaning: "friction that rolling through the raceway demands over that available",
                value: largest(&|r| friction_demand(case, equilibrium, r)),
                limit: FRICTION_DEMAND_MAX,
                at_least: false,
            });
            terms.push(EstimateTerm {
                name: "both-neighbours",
                meaning: "2θ over the angle of three evenly spaced balls",
                value: largest(&|r| 2.0 * r.half_angle_rad() / three),
                limit: LENGTH_MAX,
                at_least: false,
            });
        }
        terms.push(EstimateTerm {
            name: "stress",
            meaning: "contact stress at rest over the 4.2 GPa of ISO 76",
            value: equilibrium
                .inner_stress_max_pa
                .max(equilibrium.outer_stress_max_pa)
                / STRESS_LIMIT_PA,
            limit: 1.0,
            at_least: false,
        });
        Self { terms }
    }

    /// The terms.
    pub fn terms(&self) -> &[EstimateTerm] {
        &self.terms
    }

    /// Whether every term keeps its limit. A value that is not a number keeps none.
    pub fn passes(&self) -> bool {
        self.terms.iter().all(|t| t.margin() >= 0.0)
    }
}

/// Largest Ti/(μ·Fi) and To/(μ·Fo) of a ball that rolls into the raceway without slip at
/// Ω(r(ψ)): m·Rm·dΩ/dt = Ti − To along the orbit and J·dω/dt = (Ti + To)·Rw in spin, with the
/// normal forces of the equilibrium at ψ.
fn friction_demand(case: &Case, equilibrium: &Equilibrium, raceway: &Raceway) -> f64 {
    let bearing = &case.bearing;
    let friction = case.contact.friction_coefficient_max();
    let outer_factor = case.contact.outer_friction_factor;
    let speed = case.operation.inner_speed_rad_s;
    let centre = raceway.dimensions().centre_angle_rad;
    let theta = raceway.half_angle_rad();
    let orbit =
        |psi: f64| rolling_orbit_speed_rad_s(bearing, speed, raceway.effective_radius_m(psi));
    let spin = |psi: f64| rolling_spin_rad_s(bearing, orbit(psi), raceway.effective_radius_m(psi));
    let h = theta / (2.0 * POINTS as f64);
    let demand = |k: usize| {
        let psi = centre - theta * (k as f64 + 0.5) / POINTS as f64;
        let rate = |f: &dyn Fn(f64) -> f64| (f(psi + h) - f(psi - h)) / (2.0 * h) * orbit(psi);
        let along = bearing.ball_mass_kg() * bearing.pitch_radius_m() * rate(&orbit);
        let turning = bearing.ball_inertia_kg_m2() * rate(&spin) / bearing.ball_radius_m();
        let [inner_force, outer_force] = forces_n(equilibrium, psi);
        let over = |tangential: f64, normal: f64| tangential.abs() / (friction * normal).max(1e-12);
        let inner = over(0.5 * (turning + along), inner_force);
        inner.max(over(0.5 * (turning - along), outer_factor * outer_force))
    };
    (0..POINTS).map(demand).fold(0.0, f64::max)
}

/// Fi and Fo at ψ, linear between the two nearest balls of the equilibrium.
fn forces_n(equilibrium: &Equilibrium, angle_rad: f64) -> [f64; 2] {
    let angles = &equilibrium.ball_angle_rad;
    let n = angles.len();
    let turn = std::f64::consts::TAU;
    let ahead = |k: usize| (angle_rad - angles[k]).rem_euclid(turn);
    let behind = (0..n)
        .min_by(|&a, &b| ahead(a).total_cmp(&ahead(b)))
        .unwrap_or(0);
    let next = (behind + 1) % n;
    let pitch = (angles[next] - angles[behind]).rem_euclid(turn);
    let part = if pitch > 0.0 {
        ahead(behind) / pitch
    } else {
        0.0
    };
    [&equilibrium.inner_force_n, &equilibrium.outer_force_n]
        .map(|f| f[behind] + (f[next] - f[behind]) * part)
}
