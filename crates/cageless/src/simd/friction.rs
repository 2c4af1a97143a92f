//! Friction and sliding of contacts, lane by lane.

use super::parameters::Parameters;
use super::workspace::BlockResults;
use crate::contact::{
    AtKnees, AtRaceways, EvaluatedLaws, FilmTractionLanes, Law, LawLanes, with_law,
};
use crate::numerics::lanes::{LANES, Lanes, larger};

/// Friction of one contact of each lane by the law of the case.
#[inline(always)]
pub(super) fn friction(p: &Parameters, slip: &Lanes, normal: &Lanes, force: &mut Lanes) {
    with_law!(&p.friction, law => friction_by(law, slip, normal, force));
}

/// Friction of the balls of a block at both raceways, from their sliding speeds.
#[inline(always)]
pub(super) fn both_raceways(p: &Parameters, results: &mut BlockResults) {
    let (outer, inner) = (&results.outer, &results.inner);
    let [outer_knees, inner_knees] = &results.inverse_knees;
    let [outer_films, inner_films] = &results.film_tractions;
    let at_outer = SlidingContacts {
        slip: &outer.slip,
        normal: &outer.friction_normal,
        knees: outer_knees,
        films: outer_films,
    };
    let at_inner = SlidingContacts {
        slip: &inner.slip,
        normal: &inner.force,
        knees: inner_knees,
        films: inner_films,
    };
    for (contacts, force) in [
        (at_outer, &mut results.outer_friction),
        (at_inner, &mut results.inner_friction),
    ] {
        with_law!(&p.friction, law => friction_at(law, contacts, force));
    }
}

/// Contacts of the balls of a block with a raceway, which slide.
#[derive(Clone, Copy)]
struct SlidingContacts<'a> {
    /// ΔV, m/s.
    slip: &'a Lanes,
    /// Force under which friction acts, N.
    normal: &'a Lanes,
    /// 1/v_s of the law, s/m.
    knees: &'a Lanes,
    films: &'a FilmTractionLanes,
}

#[inline(always)]
fn friction_at<L: LawLanes>(law: &L, contacts: SlidingContacts<'_>, force: &mut Lanes) {
    let SlidingContacts {
        slip,
        normal,
        knees,
        films,
    } = contacts;
    let law = law.evaluated([slip, slip]);
    for lane in 0..LANES {
        let law = law.lane(lane);
        let dry = law.force_with_knee(slip.0[lane], normal.0[lane], knees.0[lane]);
        [force.0[lane], _] = match L::Constants::MIXES {
            true => films.get(lane).mixed(dry, slip.0[lane]),
            false => dry,
        };
    }
}

#[inline(always)]
fn friction_by(law: &impl LawLanes, slip: &Lanes, normal: &Lanes, force: &mut Lanes) {
    let law = law.evaluated([slip, slip]);
    for lane in 0..LANES {
        [force.0[lane], _] = law.lane(lane).force(slip.0[lane], normal.0[lane]);
    }
}

/// The law of a lane at its contacts with the raceways.
#[inline(always)]
pub(super) fn at_raceways<L>(law: L, results: &BlockResults, lane: usize) -> AtRaceways<L> {
    let [outer, inner] = &results.inverse_knees;
    let inverse_knees = [outer.0[lane], inner.0[lane]];
    AtRaceways {
        law: AtKnees { law, inverse_knees },
        films: [0, 1].map(|k| results.film_tractions[k].get(lane)),
    }
}

/// Largest |ΔV| at contacts that carry load.
#[inline(always)]
pub(super) fn loaded_slips(results: &BlockResults, largest: &mut Lanes) {
    for lane in 0..LANES {
        let loaded = |slip: f64, force: f64| if force > 0.0 { slip.abs() } else { 0.0 };
        let inner = loaded(results.inner.slip.0[lane], results.inner.force.0[lane]);
        let outer = loaded(results.outer.slip.0[lane], results.outer.force.0[lane]);
        largest.0[lane] = larger(largest.0[lane], larger(inner, outer));
    }
}
