//! The right-hand side, Zhao 2022, Eq. (12) to (22): the scalar functions over the lanes of
//! every block, the exchange between neighbouring balls, and the sums over the balls.

use super::creep;
use super::film;
use super::film_block::FilmBlock;
use super::flanks;
use super::friction::{both_raceways, loaded_slips};
use super::geometry::{plain_positions, raceway_geometry};
use super::hysteresis;
use super::implicit_friction;
use super::motions::{CentreLanes, Motions, block_at, block_mut};
use super::pairs::ball_contacts;
use super::parameters::Parameters;
use super::rotor::{add_with_rotor, outer_ring_reactions, ring_torques, set_rates_under_rotor};
use super::sums::{Addends, Sum, Sums};
use super::traction;
use super::workspace::{BlockResults, Workspace};
use crate::ball::{BallLanes, BallLoad, Centre};
use crate::contact::{
    CreepLanes, inner_contact, inner_load, outer_contact, outer_load, slope_force,
};
use crate::dynamics::coordinates::{BallCoordinate, RingCoordinate};
use crate::dynamics::energy::EnergyTerm;
use crate::film::TractionCurveLanes;
use crate::numerics::lanes::{LANES, Lanes};

/// Writes the right-hand side into `dydt`; without friction at the raceways if a method treats
/// it implicitly.
#[inline(always)]
pub(crate) fn evaluate(
    p: &Parameters,
    w: &mut Workspace,
    y: &[f64],
    dydt: &mut [f64],
    raceway_friction: bool,
) {
    assert!(y.len() >= p.layout.end() && dydt.len() == y.len());
    assert!(w.blocks.len() * LANES == p.layout.stride);
    w.ring = CentreLanes::inner_ring(p.layout, y);
    if !p.drops.is_empty() {
        w.outer_ring = CentreLanes::outer_ring(p.layout, y);
    }
    w.sums.clear(p.layout.width() == 1);
    let rolling = Rolling::of(p);
    // Written out twice, so that the loop of dry contacts has no code of others in it.
    match rolling.is_dry() {
        true => loads_of_blocks(p, w, y, raceway_friction, Rolling::DRY),
        false => loads_of_blocks(p, w, y, raceway_friction, rolling),
    }
    w.slips_known &= !raceway_friction;
    ball_contacts(p, w, y);
    accelerations(p, w, y, dydt);
    set_rates_of_bodies(p, w, y, dydt, raceway_friction);
}

/// Parts of rolling contacts beside dry friction at a given regularisation speed.
#[derive(Clone, Copy)]
struct Rolling<'p> {
    creep: Option<&'p CreepLanes>,
    tractions: Option<&'p [TractionCurveLanes; 2]>,
    film: Option<&'p FilmBlock>,
}

impl<'p> Rolling<'p> {
    const DRY: Self = Self {
        creep: None,
        tractions: None,
        film: None,
    };

    /// Parts of the rolling contacts of these bearings.
    #[inline(always)]
    fn of(p: &'p Parameters) -> Self {
        Self {
            creep: p.creep.as_ref(),
            tractions: p.tractions(),
            film: p.film.as_ref(),
        }
    }

    #[inline(always)]
    fn is_dry(&self) -> bool {
        self.creep.is_none() && self.film.is_none()
    }
}

