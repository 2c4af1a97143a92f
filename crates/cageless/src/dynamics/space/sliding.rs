//! The motion of outer rings that slide in their housing along the axis, each pushed by the preload spring of
//! its row.
//!
//! With F of its balls, P of the spring and the place zh of the housing,
//!
//!   m z̈ = F − σP − c(ż − żh),
//!
//! the spring so soft that its force stays the same; the housing has the reaction. The functions are compiled
//! once for all instruction sets, and cold: runs without springs pass them by. They take the bearing with references, as
//! a layout whose address is taken slows the loops around them.

use super::bearing::Bearing;
use super::block::{INNER, SpaceBlock};
use super::model::SpaceModel;
use super::workspace::SpaceWorkspace;
use crate::ball::AxialMotion;
use crate::dynamics::coordinates::{OuterRingCoordinate, SlidingCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::dynamics::layout::Layout;
use crate::numerics::lanes::LANES;
use crate::world::body::sliding_ring::SlidingWork;
use crate::world::step_change::StepChange;

/// Motion of ring `k` that slides, in a vector.
fn motion(layout: Layout, y: &[f64], k: usize) -> AxialMotion {
    AxialMotion {
        z: y[layout.sliding(SlidingCoordinate::Z, k)],
        vz: y[layout.sliding(SlidingCoordinate::Vz, k)],
    }
}

/// Calls with every ring that slides, from 0, and each lane of a block that has a ball of its row.
fn each_lane(space: &SpaceModel, layout: Layout, block: usize, mut call: impl FnMut(usize, usize)) {
    let first = block * LANES;
    for (k, ring) in space.sliding.iter().enumerate() {
        let [begin, end] = [ring.row, ring.row + 1].map(|row| row * layout.row);
        for ball in begin.max(first)..end.min(first + LANES) {
            call(k, ball - first);
        }
    }
}

/// Lets balls at rest slide on these rings as fast as those move in the housing, at the start (0) or the
/// end (1) of the step.
fn slide_with(
    space: &SpaceModel,
    layout: Layout,
    b: &mut SpaceBlock,
    block: usize,
    end: usize,
    speed: impl Fn(usize) -> f64,
) {
    for &place in b.places.iter().filter(|place| **place != INNER) {
        let (frames, sliding) = (&b.frames[place], &mut b.at_rest[end][place]);
        each_lane(space, layout, block, |k, lane| {
            let moving = [0.0, 0.0, speed(k)];
            let more = frames.get(lane).sliding_at_rest(moving, [0.0; 3]);
            sliding.along.0[lane] += more.along;
            sliding.across.0[lane] += more.across;
        });
    }
}

/// [`slide_with`] at the speeds of the last evaluation.
#[cold]
#[inline(never)]
pub(super) fn slide_as_evaluated(
    bearing: Bearing<'_>,
    b: &mut SpaceBlock,
    block: usize,
    end: usize,
    work: &[SlidingWork],
) {
    let layout = bearing.parameters.layout;
    slide_with(bearing.space, layout, b, block, end, |k| work[k].speed);
}

/// [`slide_with`] at the speeds of a vector.
#[cold]
#[inline(never)]
pub(super) fn slide_as_in(
    bearing: Bearing<'_>,
    b: &mut SpaceBlock,
    block: usize,
    end: usize,
    y: &[f64],
) {
    let (space, layout) = (bearing.space, bearing.parameters.layout);
    let housing = layout.outer_ring_along_axis(y);
    slide_with(space, layout, b, block, end, |k| {
        motion(layout, y, k).vz - housing.vz
    });
}

/// Puts the rings that slide, with their grooves, where they are in a vector, at their speeds there.
#[cold]
#[inline(never)]
pub(super) fn place_rings(bearing: Bearing<'_>, s: &mut SpaceWorkspace, y: &[f64]) {
    let (space, layout) = (bearing.space, bearing.parameters.layout);
    let housing = layout.outer_ring_along_axis(y);
    for (k, work) in s.sliding.iter_mut().enumerate() {
        work.speed = motion(layout, y, k).vz - housing.vz;
    }
    for (block, b) in s.blocks.iter_mut().enumerate() {
        each_lane(space, layout, block, |k, lane| {
            let held = space.balls[block * LANES + lane].outer.axial;
            b.outer_groove.axial.0[lane] = held + (motion(layout, y, k).z - housing.z);
            b.sliding_speed.0[lane] = s.sliding[k].speed;
        });
    }
}

/// Sets the rates of the rings that slide and adds their reaction to those of the housing, and their
/// heat.
#[cold]
#[inline(never)]
pub(super) fn sliding_rates(
    bearing: Bearing<'_>,
    s: &mut SpaceWorkspace,
    y: &[f64],
    dydt: &mut [f64],
) {
    let Bearing { model, space, .. } = bearing;
    let layout = bearing.parameters.layout;
    for (k, ring) in space.sliding.iter().enumerate() {
        let (force_n, speed) = (s.row_force_n(layout, ring.row), s.sliding[k].speed);
        s.sliding[k].force_n = force_n;
        let force = force_n + ring.spring_n - ring.damping * speed;
        dydt[layout.sliding(SlidingCoordinate::Z, k)] = motion(layout, y, k).vz;
        dydt[layout.sliding(SlidingCoordinate::Vz, k)] = force / ring.mass;
        // The balls of the row push its ring, and the spring and the damper the housing.
        let housing = layout.at(dydt, OuterRingCoordinate::Vz);
        let pulled = force * model.outer_ring.axial_inverse_mass;
        layout.set(dydt, OuterRingCoordinate::Vz, housing - pulled);
        dydt[layout.energy_term(EnergyTerm::Drag)] += ring.damping * speed * speed;
    }
}

/// Adds to the state and the rates what the friction of the balls does to the rings that slide over the
/// step.
#[cold]
#[inline(never)]
pub(super) fn add_sliding_friction(
    bearing: Bearing<'_>,
    s: &SpaceWorkspace,
    change: &mut StepChange<'_>,
) {
    let Bearing { model, space, .. } = bearing;
    let layout = bearing.parameters.layout;
    for (k, (ring, work)) in space.sliding.iter().zip(&s.sliding).enumerate() {
        let friction = s.row_force_n(layout, ring.row) - work.force_n;
        let place = layout.sliding(SlidingCoordinate::Vz, k);
        change.add_at(place, friction / ring.mass);
        let inverse_mass = model.outer_ring.axial_inverse_mass;
        change.add(OuterRingCoordinate::Vz, -friction * inverse_mass);
    }
}

/// Kinetic energy of the rings that slide, and what their springs store: less the further they are
/// pushed, J.
pub(super) fn sliding_energy_j(space: &SpaceModel, layout: Layout, y: &[f64]) -> f64 {
    let housing = layout.outer_ring_along_axis(y);
    let rings = space.sliding.iter().enumerate();
    rings
        .map(|(k, ring)| {
            let AxialMotion { z, vz } = motion(layout, y, k);
            0.5 * ring.mass * vz * vz - ring.spring_n * (z - housing.z)
        })
        .sum()
}

/// z of the outer ring of the row of ball `k`, from where the case places it, m.
pub(crate) fn outer_z_m(space: &SpaceModel, layout: Layout, y: &[f64], k: usize) -> f64 {
    let own = space
        .sliding
        .iter()
        .position(|ring| ring.row == k / layout.row);
    match own {
        Some(ring) => motion(layout, y, ring).z,
        None => layout.outer_ring_along_axis(y).z,
    }
}
