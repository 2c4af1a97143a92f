//! Work arrays of an evaluation of the right-hand side, and its results.

use super::motions::CentreLanes;
use super::parameters::Parameters;
use super::sums::{Addends, Sum, Sums};
use crate::ball::{BallLoadLanes, PolarMotionLanes};
use crate::contact::published::FrictionDirectionLanes;
use crate::contact::{
    BallBallContactLanes, FilmTractionLanes, FlankContactLanes, FlankSlidingLanes,
    InnerContactLanes, JournalSlip, Law, LawLanes, OuterContactLanes, OuterGeometryLanes,
    SlipProblemLanes, SlipsLanes, with_law,
};
use crate::formulation::Formulation;
use crate::numerics::lane_set::LaneSet;
use crate::numerics::lanes::Lanes;
use crate::numerics::lanes::{BATCH_WIDTH, LANES};
use crate::world::body::rotor::RotorCompliance;
use crate::world::joint::TouchLoads;
use crate::world::joint::journal::RotorContact;

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
    /// Contacts with elastic flanks.
    pub flanks: FlankContactLanes,
    /// Which lanes have them.
    pub on_flanks: LaneSet,
    /// Friction along the groove at both flanks, against dρ/dt, N; over the last step where it is
    /// implicit.
    pub across_friction: Lanes,
    /// Moment of the spin at both flanks, against ω, N·m; over the last step where it is implicit.
    pub spin_moment: Lanes,
    /// Motion about the centre of the inner ring and relative to it.
    pub inner_polar: PolarMotionLanes,
    pub inner: InnerContactLanes,
    /// Friction along −ΔVi, N.
    pub inner_friction: Lanes,
    /// 1/v_s of the law at the outer and the inner contact, s/m.
    pub inverse_knees: [Lanes; 2],
    /// Films at the outer and the inner contact, of a law that mixes with them.
    pub film_tractions: [FilmTractionLanes; 2],
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
        flanks: FlankContactLanes::ZERO,
        on_flanks: LaneSet::NONE,
        across_friction: Lanes::ZERO,
        spin_moment: Lanes::ZERO,
        inner_polar: PolarMotionLanes::ZERO,
        inner: InnerContactLanes::ZERO,
        inner_friction: Lanes::ZERO,
        inverse_knees: [Lanes::ZERO; 2],
        film_tractions: [FilmTractionLanes::ZERO; 2],
        pair: BallBallContactLanes::ZERO,
        load: BallLoadLanes::ZERO,
    };
}

/// Implicit friction of the balls of a block.
#[derive(Clone)]
pub(super) struct ImplicitFriction {
    pub problem: SlipProblemLanes,
    /// Sliding speeds and friction at the end of the step.
    pub slips: SlipsLanes,
    /// Weights of the end of the step at outer and inner contacts, under a rotor.
    pub weights: [Lanes; 2],
    /// The balls on elastic flanks in the last step.
    pub on_flanks: LaneSet,
    /// Their slips before those of rigid flanks took their place.
    pub kept: SlipsLanes,
    /// Their sliding.
    pub sliding: FlankSlidingLanes,
    /// Their friction along the groove and moment of spin at the end of the step.
    pub drags: [Lanes; 2],
}

impl ImplicitFriction {
    const ZERO: Self = Self {
        problem: SlipProblemLanes::ZERO,
        slips: SlipsLanes::ZERO,
        weights: [Lanes::ZERO; 2],
        on_flanks: LaneSet::NONE,
        kept: SlipsLanes::ZERO,
        sliding: FlankSlidingLanes::ZERO,
        drags: [Lanes::ZERO; 2],
    };
}

/// Work arrays of an evaluation, and its results.
#[derive(Clone)]
pub(crate) struct Workspace {
    pub blocks: Vec<BlockResults>,
    pub(super) sums: Sums,
    /// Addends of the balls of the last block to each sum; kept, since clearing them takes time.
    pub(super) addends: Addends,
    /// The inner ring as of the last evaluation.
    pub(super) ring: CentreLanes,
    /// The outer ring as of the last evaluation; at rest in the middle unless it moves.
    pub(super) outer_ring: CentreLanes,
    /// The contact of each bearing's rotor.
    pub rotors: [RotorContact; BATCH_WIDTH],
    /// Loads of each inner ring on its rotor as of the last evaluation.
    pub rotor_loads: [TouchLoads; BATCH_WIDTH],
    /// Compliance of the rotor of each bearing to friction over a step; set before it.
    pub rotor_compliances: [RotorCompliance; BATCH_WIDTH],
    /// Sliding of each rotor at the end of the last step with implicit friction.
    pub(super) rotor_slips: [JournalSlip; BATCH_WIDTH],
    /// Friction of each rotor that changed velocities over the last step, N.
    pub(crate) rotor_friction_mean: [f64; BATCH_WIDTH],
    /// Friction of each block at the end of the last step with implicit friction.
    pub(super) friction: Vec<ImplicitFriction>,
    /// Whether the last evaluation with friction was that step.
    pub(super) slips_known: bool,
    /// The ball ahead: x, y, vx, vy, spin.
    pub(super) next: [Vec<Lanes>; 5],
    /// Force x, force y and moment of the contact with the ball ahead on each ball, and its moment
    /// on the ball ahead; behind a free block.
    pub(super) pairs: [Vec<Lanes>; 4],
    /// Largest deflection between balls of each bearing, m; 0 if none touch.
    pub pair_deflection_max: [f64; BATCH_WIDTH],
    /// Whether the results hold forces between balls.
    pub(super) pairs_loaded: bool,
    /// Largest |ΔV| under load of each lane, m/s.
    pub slip_max: Lanes,
    /// Directions of friction at the outer raceway in the published equations; else empty, for they are
    /// along the circumference.
    pub friction_directions: Vec<FrictionDirectionLanes>,
}

impl Workspace {
    pub(crate) fn new(p: &Parameters, formulation: Formulation) -> Self {
        let blocks = p.layout.stride / LANES;
        let zero = || vec![Lanes::ZERO; blocks];
        let inverse_knee =
            |lane| with_law!(&p.friction, law => law.lane(lane).inverse_regularisation_speed());
        let block = BlockResults {
            inverse_knees: [Lanes(std::array::from_fn(inverse_knee)); 2],
            ..BlockResults::ZERO
        };
        Self {
            blocks: vec![block; blocks],
            sums: Sums::ZERO,
            addends: [Lanes::ZERO; Sum::COUNT],
            ring: CentreLanes::ZERO,
            outer_ring: CentreLanes::ZERO,
            rotors: [RotorContact::default(); BATCH_WIDTH],
            rotor_loads: [TouchLoads::default(); BATCH_WIDTH],
            rotor_compliances: [RotorCompliance::HELD; BATCH_WIDTH],
            rotor_slips: [JournalSlip::default(); BATCH_WIDTH],
            rotor_friction_mean: [0.0; BATCH_WIDTH],
            friction: vec![ImplicitFriction::ZERO; blocks],
            slips_known: false,
            next: std::array::from_fn(|_| zero()),
            pairs: std::array::from_fn(|_| vec![Lanes::ZERO; blocks + 1]),
            pair_deflection_max: [0.0; BATCH_WIDTH],
            pairs_loaded: false,
            slip_max: Lanes::ZERO,
            friction_directions: match formulation.equations().friction_along_path {
                true => vec![FrictionDirectionLanes::ZERO; blocks],
                false => vec![],
            },
        }
    }
}
