//! The constants of one bearing, or of several side by side, block by block.

use std::sync::Arc;

use super::film_block::FilmBlock;
use super::flank_polynomials::FlankPolynomials;
use super::motions::ring_speeds;
use crate::ball::{Ball, BallLanes};
use crate::contact::creep::Creep;
use crate::contact::{
    CreepLanes, FrictionLanes, InnerRacewayLanes, OuterRacewayLanes, RacewayConstants,
    RacewayConstantsLanes,
};
use crate::dynamics::Model;
use crate::dynamics::coordinates::RingCoordinate;
use crate::dynamics::layout::Layout;
use crate::dynamics::model::RacewayModel;
use crate::film::TractionCurveLanes;
use crate::numerics::lanes::LANES;
use crate::numerics::lanes::Lanes;
use crate::world::body::inner_ring::InnerRingLanes;
use crate::world::under_rotor::UnderRotor;

/// Coefficients of a polynomial: of even and of odd powers.
pub(super) type Polynomial = Vec<[Lanes; 2]>;

/// One discrete raceway of each bearing.
#[derive(Clone)]
pub(super) struct RacewayBlock {
    pub constants: RacewayConstantsLanes,
    pub radius: Polynomial,
    pub radius_slope: Polynomial,
    /// 1/√(1 + y′² + z′²) along the contact path, in the published equations.
    pub direction: Polynomial,
    /// 4a and 2b of the slope of that path, Zhao 2022, Eq. (5).
    pub path_slope: [Lanes; 2],
    /// Polynomials of the elastic flanks of each bearing.
    pub flanks: Vec<FlankPolynomials>,
}

/// The constants of the equations of motion, lane by lane.
#[derive(Clone)]
pub(crate) struct Parameters {
    pub layout: Layout,
    /// Whether outer contacts differ from those of nominal balls in raceways as designed.
    pub unequal: bool,
    /// Whether the flanks of discrete raceways are elastic.
    pub elastic: bool,
    /// The bodies under the rotor of each bearing; empty without rotors.
    pub drops: Vec<UnderRotor>,
    pub friction: FrictionLanes,
    /// Creep of the contacts with the raceways, where it gives the knees of the law.
    pub(super) creep: Option<CreepLanes>,
    pub outer: OuterRacewayLanes,
    pub inner: InnerRacewayLanes,
    pub ring: InnerRingLanes,
    pub(super) raceways: Vec<RacewayBlock>,
    /// Films of the contacts with the raceways.
    pub(super) film: Option<FilmBlock>,
    /// Constants of the balls of each block; only one block if all are the same.
    balls: Vec<BallLanes>,
}

impl Parameters {
    /// Traction of the films of the outer and the inner contacts, where it is the friction there.
    #[inline(always)]
    pub(super) fn tractions(&self) -> Option<&[TractionCurveLanes; 2]> {
        self.film.as_ref()?.traction.as_ref()
    }

    /// Constants of the balls of a block.
    #[inline(always)]
    pub(crate) fn balls(&self, block: usize) -> &BallLanes {
        if self.balls.len() == 1 {
            &self.balls[0]
        } else {
            &self.balls[block]
        }
    }

    /// Sets what is given over time to its values at `time_s`.
    pub(crate) fn set_time(&mut self, models: &[Arc<Model>], time_s: f64) {
        for lane in 0..LANES {
            let model = &models[lane % models.len()];
            if let Some(speed) = &model.inner_speed {
                self.inner.surface_speed.0[lane] = speed.value(time_s) * model.inner.radius;
            }
            if let Some(load) = &model.radial_load {
                self.ring.radial_load.0[lane] = load.value(time_s);
            }
            if let Some(unbalance) = &model.unbalance {
                let [x, y] = unbalance.at(time_s);
                (self.ring.unbalance_x.0[lane], self.ring.unbalance_y.0[lane]) = (x, y);
            }
        }
    }

