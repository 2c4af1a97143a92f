//! Films of the contacts with the raceways as friction has them, lane by lane.
//!
//! Set with the knees of the law, from the loads and the rolling of the contacts; frozen over an implicit step.

use super::creep::{InnerRolling, twice_rolling_m_s};
use super::motions::Motions;
use super::parameters::Parameters;
use super::workspace::BlockResults;
use crate::ball::{BallLanes, BallMotion};
use crate::contact::FilmTraction;
use crate::contact::creep::LEAST_SPEED_SQUARE;
use crate::film::{TractionCurve, TractionCurveLanes};
use crate::numerics::lanes::LANES;

/// Sets the films of a block; flanks are rigid.
#[inline(always)]
pub(super) fn set(
    p: &Parameters,
    [at_outer, at_inner]: &[TractionCurveLanes; 2],
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
) {
    for lane in 0..LANES {
        let (ball, radius) = (
            balls.radius.0[lane],
            results.geometry.effective_radius.0[lane],
        );
        let contacts = if radius < ball { 2.0 } else { 1.0 };
        let share = if radius < ball { 0.5 } else { 1.0 };
        let polar = results.polar.get(lane);
        let doubled = twice_rolling_m_s(&polar, motions.get(lane).spin, radius);
        // 1 − cos α and 1/cos α by one division.
        let inverse = 1.0 / (ball * radius);
        let load = share * results.outer.force.0[lane] * (ball * ball * inverse);
        let raised = 1.0 - radius * radius * inverse;
        let one = at_outer.get(lane).at(load, mean_square(doubled), raised);
        results.film_tractions[0].put(lane, of_all(one, contacts));
    }
    for lane in 0..LANES {
        let rolling = InnerRolling::of_lane(balls, results, &motions, lane);
        let doubled = rolling.scaled_m2_s(p, lane) / rolling.distance;
        let load = results.inner.force.0[lane];
        let one = at_inner.get(lane).at(load, mean_square(doubled), 0.0);
        results.film_tractions[1].put(lane, one);
    }
}

/// Sets the film of a ball on elastic flanks from the load of one of them.
#[inline(always)]
pub(super) fn set_on_flanks(
    curve: &TractionCurve,
    ball_radius_m: f64,
    results: &mut BlockResults,
    motion: &BallMotion,
    lane: usize,
) {
    let radius = results.geometry.effective_radius.0[lane];
    let doubled = twice_rolling_m_s(&results.polar.get(lane), motion.spin, radius);
    let raised = 1.0 - radius / ball_radius_m;
    let load = 0.5 * results.flanks.load.0[lane];
    let one = curve.at(load, mean_square(doubled), raised);
    results.film_tractions[0].put(lane, of_all(one, 2.0));
}

/// u² + u₀² of 2u.
#[inline(always)]
fn mean_square(doubled_m_s: f64) -> f64 {
    0.25 * (doubled_m_s * doubled_m_s) + LEAST_SPEED_SQUARE
}

/// Films of all of these contacts.
#[inline(always)]
fn of_all(one: FilmTraction, contacts: f64) -> FilmTraction {
    FilmTraction {
        limit: contacts * one.limit,
        ..one
    }
}
