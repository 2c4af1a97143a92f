//! The balls of a block in space: constants, contacts, and work arrays of their friction.

use super::frame::{FrameLanes, SIZE, of_lane};
use super::inner_groove::{InnerGrooveLanes, InnerTouchLanes};
use super::model::SpaceModel;
use super::outer_groove::{OuterGrooveLanes, OuterTouchLanes};
use super::strips::{SlidingLanes, StripFrictionLanes, StripSlidingLanes};
use crate::contact::FilmTractionLanes;
use crate::dynamics::coordinates::BallCoordinate;
use crate::dynamics::layout::Layout;
use crate::dynamics::model::Model;
use crate::numerics::lanes::{LANES, Lanes, lane_struct};
use crate::simd::block_at;

/// Places of contact of a ball: two at the outer ring, one at the inner ring.
pub(super) const PLACES: usize = 3;
/// The place of contact with the inner ring.
pub(super) const INNER: usize = 2;

/// All places, and those of balls that touch the outer ring at the first alone.
pub(super) const ALL_PLACES: [usize; PLACES] = [0, 1, INNER];
pub(super) const WITHOUT_SECOND: [usize; PLACES - 1] = [0, INNER];

/// Coordinates of the velocities of a ball, **v** and **ω**, with their signs.
pub(super) const VELOCITIES: [(BallCoordinate, f64); SIZE] = [
    (BallCoordinate::Vx, 1.0),
    (BallCoordinate::Vy, 1.0),
    (BallCoordinate::Vz, 1.0),
    (BallCoordinate::OmegaX, 1.0),
    (BallCoordinate::OmegaY, 1.0),
    (BallCoordinate::Spin, -1.0),
];

lane_struct! {
    /// Friction of a strip at the end of a step, or that which changes velocities over it.
    pub(crate) struct KnownStrip per lane KnownStripLanes {
        /// Force on the ball along τ, N.
        along,
        /// Force on the ball along l, N.
        across,
        /// Moment within the strip, N·m.
        moment,
        /// |f|/|s|, N·s/m.
        secant,
    }
}

/// A strip while friction is solved for.
#[derive(Debug, Clone)]
pub(crate) struct StripStep {
    /// Sliding of the last iterate.
    pub sliding: StripSlidingLanes,
    /// Friction of the last iterate.
    pub friction: StripFrictionLanes,
    /// Friction of the end of the step; in the end that which changes velocities.
    pub mean: KnownStripLanes,
}

/// The balls of a block.
#[derive(Debug, Clone)]
pub(crate) struct SpaceBlock {
    /// m and J/R², kg; 1 in padding.
    pub mass: [Lanes; 2],
    /// 1/R, 1/m.
    pub inverse_radius: Lanes,
    /// Where a ring slides its axial place changes.
    pub outer_groove: OuterGrooveLanes,
    pub inner_groove: InnerGrooveLanes,
    /// a of a contact over √δ, m^½: outer, inner.
    pub half_length_m1_2: [Lanes; 2],
    /// κ of a contact with the plain outer groove, 1/m.
    pub groove_curvature: Lanes,
    /// κ of a contact, 1/m: outer as of the last evaluation, inner.
    pub curvature: [Lanes; 2],

    /// Speed of the outer ring of each ball in the housing, m/s.
    pub sliding_speed: Lanes,

    /// Creep of a contact times a, N^(1/3)·m/N^(1/3): outer, inner; 0 unless it gives the knees.
    pub creep_length_m: [Lanes; 2],

    // As of the last evaluation.
    pub outer: OuterTouchLanes,
    pub inner: InnerTouchLanes,
    pub frames: [FrameLanes; PLACES],
    /// Force of the ball on the outer ring, friction included, N.
    pub outer_ring_force_n: [Lanes; 3],

    /// The places at which any ball of the block may bear: the second at the outer ring only while
    /// one is on both flanks or the other. What other arrays hold at a place that is left out is of an earlier
    /// evaluation; only its forces are 0.
    pub places: &'static [usize],
    /// Sliding of a ball at rest on the ring of each place at the start and the end of the step.
    pub at_rest: [[SlidingLanes; PLACES]; 2],
    /// 1/v_s of the law at each place, s/m.
    pub inverse_knees: [Lanes; PLACES],
    /// Film at each place, of laws that mix.
    pub films: [FilmTractionLanes; PLACES],
    /// Whether a ball was within a discrete raceway at the end of the last step: 1 or 0.
    pub was_inside: Lanes,
    /// θ of each place.
    pub weights: [Lanes; PLACES],
    /// V to which all but the friction at the end of the step leads, and V of the last iterate.
    pub rest: [Lanes; SIZE],
    pub velocity: [Lanes; SIZE],
    /// Strips of each place, one after the other.
    pub steps: Vec<StripStep>,
    /// Friction of every strip at the end of the last step.
    pub strips: Vec<KnownStripLanes>,
}