    /// Sets the surface speed of the inner raceway from a state of which the speed of the ring is a part.
    #[inline(always)]
    pub(crate) fn set_ring_speed(&mut self, y: &[f64]) {
        if !self.layout.moves(RingCoordinate::Speed) {
            return;
        }
        let speed = ring_speeds(self.layout, y);
        for lane in 0..LANES {
            self.inner.surface_speed.0[lane] = speed.0[lane] * self.inner.radius.0[lane];
        }
    }

    /// Constants of the bearings whose places `layout` has; lane l belongs to bearing l modulo
    /// their number.
    pub(crate) fn new(models: &[Arc<Model>], layout: Layout) -> Self {
        let first = &models[0];
        let model = |lane: usize| &models[lane % models.len()];
        let raceways = models.iter().map(|m| m.raceway_models.len()).max();
        // Padding has neither stiffness nor mass, and so feels nothing.
        let padding = Ball {
            radius: first.outer.ball_radius,
            ..Ball::default()
        };
        let ball = |block: usize, lane: usize| {
            let entry = block * LANES + lane;
            let (model, k) = (model(entry), entry / models.len());
            model.balls.get(k).copied().unwrap_or(padding)
        };
        let unequal = models.iter().any(|m| m.unequal);
        let same = layout.entries() == layout.stride && !unequal;
        let blocks = if same { 1 } else { layout.stride / LANES };
        Self {
            layout,
            unequal,
            elastic: first.flanks.yields(),
            drops: models
                .iter()
                .filter_map(|m| m.under_rotor.clone())
                .collect(),
            friction: FrictionLanes::from_fn(|lane| model(lane).friction.clone()),
            creep: (first.creep.is_some()).then(|| {
                CreepLanes::from_fn(|lane| {
                    let creep = model(lane).creep.unwrap_or_default();
                    // Loads at the outer raceway have the factor of friction there.
                    let factor = model(lane).outer.friction_factor;
                    let root = if factor > 0.0 { factor.cbrt() } else { 1.0 };
                    Creep {
                        outer: creep.outer * root,
                        ..creep
                    }
                })
            }),
            outer: OuterRacewayLanes::from_fn(|lane| model(lane).outer),
            inner: InnerRacewayLanes::from_fn(|lane| model(lane).inner),
            ring: InnerRingLanes::from_fn(|lane| model(lane).ring),
            raceways: (0..raceways.unwrap_or(0))
                .map(|k| raceway_block(models, k))
                .collect(),
            film: FilmBlock::new(models),
            balls: (0..blocks)
                .map(|block| BallLanes::from_fn(|lane| ball(block, lane)))
                .collect(),
        }
    }
}

fn raceway_block(models: &[Arc<Model>], k: usize) -> RacewayBlock {
    let raceway = |lane: usize| models[lane % models.len()].raceway_models.get(k);
    let absent = RacewayConstants {
        end: -1.0,
        ..RacewayConstants::default()
    };
    let polynomial = |coefficients: fn(&RacewayModel) -> &Vec<f64>| -> Polynomial {
        let lengths = (0..models.len()).filter_map(|lane| Some(coefficients(raceway(lane)?).len()));
        let length = lengths.max().unwrap_or(0);
        // A shorter polynomial starts with zeros, which change no bit of its value.
        let coefficient = |c: usize| {
            Lanes(std::array::from_fn(|lane| {
                raceway(lane).map_or(0.0, |r| coefficients(r).get(c).copied().unwrap_or(0.0))
            }))
        };
        (0..length.div_ceil(2))
            .map(|c| [coefficient(2 * c), coefficient(2 * c + 1)])
            .collect()
    };
    RacewayBlock {
        constants: RacewayConstantsLanes::from_fn(|lane| {
            raceway(lane).map_or(absent, |r| r.constants)
        }),
        radius: polynomial(|r| &r.radius),
        radius_slope: polynomial(|r| &r.radius_slope),
        direction: polynomial(|r| &r.direction),
        path_slope: [0, 1].map(|k| {
            Lanes(std::array::from_fn(|lane| {
                raceway(lane).map_or(0.0, |r| r.path_slope[k])
            }))
        }),
        flanks: (0..models.len())
            .map(|lane| FlankPolynomials::new(raceway(lane)))
            .collect(),
    }
}
