//! Knees of the law at the contacts with the raceways, from the creep of rolling contacts, lane by lane.
//!
//! V is the mean speed of both surfaces relative to the contact, as that of a film.

use super::motions::Motions;
use super::parameters::Parameters;
use super::workspace::BlockResults;
use crate::ball::{BallLanes, BallMotion, PolarMotion};
use crate::contact::CreepLanes;
use crate::contact::creep::inverse_speed_s_m;
use crate::numerics::lanes::LANES;

/// Sets the knees of a block from the loads of its contacts; flanks are rigid.
#[inline(always)]
pub(super) fn set_knees(
    p: &Parameters,
    creep: &CreepLanes,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
) {
    for lane in 0..LANES {
        let (ball, radius) = (
            balls.radius.0[lane],
            results.geometry.effective_radius.0[lane],
        );
        let share = if radius < ball { 0.5 } else { 1.0 };
        let load = share * results.outer.friction_normal.0[lane];
        let polar = results.polar.get(lane);
        let doubled = twice_rolling_m_s(&polar, motions.get(lane).spin, radius);
        results.inverse_knees[0].0[lane] =
            inverse_speed_s_m(creep.outer.0[lane], load, doubled, 2.0);
    }
    for lane in 0..LANES {
        let place = InnerRolling::of_lane(balls, results, &motions, lane);
        let (distance, scaled) = (place.distance, place.scaled_m2_s(p, lane));
        results.inverse_knees[1].0[lane] = inverse_speed_s_m(
            creep.inner.0[lane],
            results.inner.force.0[lane],
            scaled,
            2.0 * distance,
        );
    }
}

/// Rolling of a ball on the inner raceway.
pub(super) struct InnerRolling {
    radius: f64,
    spin: f64,
    /// ΔVi.
    slip: f64,
    /// q.
    pub distance: f64,
}

impl InnerRolling {
    /// Rolling of a ball of a block on the inner raceway.
    #[inline(always)]
    pub(super) fn of_lane(
        balls: &BallLanes,
        results: &BlockResults,
        motions: &Motions<'_>,
        lane: usize,
    ) -> Self {
        Self {
            radius: balls.radius.0[lane],
            spin: motions.get(lane).spin,
            slip: results.inner.slip.0[lane],
            distance: balls.inner_contact_distance.0[lane] - results.inner.deflection.0[lane],
        }
    }

    /// 2u q: ΔVi = ωi Ri − (vt + ω R), 2u = ωi Ri + ω R − vt (Ri − R)/q.
    #[inline(always)]
    pub(super) fn scaled_m2_s(&self, p: &Parameters, lane: usize) -> f64 {
        let (surface, spun) = (p.inner.surface_speed.0[lane], self.spin * self.radius);
        let tangential = surface - self.slip - spun;
        let across = (surface + spun) * self.distance;
        across - tangential * (p.inner.radius.0[lane] - self.radius)
    }
}

/// 2u = vt (ρ + 2r)/ρ + ω r at the outer raceway.
#[inline(always)]
pub(super) fn twice_rolling_m_s(polar: &PolarMotion, spin_rad_s: f64, radius_m: f64) -> f64 {
    polar.tangential + (2.0 * polar.orbit + spin_rad_s) * radius_m
}

/// Sets the knee of a ball on elastic flanks from the load of one of them.
#[inline(always)]
pub(super) fn set_knee_on_flanks(
    creep: &CreepLanes,
    results: &mut BlockResults,
    motion: &BallMotion,
    lane: usize,
) {
    let radius = results.geometry.effective_radius.0[lane];
    let doubled = twice_rolling_m_s(&results.polar.get(lane), motion.spin, radius);
    let load = 0.5 * results.outer.friction_normal.0[lane];
    results.inverse_knees[0].0[lane] = inverse_speed_s_m(creep.outer.0[lane], load, doubled, 2.0);
}
