//! The constants of one bearing, or of several side by side, block by block.

use super::lanes::Block;
use super::model::{Groove, Model};
use crate::case::{FrictionLaw, Profile};
use crate::state::{LANES, Layout};

/// Constants of each ball of a block.
#[derive(Clone)]
pub(super) struct BallBlock {
    /// Damping of the raceway contacts.
    pub damping: Block,
    pub radius: Block,
    pub mass: Block,
    pub inverse_mass: Block,
    pub inverse_inertia: Block,
    /// Ro − R.
    pub touching: Block,
    /// Ri + R.
    pub reach: Block,
    pub inner_stiffness: Block,
    pub outer_stiffness: Block,
    pub pair_distance: Block,
    pub pair_stiffness: Block,
    pub pair_damping: Block,
    /// Radius of the ball ahead.
    pub next_radius: Block,
}

/// Constants of one discrete raceway; of each bearing its own.
#[derive(Clone)]
pub(super) struct GrooveBlock {
    pub sin_centre: Block,
    pub cos_centre: Block,
    /// sin²θ; −1 where a bearing has no such raceway.
    pub end: Block,
    pub scale: Block,
    pub shift: Block,
    pub slope: [Block; 2],
    /// Depth milled too much in the middle.
    pub error: Block,
    /// 1/sin²θ.
    pub inverse_end: Block,
    /// Coefficients of even and odd powers.
    pub radius: Vec<[Block; 2]>,
    pub radius_slope: Vec<[Block; 2]>,
    pub direction: Vec<[Block; 2]>,
}

/// Everything that the equations need.
#[derive(Clone)]
pub(super) struct Parameters {
    pub layout: Layout,
    pub profile: Profile,
    pub law: FrictionLaw,
    /// Whether seats differ from those of nominal balls in raceways as designed.
    pub unequal: bool,
    /// Rw, nominal.
    pub ball_radius: Block,
    /// Re − Rw and Re.
    pub flank: Block,
    pub curvature: Block,
    /// Rm.
    pub pitch_radius: Block,
    /// Ri.
    pub inner_radius: Block,
    /// Ro − Rw.
    pub path_radius: Block,
    pub surface_speed: Block,
    pub gravity: Block,
    pub friction: Block,
    pub inverse_slip_scale: Block,
    pub stick_gain: Block,
    pub ring_mass: Block,
    pub ring_drag: Block,
    pub radial_load: Block,
    pub grooves: Vec<GrooveBlock>,
    /// Of each block; only one if all are the same.
    balls: Vec<BallBlock>,
}

impl Parameters {
    /// Constants of the balls of a block.
    #[inline(always)]
    pub fn ball(&self, block: usize) -> &BallBlock {
        if self.balls.len() == 1 {
            &self.balls[0]
        } else {
            &self.balls[block]
        }
    }

