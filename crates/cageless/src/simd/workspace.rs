//! Work arrays of an evaluation of the right-hand side, and its results.

use super::lanes::Lanes;
use super::motions::CentreLanes;
use super::parameters::Parameters;
use super::sums::Sums;
use crate::contact::{
    BallBallContactLanes, InnerContactLanes, OuterContactLanes, OuterGeometryLanes, SlipsLanes,
};
use crate::dynamics::ball::{BallLoadLanes, PolarMotionLanes};
use crate::dynamics::layout::{BATCH_WIDTH, LANES};
use crate::dynamics::rotor::RotorContact;

/// Per-ball results of one evaluation for a block. Fields of one struct, so that the compiler
/// knows that they do not overlap.
#[derive(Clone)]
pub(crate) struct BlockResults {
    pub polar: PolarMotionLanes,
    /// Absolute spin, rad/s.
    pub spin: Lanes,
    pub geometry: OuterGeometryLanes,
    pub outer: OuterContactLanes,
    /// Friction along −ΔVo, N.
    pub outer_friction: Lanes,
    /// Force along ψ where the outer contact rises, N.
    pub slope_force: Lanes,
    /// Motion about the centre of the inner ring and relative to it.
    pub inner_polar: PolarMotionLanes,
    pub inner: InnerContactLanes,
    /// Friction along −ΔVi, N.
    pub inner_friction: Lanes,
    /// Contact with the ball ahead; forces are 0 unless any two balls touch.
    pub pair: BallBallContactLanes,
    /// Sums over the contacts of each ball and its weight.
    pub load: BallLoadLanes,
}

impl BlockResults {
    const ZERO: Self = Self {
        polar: PolarMotionLanes::ZERO,
        spin: Lanes::ZERO,
        geometry: OuterGeometryLanes::ZERO,
        outer: OuterContactLanes::ZERO,
        outer_friction: Lanes::ZERO,
        slope_force: Lanes::ZERO,
        inner_polar: PolarMotionLanes::ZERO,
        inner: InnerContactLanes::ZERO,
        inner_friction: Lanes::ZERO,
        pair: BallBallContactLanes::ZERO,
        load: BallLoadLanes::ZERO,
    };
}

/// Work arrays of an evaluation, and its results.
#[derive(Clone)]
pub(crate) struct Workspace {
    pub blocks: Vec<BlockResults>,
    pub(super) sums: Sums,
    /// Reactions of the friction at the end of a step.
    pub(super) end_sums: Sums,
    /// The inner ring as of the last evaluation.
    pub(super) ring: CentreLanes,
    /// The outer ring, where it moves.
    pub(super) outer_ring: CentreLanes,
    /// The contact of each bearing's rotor.
    pub rotors: [RotorContact; BATCH_WIDTH],
    /// Slip and friction of each rotor at the end of the last step with implicit friction.
    pub(super) rotor_slips: [[f64; 2]; BATCH_WIDTH],
    /// Friction of each rotor that changed velocities over the last step, N.
    pub(crate) rotor_friction_mean: [f64; BATCH_WIDTH],
    /// Sliding speeds and friction at the end of the last step with implicit friction.
    pub(super) slips: Vec<SlipsLanes>,
    /// Whether the last evaluation with friction was that step.
    pub(super) slips_known: bool,
    /// The ball ahead: x, y, vx, vy, absolute spin, orbital speed.
    pub(super) next: [Vec<Lanes>; 6],
    /// Force and moment of the contact with the ball ahead, and of that with the ball behind.
    pub(super) ahead: [Vec<Lanes>; 3],
    pub(super) behind: [Vec<Lanes>; 3],
    /// Largest deflection between balls of each bearing, m; 0 if none touch.
    pub pair_deflection_max: [f64; BATCH_WIDTH],
    /// Whether the results hold forces between balls.
    pub(super) pairs_loaded: bool,
    /// Largest |ΔV| under load of each bearing, m/s.
    pub slip_max: [f64; BATCH_WIDTH],
}

impl Workspace {
    pub fn new(p: &Parameters) -> Self {
        let blocks = p.layout.stride / LANES;
        let zero = || vec![Lanes::ZERO; blocks];
        Self {
            blocks: vec![BlockResults::ZERO; blocks],
            sums: Sums::ZERO,
            end_sums: Sums::ZERO,
            ring: CentreLanes::ZERO,
            outer_ring: CentreLanes::ZERO,
            rotors: [RotorContact::default(); BATCH_WIDTH],
            rotor_slips: [[0.0; 2]; BATCH_WIDTH],
            rotor_friction_mean: [0.0; BATCH_WIDTH],
            slips: vec![SlipsLanes::ZERO; blocks],
            slips_known: false,
            next: std::array::from_fn(|_| zero()),
            ahead: std::array::from_fn(|_| zero()),
            behind: std::array::from_fn(|_| zero()),
            pair_deflection_max: [0.0; BATCH_WIDTH],
            pairs_loaded: false,
            slip_max: [0.0; BATCH_WIDTH],
        }
    }
}