/// Contacts of the balls of all blocks with both raceways, their loads and sums.
#[inline(always)]
fn loads_of_blocks(
    p: &Parameters,
    w: &mut Workspace,
    y: &[f64],
    raceway_friction: bool,
    rolling: Rolling<'_>,
) {
    let (alone, under_rotor) = (p.layout.width() == 1, !p.drops.is_empty());
    let (ring, outer_ring) = (&w.ring, &w.outer_ring);
    let mut slip_max = Lanes::ZERO;
    for (block, results) in w.blocks.iter_mut().enumerate() {
        // Or the constants of all lanes are read before the loop, only to be put on the stack.
        let p = std::hint::black_box(p);
        let motions = Motions::new(p.layout, y, block);
        let balls = p.balls(block);
        plain_positions(balls, results, motions, outer_ring);
        contacts_of_block(p, rolling, balls, results, motions, ring, raceway_friction);
        outer_loads(p, balls, results, &mut w.addends, motions);
        if p.unequal {
            slope_forces(results);
        }
        if p.elastic {
            flanks::outer_contacts(p, balls, results, motions, &mut w.addends, raceway_friction);
        }
        if under_rotor {
            outer_ring_reactions(p, balls, results, &mut w.addends);
            w.sums.add(&Sum::OUTER_RING, &w.addends, alone, block);
        }
        inner_loads(p, balls, results, &mut w.addends);
        if let Some(films) = rolling.film {
            film::add(p, films, balls, results, motions, &mut w.addends);
            if let Some(factors) = &films.hysteresis {
                hysteresis::add(p, factors, balls, results, motions, &mut w.addends);
            }
            w.sums.add(&Sum::ROLLING, &w.addends, alone, block);
        }
        w.sums.add(&Sum::NORMAL, &w.addends, alone, block);
        if raceway_friction {
            loaded_slips(results, &mut slip_max);
            w.sums.add(&Sum::FRICTION, &w.addends, alone, block);
            if under_rotor {
                ring_torques(p, results, &mut w.addends);
                w.sums.add(&[Sum::RingTorque], &w.addends, alone, block);
            }
        }
    }
    w.slip_max = slip_max;
}

/// Contacts of the balls of a block with both raceways, and their friction unless a method treats it implicitly.
#[inline(always)]
fn contacts_of_block(
    p: &Parameters,
    rolling: Rolling<'_>,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    ring: &CentreLanes,
    raceway_friction: bool,
) {
    if p.unequal || p.elastic {
        results.geometry.slope = Lanes::ZERO;
    }
    for raceway in &p.raceways {
        raceway_geometry(p, balls, raceway, results);
    }
    raceway_contacts(p, balls, results, motions, ring);
    if let Some(constants) = rolling.creep {
        creep::set_knees(p, constants, balls, results, motions);
    }
    if let Some(curves) = rolling.tractions {
        traction::set(p, curves, balls, results, motions);
    }
    if raceway_friction {
        both_raceways(p, results);
    } else {
        (results.outer_friction, results.inner_friction) = (Lanes::ZERO, Lanes::ZERO);
    }
}

/// Rates of the bodies of each bearing, and the powers of its energy ledger.
#[inline(always)]
fn set_rates_of_bodies(
    p: &Parameters,
    w: &mut Workspace,
    y: &[f64],
    dydt: &mut [f64],
    raceway_friction: bool,
) {
    for bearing in 0..p.layout.width() {
        let (ring, layout) = (w.ring.get(bearing), p.layout.of_bearing(bearing));
        if let Some(under) = p.drops.get(bearing) {
            let touch = under.touch_in_plane(layout, y, raceway_friction);
            let [x, y_force, _] = touch.loads.force;
            ring_and_ledger(p, bearing, &ring, &w.sums, [x, y_force], dydt);
            set_rates_under_rotor(p, bearing, &w.sums, &touch, y, dydt);
            (w.rotors[bearing], w.rotor_loads[bearing]) = (touch.contact, touch.loads);
        } else {
            ring_and_ledger(p, bearing, &ring, &w.sums, [0.0; 2], dydt);
        }
    }
}

