//! Friction that rolling through a raceway demands.

use std::ops::Range;

use crate::ball::BothContacts;
use crate::case::Case;
use crate::equilibrium::Equilibrium;
use crate::film::{LubricatedContact, MixedFriction, Rolling};
use crate::kinematics::{rolling_orbit_speed_rad_s, rolling_rotation_rad_s};
use crate::raceway::Raceway;

/// Points over each smooth stretch of half a raceway at which the demand is evaluated.
const POINTS: usize = 48;

/// Largest Ti/(μ·Fi) and To/(μ·Fo) of a ball that rolls into the raceway without slip at
/// Ω(r(ψ)): m·Rm·dΩ/dt = Ti − To along the orbit and J·dω/dt = (Ti + To)·Rw in spin, with the
/// normal forces of the equilibrium at ψ; where the film is the friction, μ is that of each contact.
pub fn friction_demand(case: &Case, equilibrium: &Equilibrium, raceway: &Raceway) -> f64 {
    let bearing = &case.bearing;
    let available = AvailableFriction::new(case);
    let speed = case.operation.inner_speed_rad_s;
    let centre = raceway.dimensions().centre_angle_rad;
    let orbit =
        |psi: f64| rolling_orbit_speed_rad_s(bearing, speed, raceway.effective_radius_m(psi));
    let spin =
        |psi: f64| rolling_rotation_rad_s(bearing, orbit(psi), raceway.effective_radius_m(psi));
    let demand = |Range { start, end }: Range<f64>, k: usize| {
        let h = (end - start) / (2.0 * POINTS as f64);
        let psi = centre - (start + (end - start) * (k as f64 + 0.5) / POINTS as f64);
        let rate = |f: &dyn Fn(f64) -> f64| (f(psi + h) - f(psi - h)) / (2.0 * h) * orbit(psi);
        let along = bearing.ball_mass_kg() * bearing.pitch_radius_m() * rate(&orbit);
        let turning = bearing.ball_inertia_kg_m2() * rate(&spin) / bearing.ball_radius_m();
        let rolling = RollingThrough {
            radius_m: raceway.effective_radius_m(psi),
            orbit_rad_s: orbit(psi),
            spin_rad_s: spin(psi),
        };
        let friction_n = available.at(forces_n(equilibrium, psi), &rolling);
        let over = |tangential: f64, largest: f64| tangential.abs() / largest.max(1e-12);
        let inner = over(0.5 * (turning + along), friction_n.inner);
        inner.max(over(0.5 * (turning - along), friction_n.outer))
    };
    let pieces = raceway.pieces().iter().map(|piece| piece.range_rad());
    let demands = pieces.flat_map(|range| (0..POINTS).map(move |k| (range.clone(), k)));
    demands
        .map(|(range, k)| demand(range, k))
        .fold(0.0, f64::max)
}

/// Ball that rolls through a raceway without slip.
struct RollingThrough {
    /// r.
    radius_m: f64,
    orbit_rad_s: f64,
    spin_rad_s: f64,
}

/// Largest friction at the raceways.
struct AvailableFriction<'a> {
    case: &'a Case,
    /// Where the film is the friction.
    mixed: Option<MixedFriction<'a>>,
}

impl<'a> AvailableFriction<'a> {
    fn new(case: &'a Case) -> Self {
        Self {
            case,
            mixed: MixedFriction::new(case),
        }
    }

    /// Friction at the raceways under these forces there, N.
    fn at(&self, forces_n: BothContacts, rolling: &RollingThrough) -> BothContacts {
        match &self.mixed {
            Some(mixed) => self.mixed(forces_n, rolling, mixed),
            None => {
                let contact = &self.case.contact;
                let friction = contact.friction_law.coefficient_max(&contact.friction);
                BothContacts {
                    outer: friction * (contact.outer_friction_factor * forces_n.outer),
                    inner: friction * forces_n.inner,
                }
            }
        }
    }