    /// Of the bearings whose places `layout` has; lane l belongs to bearing l modulo their
    /// number.
    pub fn new(models: &[&Model], layout: Layout) -> Self {
        let first = models[0];
        let of = |value: &dyn Fn(&Model) -> f64| {
            Block(std::array::from_fn(|lane| {
                value(models[lane % models.len()])
            }))
        };
        let grooves = models.iter().map(|m| m.grooves.len()).max().unwrap_or(0);
        let per_ball = |block: usize, value: &dyn Fn(&Model, usize) -> f64, padding: f64| {
            Block(std::array::from_fn(|lane| {
                let entry = block * LANES + lane;
                let (model, ball) = (models[entry % models.len()], entry / models.len());
                if ball < layout.balls {
                    value(model, ball)
                } else {
                    padding
                }
            }))
        };
        let unequal = models.iter().any(|m| m.unequal);
        let same = layout.entries() == layout.stride && !unequal;
        let balls = (0..if same { 1 } else { layout.stride / LANES })
            .map(|block| {
                // Padding has neither stiffness nor mass, and so feels nothing.
                let each = |value: &dyn Fn(&Model, usize) -> f64| per_ball(block, value, 0.0);
                BallBlock {
                    damping: each(&|m, _| m.damping),
                    radius: per_ball(block, &|m, k| m.balls[k].radius, first.ball_radius),
                    mass: each(&|m, k| m.balls[k].mass),
                    inverse_mass: each(&|m, k| 1.0 / m.balls[k].mass),
                    inverse_inertia: each(&|m, k| 1.0 / m.balls[k].inertia),
                    touching: each(&|m, k| m.outer_radius - m.balls[k].radius),
                    reach: each(&|m, k| m.inner_radius + m.balls[k].radius),
                    inner_stiffness: each(&|m, k| m.balls[k].inner_stiffness),
                    outer_stiffness: each(&|m, k| m.balls[k].outer_stiffness),
                    pair_distance: each(&|m, k| m.balls[k].pair_distance),
                    pair_stiffness: each(&|m, k| m.balls[k].pair_stiffness),
                    pair_damping: each(&|m, k| m.balls[k].pair_damping),
                    next_radius: each(&|m, k| m.balls[(k + 1) % m.balls.len()].radius),
                }
            })
            .collect();
        Self {
            layout,
            profile: first.profile,
            law: first.law,
            unequal,
            ball_radius: of(&|m| m.ball_radius),
            flank: of(&|m| m.groove_curvature_radius - m.ball_radius),
            curvature: of(&|m| m.groove_curvature_radius),
            pitch_radius: of(&|m| m.pitch_radius),
            inner_radius: of(&|m| m.inner_radius),
            path_radius: of(&|m| m.outer_radius - m.ball_radius),
            surface_speed: of(&|m| m.inner_speed * m.inner_radius),
            gravity: of(&|m| m.gravity),
            friction: of(&|m| m.friction),
            inverse_slip_scale: of(&|m| m.inverse_slip_scale),
            stick_gain: of(&|m| m.stick_gain),
            ring_mass: of(&|m| m.ring_mass),
            ring_drag: of(&|m| m.ring_drag),
            radial_load: of(&|m| m.radial_load),
            grooves: (0..grooves).map(|k| groove_block(models, k)).collect(),
            balls,
        }
    }
}

fn groove_block(models: &[&Model], k: usize) -> GrooveBlock {
    let of = |value: &dyn Fn(&Groove) -> f64, otherwise: f64| {
        Block(std::array::from_fn(|lane| {
            models[lane % models.len()]
                .grooves
                .get(k)
                .map_or(otherwise, value)
        }))
    };
    let polynomial = |coefficients: &dyn Fn(&Groove) -> &Vec<f64>| {
        let present = models.iter().filter_map(|m| m.grooves.get(k));
        let length = present.map(|g| coefficients(g).len()).max().unwrap_or(0);
        // A shorter polynomial starts with zeros, which change no bit of its value.
        let coefficient = |c: usize| of(&|g| coefficients(g).get(c).copied().unwrap_or(0.0), 0.0);
        (0..length.div_ceil(2))
            .map(|c| [coefficient(2 * c), coefficient(2 * c + 1)])
            .collect()
    };
    GrooveBlock {
        sin_centre: of(&|g| g.sin_centre, 0.0),
        cos_centre: of(&|g| g.cos_centre, 0.0),
        end: of(&|g| g.end, -1.0),
        scale: of(&|g| g.scale, 0.0),
        shift: of(&|g| g.shift, 0.0),
        slope: [of(&|g| g.slope[0], 0.0), of(&|g| g.slope[1], 0.0)],
        error: of(&|g| g.error, 0.0),
        inverse_end: of(&|g| 1.0 / g.end, 0.0),
        radius: polynomial(&|g| &g.radius),
        radius_slope: polynomial(&|g| &g.radius_slope),
        direction: polynomial(&|g| &g.direction),
    }
}