/// Adds friction at the raceways over a step of `h_s`, for which the last evaluation gave the
/// contacts without it: `y` holds the velocities that the other forces lead to. They change by
/// h·((1 − θ)·f₀ + θ·f₁), f₀ and f₁ the friction at both ends and θ the [`end_weights`] of the
/// contacts: of order 2 where contacts slide, damped where they roll. The same friction is added
/// as rates to `dydt`, its powers to the energy ledger.
#[inline(always)]
pub(crate) fn add_implicit_friction(
    p: &Parameters,
    w: &mut Workspace,
    h_s: f64,
    y0: &[f64],
    y: &mut [f64],
    dydt: &mut [f64],
) {
    match p.drops.is_empty() {
        true => implicit_friction::add(p, w, h_s, y0, y, dydt),
        false => add_with_rotor(p, w, h_s, y0, y, dydt),
    }
}

/// Contacts with both raceways, without friction.
#[inline(always)]
pub(super) fn raceway_contacts(
    p: &Parameters,
    balls: &BallLanes,
    results: &mut BlockResults,
    motions: Motions<'_>,
    ring: &CentreLanes,
) {
    for lane in 0..LANES {
        let (ball, motion) = (balls.get(lane), motions.get(lane));
        let outer = outer_contact(
            &ball,
            &p.outer.get(lane),
            &results.geometry.get(lane),
            &motion,
            &results.polar.get(lane),
        );
        results.outer.put(lane, outer);
    }
    for lane in 0..LANES {
        let (ball, motion) = (balls.get(lane), motions.get(lane));
        let polar = motion.about(&ring.get(lane));
        let inner = inner_contact(&ball, &p.inner.get(lane), &motion, &polar);
        results.inner_polar.ex.0[lane] = polar.ex;
        results.inner_polar.ey.0[lane] = polar.ey;
        results.inner.put(lane, inner);
    }
}

/// Loads of outer contacts and weights; starts the loads and the addends.
#[inline(always)]
fn outer_loads(
    p: &Parameters,
    balls: &BallLanes,
    results: &mut BlockResults,
    addends: &mut Addends,
    motions: Motions<'_>,
) {
    for lane in 0..LANES {
        let (ball, polar) = (balls.get(lane), results.polar.get(lane));
        let (outer, geometry) = (results.outer.get(lane), results.geometry.get(lane));
        let friction = results.outer_friction.0[lane];
        let mut load = outer_load(&outer, &geometry, &polar, friction);
        let weight = ball.mass * p.ring.gravity.0[lane];
        load.fy -= weight;
        results.load.put(lane, load);
        addends[Sum::Weight as usize].0[lane] = -weight * motions.get(lane).vy;
        addends[Sum::OuterFriction as usize].0[lane] = friction * outer.slip;
        addends[Sum::RacewayDamping as usize].0[lane] = outer.damping_power;
    }
}

/// Tangential part of outer normal forces where the contact rises along ψ.
#[inline(always)]
pub(super) fn slope_forces(results: &mut BlockResults) {
    for lane in 0..LANES {
        let polar = results.polar.get(lane);
        let force = slope_force(
            &results.outer.get(lane),
            &results.geometry.get(lane),
            polar.distance,
        );
        results.slope_force.0[lane] = force;
        results.load.fx.0[lane] -= force * polar.ey;
        results.load.fy.0[lane] += force * polar.ex;
    }
}

/// Loads of inner contacts; adds to the loads and the addends.
#[inline(always)]
pub(super) fn inner_loads(
    p: &Parameters,
    balls: &BallLanes,
    results: &mut BlockResults,
    addends: &mut Addends,
) {
    for lane in 0..LANES {
        let (inner, polar) = (results.inner.get(lane), results.inner_polar.get(lane));
        let friction = results.inner_friction.0[lane];
        let inner_load = inner_load(&inner, &balls.get(lane), &polar, friction);
        let load = results.load.get(lane);
        results.load.put(
            lane,
            BallLoad {
                fx: load.fx + inner_load.fx,
                fy: load.fy + inner_load.fy,
                torque: load.torque + inner_load.torque,
            },
        );
        addends[Sum::RingX as usize].0[lane] = -inner_load.fx;
        addends[Sum::RingY as usize].0[lane] = -inner_load.fy;
        addends[Sum::Drive as usize].0[lane] = friction * p.inner.surface_speed.0[lane];
        addends[Sum::InnerFriction as usize].0[lane] = friction * inner.slip;
        addends[Sum::RacewayDamping as usize].0[lane] += inner.damping_power;
    }
}