    /// [`Self::at`] of film and asperities; on a raceway both flanks bear.
    fn mixed(
        &self,
        forces_n: BothContacts,
        rolling: &RollingThrough,
        mixed: &MixedFriction<'_>,
    ) -> BothContacts {
        let bearing = &self.case.bearing;
        let (ball_m, orbit_m) = (bearing.ball_radius_m(), bearing.pitch_radius_m());
        let groove_m = bearing.dimensions().inner_groove_bottom_radius_m;
        let RollingThrough {
            radius_m,
            orbit_rad_s,
            spin_rad_s,
        } = *rolling;
        let flanks = if radius_m < ball_m { 2.0 } else { 1.0 };
        let at_outer = Rolling {
            load_n: forces_n.outer * ball_m / (radius_m * flanks),
            speed_m_s: 0.5 * (orbit_rad_s * (orbit_m + 2.0 * radius_m) + spin_rad_s * radius_m),
        };
        // The surfaces of ring and ball, less twice that of the contact.
        let surface_m_s = self.case.operation.inner_speed_rad_s * groove_m;
        let carried_m_s = orbit_rad_s * (groove_m - ball_m);
        let at_inner = Rolling {
            load_n: forces_n.inner,
            speed_m_s: 0.5 * (surface_m_s + spin_rad_s * ball_m - carried_m_s),
        };
        let flank = LubricatedContact::outer(bearing, radius_m / ball_m);
        BothContacts {
            // Over the force of the raceway, as that of the law.
            outer: flanks * mixed.outer_n(&flank, at_outer) * (radius_m / ball_m),
            inner: mixed.inner_n(&LubricatedContact::inner(bearing), at_inner),
        }
    }
}

/// Fi and Fo at ψ, linear between the two nearest balls of the equilibrium.
fn forces_n(equilibrium: &Equilibrium, angle_rad: f64) -> BothContacts {
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
    let at = |f: &[f64]| f[behind] + (f[next] - f[behind]) * part;
    BothContacts {
        outer: at(&equilibrium.outer_force_n),
        inner: at(&equilibrium.inner_force_n),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::common::{conventional, dimensions, structure};
    use crate::equilibrium;

    /// The demand by difference quotients of the whole motion, not at the points of the estimate:
    /// m·Rm·dΩ/dt and J·dω/dt of a ball that rolls at Ω(r(ψ)), shared by Ti and To.
    #[test]
    fn friction_demand_is_that_of_the_rolling_ball() {
        for (span, angle) in [(5.1, 25.2), (5.6, 15.774)] {
            let case = structure(span, angle);
            let e = equilibrium::solve(&case).unwrap();
            let raceway = &case.raceways[0];
            let (rw, rm) = (4.7625e-3, (18.24e-3 + 27.765e-3) / 2.0);
            let mass = 7850.0 * 4.0 / 3.0 * std::f64::consts::PI * rw * rw * rw;
            let speeds = |psi: f64| {
                let r = raceway.effective_radius_m(psi);
                let orbit =
                    case.operation.inner_speed_rad_s * 18.24e-3 / rm * (1.0 - rw / (r + rw));
                [orbit, orbit * rm / r]
            };
            let mut largest = 0.0f64;
            for k in 1..2000 {
                let psi = -angle.to_radians() * f64::from(k) / 2000.0;
                let h = 1e-6;
                let (before, after) = (speeds(psi - h), speeds(psi + h));
                let rate = |n: usize| (after[n] - before[n]) / (2.0 * h) * speeds(psi)[0];
                let sum = 0.4 * mass * rw * rate(1);
                let difference = mass * rm * rate(0);
                let BothContacts { outer, inner } = forces_n(&e, psi);
                let ti = (0.5 * (sum + difference)).abs() / (0.007 * inner);
                let to = (0.5 * (sum - difference)).abs() / (0.007 * outer);
                largest = largest.max(ti).max(to);
            }
            let found = friction_demand(&case, &e, raceway);
            assert!(
                (found / largest - 1.0).abs() < 0.01,
                "{span}: {found} {largest}"
            );
        }
    }

    #[test]
    fn forces_are_linear_between_the_balls() {
        let mut e = equilibrium::solve(&conventional(dimensions())).unwrap();
        e.ball_angle_rad = vec![0.0, 1.0, 3.0];
        (e.inner_force_n, e.outer_force_n) = (vec![10.0, 20.0, 40.0], vec![1.0, 2.0, 4.0]);
        let turn = std::f64::consts::TAU;
        let last = 3.0 + 0.5 * (turn - 3.0);
        for (angle, inner) in [
            (0.0, 10.0),
            (0.5, 15.0),
            (2.5, 35.0),
            (last, 25.0),
            (0.5 - turn, 15.0),
        ] {
            let BothContacts {
                outer,
                inner: found,
            } = forces_n(&e, angle);
            assert!(
                (found - inner).abs() < 1e-9 && (outer - inner / 10.0).abs() < 1e-9,
                "{angle}: {found}"
            );
        }
    }
}