impl SpaceBlock {
    /// Work arrays of the balls from `first` on.
    pub(crate) fn new(model: &Model, space: &SpaceModel, first: usize) -> Self {
        let ball = |lane: usize| Some(first + lane).filter(|k| *k < model.layout.balls);
        let of_balls = |value: &dyn Fn(usize) -> f64, padding: f64| {
            Lanes(std::array::from_fn(|lane| {
                ball(lane).map_or(padding, value)
            }))
        };
        let radius = |k: usize| model.balls[k].radius;
        let stiffness = |ring: usize, k: usize| match ring {
            0 => model.balls[k].outer_stiffness_n_m1_5,
            _ => model.balls[k].inner_stiffness_n_m1_5,
        };
        let of_rings = |value: &dyn Fn(usize, usize) -> f64| {
            [0, 1].map(|ring| of_balls(&|k| value(ring, k), 0.0))
        };
        let step = StripStep {
            sliding: StripSlidingLanes::ZERO,
            friction: StripFrictionLanes::ZERO,
            mean: KnownStripLanes::ZERO,
        };
        Self {
            mass: [
                of_balls(&|k| model.balls[k].mass, 1.0),
                of_balls(&|k| model.inertia[k] / (radius(k) * radius(k)), 1.0),
            ],
            inverse_radius: of_balls(&|k| 1.0 / radius(k), 1.0),
            outer_groove: OuterGrooveLanes::from_fn(|lane| {
                ball(lane).map_or_else(Default::default, |k| space.balls[k].outer)
            }),
            inner_groove: InnerGrooveLanes::from_fn(|lane| {
                ball(lane).map_or_else(Default::default, |k| space.balls[k].inner)
            }),
            half_length_m1_2: of_rings(&|ring, k| {
                space.balls[k].half_length_m_n1_3[ring] * stiffness(ring, k).cbrt()
            }),
            groove_curvature: of_balls(&|k| space.balls[k].curvature[0], 0.0),
            curvature: of_rings(&|ring, k| space.balls[k].curvature[ring]),
            sliding_speed: Lanes::ZERO,
            // Padding has a knee, too.
            creep_length_m: [0, 1].map(|ring| {
                let creep = model.creep.unwrap_or_default();
                let creep_n1_3 = [creep.outer, creep.inner][ring];
                of_balls(
                    &|k| creep_n1_3 * space.balls[k].half_length_m_n1_3[ring],
                    1.0,
                )
            }),
            outer: OuterTouchLanes::ZERO,
            inner: InnerTouchLanes::ZERO,
            frames: [const { FrameLanes::ZERO }; PLACES],
            outer_ring_force_n: [Lanes::ZERO; 3],
            places: &ALL_PLACES,
            at_rest: [const { [const { SlidingLanes::ZERO }; PLACES] }; 2],
            inverse_knees: [Lanes::all(model.friction.inverse_regularisation_speed()); PLACES],
            films: [const { FilmTractionLanes::ZERO }; PLACES],
            was_inside: Lanes::ZERO,
            weights: [Lanes::ZERO; PLACES],
            rest: [Lanes::ZERO; SIZE],
            velocity: [Lanes::ZERO; SIZE],
            steps: vec![step; PLACES * space.strips.len()],
            strips: vec![KnownStripLanes::ZERO; PLACES * space.strips.len()],
        }
    }

    /// V of the balls in a vector.
    #[inline(always)]
    pub(crate) fn velocities(&self, layout: Layout, y: &[f64], block: usize) -> [Lanes; SIZE] {
        let mut velocities = [Lanes::ZERO; SIZE];
        for i in 0..SIZE {
            let (coordinate, sign) = VELOCITIES[i];
            let values = block_at(y, layout.array(coordinate) + block * LANES);
            for lane in 0..LANES {
                let radius = if i < 3 {
                    1.0
                } else {
                    1.0 / self.inverse_radius.0[lane]
                };
                velocities[i].0[lane] = sign * values[lane] * radius;
            }
        }
        velocities
    }

    /// κ at a place.
    #[inline(always)]
    pub(crate) fn curvature_at(&self, place: usize) -> &Lanes {
        &self.curvature[usize::from(place == INNER)]
    }

    /// Sliding at a place of balls with these velocities, with the rings at the start (0) or the end (1)
    /// of the step.
    #[inline(always)]
    pub(crate) fn sliding(
        &self,
        place: usize,
        velocity: &[Lanes; SIZE],
        end: usize,
    ) -> SlidingLanes {
        let at_rest = &self.at_rest[end][place];
        let mut sliding = SlidingLanes::ZERO;
        for lane in 0..LANES {
            let v = of_lane(velocity, lane);
            let inverse_radius = self.inverse_radius.0[lane];
            let frame = self.frames[place].get(lane);
            sliding.put(lane, frame.sliding(v, inverse_radius, &at_rest.get(lane)));
        }
        sliding
    }
}