/// Velocities and accelerations of the balls.
#[inline(always)]
pub(super) fn accelerations(p: &Parameters, w: &Workspace, y: &[f64], dydt: &mut [f64]) {
    for (block, results) in w.blocks.iter().enumerate() {
        let balls = p.balls(block);
        for (position, velocity) in [
            (BallCoordinate::X, BallCoordinate::Vx),
            (BallCoordinate::Y, BallCoordinate::Vy),
        ] {
            let velocities = block_at(y, p.layout.array(velocity) + block * LANES);
            *block_mut(dydt, p.layout.array(position) + block * LANES) = *velocities;
        }
        let mut rates = [[0.0; LANES]; 3];
        for lane in 0..LANES {
            let acceleration = results.load.get(lane).acceleration(&balls.get(lane));
            for k in 0..3 {
                rates[k][lane] = acceleration[k];
            }
        }
        let coordinates = [BallCoordinate::Vx, BallCoordinate::Vy, BallCoordinate::Spin];
        for (coordinate, rates) in coordinates.into_iter().zip(rates) {
            *block_mut(dydt, p.layout.array(coordinate) + block * LANES) = rates;
        }
    }
}

/// Motion of the inner ring of one bearing, which pushes a rotor with a force, and the powers of its energy
/// ledger.
#[inline(always)]
pub(super) fn ring_and_ledger(
    p: &Parameters,
    bearing: usize,
    motion: &Centre,
    sums: &Sums,
    pushed: [f64; 2],
    dydt: &mut [f64],
) {
    let layout = p.layout.of_bearing(bearing);
    let total = |sum: Sum| sums.total(sum, layout.width() == 1, bearing);
    let ring = p.ring.get(bearing);
    let [x, y] = [total(Sum::RingX) - pushed[0], total(Sum::RingY) - pushed[1]];
    let [ax, ay] = ring.acceleration(motion, [x, y]);
    dydt[layout.ring(RingCoordinate::X)] = motion.vx;
    dydt[layout.ring(RingCoordinate::Y)] = motion.vy;
    dydt[layout.ring(RingCoordinate::Vx)] = ax;
    dydt[layout.ring(RingCoordinate::Vy)] = ay;
    let [rolling, driven] = match p.film {
        Some(_) => Sum::ROLLING.map(total),
        None => [0.0; 2],
    };
    let drive = match p.film {
        Some(_) => total(Sum::Drive) + driven,
        None => total(Sum::Drive),
    };
    let powers: [(EnergyTerm, f64); EnergyTerm::without_rotor().len()] = [
        (EnergyTerm::Drive, drive),
        (EnergyTerm::Load, ring.load_power_w(motion)),
        (
            EnergyTerm::Weight,
            total(Sum::Weight) - ring.weight_n() * motion.vy,
        ),
        (EnergyTerm::InnerFriction, total(Sum::InnerFriction)),
        (EnergyTerm::OuterFriction, total(Sum::OuterFriction)),
        (EnergyTerm::BallFriction, total(Sum::BallFriction)),
        (
            EnergyTerm::Damping,
            total(Sum::RacewayDamping) + total(Sum::BallDamping),
        ),
        (
            EnergyTerm::Drag,
            ring.drag * (motion.vx * motion.vx + motion.vy * motion.vy),
        ),
        (EnergyTerm::Centrifugal, 0.0),
        (EnergyTerm::FrictionDirection, 0.0),
        (EnergyTerm::RelativeSpin, 0.0),
        (EnergyTerm::RollingResistance, rolling),
    ];
    for (term, power) in powers {
        dydt[layout.energy_term(term)] = power;
    }
}
