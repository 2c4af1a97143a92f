//! The right-hand side itself, Zhao 2022, Eq. (12) to (22): plain loops over the lanes of a
//! block. No operation depends on the width of a vector and none is fused, so every
//! instruction set gives the same bits.

use super::lanes::{Block, Entry, Scratch, Shares, Sum, Sums};
use super::parameters::{BallBlock, GrooveBlock, Parameters};
use crate::case::{FrictionLaw, Profile};
use crate::state::{LANES, MEMBERS, Work};
use crate::traction::tanh;

/// Work arrays of an evaluation; they hold everything that can be seen of it afterwards.
#[derive(Clone)]
pub(super) struct Workspace {
    pub entries: Vec<Entry>,
    sums: Sums,
    /// The ball ahead: x, y, vx, vy, absolute spin, orbital speed.
    next: [Vec<Block>; 6],
    /// What the contact with the ball ahead puts on a ball, and with the ball behind.
    ahead: [Vec<Block>; 3],
    behind: [Vec<Block>; 3],
    /// Largest pair deflection of each bearing, 0 if no balls touch.
    pub pair_most: [f64; MEMBERS],
    /// Whether the entries hold forces between balls.
    pairs_loaded: bool,
    /// Largest |ΔV| under load of each bearing.
    pub slip_most: [f64; MEMBERS],
}

impl Workspace {
    pub fn new(p: &Parameters) -> Self {
        let blocks = p.layout.stride / LANES;
        let zero = || vec![Block::ZERO; blocks];
        Self {
            entries: vec![Entry::ZERO; blocks],
            sums: Sums::ZERO,
            next: std::array::from_fn(|_| zero()),
            ahead: std::array::from_fn(|_| zero()),
            behind: std::array::from_fn(|_| zero()),
            pair_most: [0.0; MEMBERS],
            pairs_loaded: false,
            slip_most: [0.0; MEMBERS],
        }
    }
}

#[inline(always)]
pub(super) fn evaluate(p: &Parameters, w: &mut Workspace, y: &[f64], dydt: &mut [f64]) {
    match (p.profile, p.law) {
        (Profile::Physical, FrictionLaw::Smooth) => equations::<false, false>(p, w, y, dydt),
        (Profile::Physical, FrictionLaw::Coulomb) => equations::<false, true>(p, w, y, dydt),
        (Profile::Paper, FrictionLaw::Smooth) => equations::<true, false>(p, w, y, dydt),
        (Profile::Paper, FrictionLaw::Coulomb) => equations::<true, true>(p, w, y, dydt),
    }
}

/// A block of neighbouring entries of a vector.
#[inline(always)]
fn block_at(values: &[f64], at: usize) -> &[f64; LANES] {
    values[at..]
        .first_chunk()
        .expect("arrays are padded to whole blocks")
}

#[inline(always)]
fn block_mut(values: &mut [f64], at: usize) -> &mut [f64; LANES] {
    values[at..]
        .first_chunk_mut()
        .expect("arrays are padded to whole blocks")
}

/// x, y, vx, vy, spin of a block.
type Motion<'a> = [&'a [f64; LANES]; 5];

#[inline(always)]
fn equations<const PAPER: bool, const COULOMB: bool>(
    p: &Parameters,
    w: &mut Workspace,
    y: &[f64],
    dydt: &mut [f64],
) {
    let n = p.layout.stride;
    assert!(y.len() == p.layout.len() && dydt.len() == y.len());
    assert!(w.entries.len() * LANES == n);
    let alone = p.layout.members() == 1;
    let mut ring = [Block::ZERO; 4];
    for k in 0..4 {
        if alone {
            ring[k] = Block::all(y[5 * n + k]);
        } else {
            let of = &y[5 * n + k * MEMBERS..][..MEMBERS];
            for l in 0..LANES {
                ring[k].0[l] = of[l % MEMBERS];
            }
        }
    }
    w.sums.clear(alone);
    let mut slip_most = Block::ZERO;
    let mut s = Scratch::ZERO;
    let mut shares = [Block::ZERO; Sum::COUNT];
    for (block, entry) in w.entries.iter_mut().enumerate() {
        let at = block * LANES;
        let motion = [
            block_at(y, at),
            block_at(y, n + at),
            block_at(y, 2 * n + at),
            block_at(y, 3 * n + at),
            block_at(y, 4 * n + at),
        ];
        let ball = p.ball(block);
        positions::<PAPER>(ball, entry, &mut s, motion);
        for groove in &p.grooves {
            raceway::<PAPER>(p, groove, entry, &mut s);
        }
        outer_contact::<PAPER, COULOMB>(p, ball, entry, &s, &mut shares, motion);
        if p.unequal {
            uphill_force(entry, &mut s);
        }
        inner_contact::<PAPER, COULOMB>(p, ball, entry, &mut shares, motion, &ring);
        slips(entry, &mut slip_most);
        add(&mut w.sums, &Sum::ALWAYS, &shares, alone, block);
        if PAPER {
            add(&mut w.sums, &Sum::PAPER, &shares, alone, block);
        }
    }
    w.slip_most = most(&slip_most, alone);
    w.pair_most = most(&pair_deflections(p, w, y), alone);
    if w.pair_most.iter().any(|d| *d > 0.0) {
        pair_contact::<PAPER, COULOMB>(p, w, y);
        w.pairs_loaded = true;
    } else if w.pairs_loaded {
        for entry in &mut w.entries {
            // The last contact would be seen otherwise.
            entry.pair_force = Block::ZERO;
            entry.pair_rate = Block::ZERO;
        }
        w.pairs_loaded = false;
    }
    accelerations(p, w, y, dydt);
    if alone {
        ring_and_ledger::<PAPER>(p, 0, &ring, &|sum| w.sums.alone(sum), dydt);
    } else {
        for member in 0..MEMBERS {
            ring_and_ledger::<PAPER>(p, member, &ring, &|sum| w.sums.beside(sum, member), dydt);
        }
    }
}

#[inline(always)]
fn add(sums: &mut Sums, which: &[Sum], shares: &Shares, alone: bool, block: usize) {
    if alone {
        sums.add_alone(which, shares);
    } else {
        sums.add_beside(which, shares, block);
    }
}

/// e, |rb|, vt, vr of every ball, and r and the direction of outer friction on the
/// plain raceway.
#[inline(always)]
fn positions<const PAPER: bool>(
    ball: &BallBlock,
    entry: &mut Entry,
    s: &mut Scratch,
    [x, y, vx, vy, spin]: Motion<'_>,
) {
    for l in 0..LANES {
        let rho = (x[l] * x[l] + y[l] * y[l]).sqrt();
        let inverse = 1.0 / rho;
        let (ex, ey) = (x[l] * inverse, y[l] * inverse);
        let vt = vy[l] * ex - vx[l] * ey;
        let orbit = vt * inverse;
        s.rho.0[l] = rho;
        s.vt.0[l] = vt;
        s.approach.0[l] = vx[l] * ex + vy[l] * ey;
        s.touching.0[l] = ball.touching.0[l];
        entry.ex.0[l] = ex;
        entry.ey.0[l] = ey;
        entry.orbit.0[l] = orbit;
        entry.absolute.0[l] = if PAPER { spin[l] - orbit } else { spin[l] };
        entry.radius.0[l] = ball.radius.0[l];
        if PAPER {
            entry.dir_x.0[l] = -ey;
            entry.dir_y.0[l] = ex;
            entry.inside.0[l] = 0.0;
        }
    }
}

/// r on a discrete raceway (Zhao 2022, Eq. (6)) and, in the `paper` profile, the
/// direction of friction there, (1, y′)/√(1 + y′² + z′²), the in-plane part of r_f.
#[inline(always)]
fn raceway<const PAPER: bool>(p: &Parameters, g: &GrooveBlock, entry: &mut Entry, s: &mut Scratch) {
    for l in 0..LANES {
        // sin and cos of ψ from the middle of the raceway.
        let sine = entry.ex.0[l] * g.cos_centre.0[l] + entry.ey.0[l] * g.sin_centre.0[l];
        let cosine = entry.ex.0[l] * g.sin_centre.0[l] - entry.ey.0[l] * g.cos_centre.0[l];
        let square = sine * sine;
        s.u.0[l] = square * g.scale.0[l] + g.shift.0[l];
        s.cosine.0[l] = cosine;
        s.sine.0[l] = if cosine > 0.0 && square < g.end.0[l] {
            sine
        } else {
            2.0
        };
    }
    polynomial(&g.radius, &s.u, &mut s.p);
    if PAPER {
        polynomial(&g.direction, &s.u, &mut s.q);
        for l in 0..LANES {
            let x = (s.p.0[l] + p.path_radius.0[l]) * s.sine.0[l];
            let slope = x * (g.slope[0].0[l] * x * x + g.slope[1].0[l]);
            let along = s.q.0[l];
            let across = along * slope;
            let dir_x = along * g.cos_centre.0[l] - across * g.sin_centre.0[l];
            let dir_y = along * g.sin_centre.0[l] + across * g.cos_centre.0[l];
            let inside = s.sine.0[l] <= 1.0;
            entry.dir_x.0[l] = if inside { dir_x } else { entry.dir_x.0[l] };
            entry.dir_y.0[l] = if inside { dir_y } else { entry.dir_y.0[l] };
        }
    }
    if p.unequal {
        polynomial(&g.radius_slope, &s.u, &mut s.slope);
        seats(p, g, entry, s);
    }
    for l in 0..LANES {
        let inside = s.sine.0[l] <= 1.0;
        entry.radius.0[l] = if inside { s.p.0[l] } else { entry.radius.0[l] };
        if PAPER {
            entry.inside.0[l] = if inside { 1.0 } else { entry.inside.0[l] };
        }
    }
}

/// Seats of balls of other radii or in a raceway milled too deep, see [`crate::seat`]. With
/// f = Re − Rw, c = r/Rw and g = Re + e − R the ball's centre lies h = √(g² − f²(1 − c²))
/// beyond Oe, and the seat rises by dT/dψ = (g e′ + f² c c′)/h − f c′. r of the nominal ball
/// comes in p and that of the ball itself leaves in it.
#[inline(always)]
fn seats(p: &Parameters, g: &GrooveBlock, entry: &Entry, s: &mut Scratch) {
    for l in 0..LANES {
        let inside = s.sine.0[l] <= 1.0;
        let (sine, cosine) = (s.sine.0[l], s.cosine.0[l]);
        let c = s.p.0[l] / p.ball_radius.0[l];
        // e = E (1 − sin²ψ/sin²θ)².
        let depth = 1.0 - sine * sine * g.inverse_end.0[l];
        let error = g.error.0[l] * depth * depth;
        let (flank, own) = (p.flank.0[l], p.curvature.0[l] + error - entry.radius.0[l]);
        let h = (own * own - flank * flank * (1.0 - c * c)).sqrt();
        // d(sin²ψ)/dψ, and u = scale sin²ψ + shift.
        let turning = 2.0 * sine * cosine;
        let c_slope = s.slope.0[l] * g.scale.0[l] * turning / p.ball_radius.0[l];
        let error_slope = -2.0 * g.error.0[l] * depth * g.inverse_end.0[l] * turning;
        let incline = (own * error_slope + flank * flank * c * c_slope) / h - flank * c_slope;
        let touching = p.path_radius.0[l] + h - flank * c;
        let incline = if inside { incline } else { 0.0 };
        s.touching.0[l] = if inside { touching } else { s.touching.0[l] };
        s.incline.0[l] += incline;
        s.approach.0[l] -= incline * entry.orbit.0[l];
        s.p.0[l] = entry.radius.0[l] * h / own;
    }
}

/// Σ c_k u^k from the sums of its even and its odd powers, which do not wait for each other.
#[inline(always)]
fn polynomial(coefficients: &[[Block; 2]], u: &Block, value: &mut Block) {
    let (mut even, mut odd) = ([0.0; LANES], [0.0; LANES]);
    for [c0, c1] in coefficients.iter().rev() {
        for l in 0..LANES {
            let square = u.0[l] * u.0[l];
            even[l] = even[l] * square + c0.0[l];
            odd[l] = odd[l] * square + c1.0[l];
        }
    }
    for l in 0..LANES {
        value.0[l] = even[l] + odd[l] * u.0[l];
    }
}

/// Friction force along −ΔV under normal force N: μ·tanh(ΔV/scale)·N, or Coulomb's
/// cone with the relaxed stick explained at `STICK_SHARE`.
#[inline(always)]
fn friction<const COULOMB: bool>(p: &Parameters, l: usize, slip: f64, normal: f64) -> f64 {
    let most = p.friction.0[l] * normal;
    if COULOMB {
        let wanted = p.stick_gain.0[l] * slip;
        let bounded = if wanted > most { most } else { wanted };
        if bounded < -most { -most } else { bounded }
    } else {
        most * tanh(slip * p.inverse_slip_scale.0[l])
    }
}

/// K δ^(3/2) + c √δ dδ/dt, never below zero; and what damping takes, (F − K δ^(3/2)) dδ/dt.
#[inline(always)]
fn normal_force(stiffness: f64, damping: f64, deflection: f64, rate: f64) -> (f64, f64) {
    let root = deflection.sqrt();
    let elastic = stiffness * deflection * root;
    let damped = elastic + damping * root * rate;
    let force = if damped > 0.0 { damped } else { 0.0 };
    (force, (force - elastic) * rate)
}

#[inline(always)]
fn above_zero(x: f64) -> f64 {
    if x > 0.0 { x } else { 0.0 }
}

/// Outer raceway: δo = |rb| − (Ro − Rw), Fo, and 2μF′o = μ·Fo·Rw/r with arm r
/// (Zhao 2022, Eq. (18), (19), (22)); starts the sums over contacts.
#[inline(always)]
fn outer_contact<const PAPER: bool, const COULOMB: bool>(
    p: &Parameters,
    ball: &BallBlock,
    entry: &mut Entry,
    s: &Scratch,
    shares: &mut Shares,
    [_, _, vx, vy, spin]: Motion<'_>,
) {
    for l in 0..LANES {
        let deflection = s.rho.0[l] - s.touching.0[l];
        let orbit = entry.orbit.0[l];
        let (force, loss) = normal_force(
            ball.outer_stiffness.0[l],
            ball.damping.0[l],
            above_zero(deflection),
            s.approach.0[l],
        );
        let r = entry.radius.0[l];
        let (ex, ey, vt, spin) = (entry.ex.0[l], entry.ey.0[l], s.vt.0[l], spin[l]);
        // Zhao 2022, Eq. (1), or the surface velocity of the ball.
        let slip = if PAPER {
            orbit * (r + p.pitch_radius.0[l]) - spin * r
        } else {
            vt - spin * r
        };
        let friction = friction::<COULOMB>(p, l, slip, force * ball.radius.0[l] / r);
        let (dir_x, dir_y) = if PAPER {
            (entry.dir_x.0[l], entry.dir_y.0[l])
        } else {
            (-ey, ex)
        };
        let mut fx = -force * ex - friction * dir_x;
        let mut fy = -force * ey - friction * dir_y;
        if PAPER {
            // Zhao 2022, Eq. (15).
            let centrifugal = ball.mass.0[l] * vt * vt / p.pitch_radius.0[l];
            fx += centrifugal * ex;
            fy += centrifugal * ey;
            shares[Sum::Centrifugal as usize].0[l] = centrifugal * (vx[l] * ex + vy[l] * ey);
            shares[Sum::Direction as usize].0[l] =
                friction * (vt - (dir_x * vx[l] + dir_y * vy[l]));
            shares[Sum::Frame as usize].0[l] = friction * (slip + spin * r - vt);
        }
        let weight = ball.mass.0[l] * p.gravity.0[l];
        entry.outer_deflection.0[l] = deflection;
        entry.outer_force.0[l] = force;
        entry.outer_slip.0[l] = slip;
        entry.outer_friction.0[l] = friction;
        entry.fx.0[l] = fx;
        entry.fy.0[l] = fy - weight;
        entry.torque.0[l] = r * friction;
        shares[Sum::Weight as usize].0[l] = -weight * vy[l];
        shares[Sum::OuterLoss as usize].0[l] = friction * slip;
        shares[Sum::DampingLoss as usize].0[l] = loss;
    }
}

/// Force along ψ of an outer contact whose seat rises, −Fo·grad δo.
#[inline(always)]
fn uphill_force(entry: &mut Entry, s: &mut Scratch) {
    for l in 0..LANES {
        let uphill = entry.outer_force.0[l] * s.incline.0[l] / s.rho.0[l];
        entry.uphill.0[l] = uphill;
        entry.fx.0[l] -= uphill * entry.ey.0[l];
        entry.fy.0[l] += uphill * entry.ex.0[l];
        s.incline.0[l] = 0.0;
    }
}

/// Inner raceway: δi = Ri + Rw − |rb − ri| and friction (Zhao 2022, Eq. (16), (20)).
#[inline(always)]
fn inner_contact<const PAPER: bool, const COULOMB: bool>(
    p: &Parameters,
    ball: &BallBlock,
    entry: &mut Entry,
    shares: &mut Shares,
    [x, y, vx, vy, spin]: Motion<'_>,
    ring: &[Block; 4],
) {
    for l in 0..LANES {
        let (dx, dy) = (x[l] - ring[0].0[l], y[l] - ring[1].0[l]);
        let distance = (dx * dx + dy * dy).sqrt();
        let inverse = 1.0 / distance;
        let (ex, ey) = (dx * inverse, dy * inverse);
        let (vx, vy) = (vx[l] - ring[2].0[l], vy[l] - ring[3].0[l]);
        let vt = vy * ex - vx * ey;
        let rate = -(vx * ex + vy * ey);
        let deflection = ball.reach.0[l] - distance;
        let (force, loss) = normal_force(
            ball.inner_stiffness.0[l],
            ball.damping.0[l],
            above_zero(deflection),
            rate,
        );
        let spin = spin[l];
        let radius = ball.radius.0[l];
        // Zhao 2022, Eq. (2), or the surface velocities of ring and ball.
        let carried = if PAPER {
            vt * inverse * p.inner_radius.0[l]
        } else {
            vt
        };
        let slip = p.surface_speed.0[l] - (carried + spin * radius);
        let friction = friction::<COULOMB>(p, l, slip, force);
        let fx = force * ex - friction * ey;
        let fy = force * ey + friction * ex;
        entry.inner_deflection.0[l] = deflection;
        entry.inner_force.0[l] = force;
        entry.inner_slip.0[l] = slip;
        entry.fx.0[l] += fx;
        entry.fy.0[l] += fy;
        entry.torque.0[l] += radius * friction;
        shares[Sum::RingX as usize].0[l] = -fx;
        shares[Sum::RingY as usize].0[l] = -fy;
        shares[Sum::Drive as usize].0[l] = friction * p.surface_speed.0[l];
        shares[Sum::InnerLoss as usize].0[l] = friction * slip;
        shares[Sum::DampingLoss as usize].0[l] += loss;
        if PAPER {
            shares[Sum::Frame as usize].0[l] += friction * (vt - carried);
        }
    }
}

/// Largest |ΔV| at contacts that carry load.
#[inline(always)]
fn slips(entry: &Entry, most: &mut Block) {
    for l in 0..LANES {
        let loaded = |slip: f64, force: f64| if force > 0.0 { slip.abs() } else { 0.0 };
        let inner = loaded(entry.inner_slip.0[l], entry.inner_force.0[l]);
        let outer = loaded(entry.outer_slip.0[l], entry.outer_force.0[l]);
        let larger = if inner > outer { inner } else { outer };
        most.0[l] = if larger > most.0[l] {
            larger
        } else {
            most.0[l]
        };
    }
}

/// Largest of the lanes of each bearing; of the only one it comes first.
#[inline(always)]
fn most(lanes: &Block, alone: bool) -> [f64; MEMBERS] {
    let larger = |a: f64, b: f64| if b > a { b } else { a };
    let mut most = [0.0; MEMBERS];
    for l in 0..LANES {
        most[l % MEMBERS] = larger(most[l % MEMBERS], lanes.0[l]);
    }
    if alone {
        for k in 1..MEMBERS {
            most[0] = larger(most[0], most[k]);
        }
    }
    most
}

/// δb of each ball with the ball ahead (Zhao 2022, Eq. (17)); returns the largest.
#[inline(always)]
fn pair_deflections(p: &Parameters, w: &mut Workspace, y: &[f64]) -> Block {
    let n = p.layout.stride;
    for group in 0..2 {
        forwards(p, &y[group * n..][..n], &mut w.next[group]);
    }
    let mut most = Block::ZERO;
    let [next_x, next_y, ..] = &w.next;
    for (block, entry) in w.entries.iter_mut().enumerate() {
        let ball = p.ball(block);
        let (x, y) = (block_at(y, block * LANES), block_at(y, n + block * LANES));
        let (next_x, next_y) = (&next_x[block].0, &next_y[block].0);
        for l in 0..LANES {
            let (dx, dy) = (next_x[l] - x[l], next_y[l] - y[l]);
            let distance = (dx * dx + dy * dy).sqrt();
            let deflection = ball.pair_distance.0[l] - distance;
            entry.pair_deflection.0[l] = deflection;
            most.0[l] = if deflection > most.0[l] {
                deflection
            } else {
                most.0[l]
            };
        }
    }
    most
}

/// Values of the ball ahead at the place of each ball.
#[inline(always)]
fn forwards(p: &Parameters, values: &[f64], next: &mut [Block]) {
    let (shift, count) = (p.layout.members(), p.layout.entries());
    let next = flat_mut(next);
    next[..count - shift].copy_from_slice(&values[shift..count]);
    next[count - shift..count].copy_from_slice(&values[..shift]);
}

/// Values of the ball behind at the place of each ball.
#[inline(always)]
fn backwards(p: &Parameters, values: &[Block], behind: &mut [Block]) {
    let (shift, count) = (p.layout.members(), p.layout.entries());
    let (values, behind) = (flat(values), flat_mut(behind));
    behind[shift..count].copy_from_slice(&values[..count - shift]);
    behind[..shift].copy_from_slice(&values[count - shift..count]);
}

#[inline(always)]
fn flat(blocks: &[Block]) -> &[f64] {
    // SAFETY: a block is eight f64 without padding (repr C, 64 bytes, aligned to 64).
    unsafe { std::slice::from_raw_parts(blocks.as_ptr().cast(), blocks.len() * LANES) }
}

#[inline(always)]
fn flat_mut(blocks: &mut [Block]) -> &mut [f64] {
    // SAFETY: as above.
    unsafe { std::slice::from_raw_parts_mut(blocks.as_mut_ptr().cast(), blocks.len() * LANES) }
}

/// Normal force and friction between neighbours.
#[inline(always)]
fn pair_contact<const PAPER: bool, const COULOMB: bool>(
    p: &Parameters,
    w: &mut Workspace,
    y: &[f64],
) {
    let n = p.layout.stride;
    for group in 2..4 {
        forwards(p, &y[group * n..][..n], &mut w.next[group]);
    }
    for (at, entry) in w.entries.iter().enumerate() {
        w.ahead[0][at] = entry.absolute;
        w.ahead[1][at] = entry.orbit;
    }
    for (group, from) in [(4, 0), (5, 1)] {
        let values = flat(&w.ahead[from]);
        forwards(p, values, &mut w.next[group]);
    }
    let [ahead_x, ahead_y, ahead_torque] = &mut w.ahead;
    let [behind_x, behind_y, behind_torque] = &mut w.behind;
    let mut shares = [Block::ZERO; Sum::COUNT];
    for (block, entry) in w.entries.iter_mut().enumerate() {
        let (ball, at) = (p.ball(block), block * LANES);
        let (x, y, vx, vy) = (
            block_at(y, at),
            block_at(y, n + at),
            block_at(y, 2 * n + at),
            block_at(y, 3 * n + at),
        );
        let next = |k: usize| &w.next[k][block].0;
        let (next_x, next_y, next_vx, next_vy) = (next(0), next(1), next(2), next(3));
        let (next_spin, next_orbit) = (next(4), next(5));
        let (fx, fy) = (&mut ahead_x[block].0, &mut ahead_y[block].0);
        let (torque, next_torque) = (&mut ahead_torque[block].0, &mut behind_torque[block].0);
        for l in 0..LANES {
            let (dx, dy) = (next_x[l] - x[l], next_y[l] - y[l]);
            let inverse = 1.0 / (dx * dx + dy * dy).sqrt();
            let (ux, uy) = (dx * inverse, dy * inverse);
            let (vx, vy) = (vx[l] - next_vx[l], vy[l] - next_vy[l]);
            let rate = vx * ux + vy * uy;
            let deflection = above_zero(entry.pair_deflection.0[l]);
            // δ^(1/4): the root of the root.
            let root = deflection.sqrt();
            let elastic = ball.pair_stiffness.0[l] * deflection * root;
            let damped = elastic + ball.pair_damping.0[l] * root.sqrt() * rate;
            let force = if damped > 0.0 { damped } else { 0.0 };
            let (radius, next_radius) = (ball.radius.0[l], ball.next_radius.0[l]);
            // p is u turned by +90°.
            let surface = entry.absolute.0[l] * radius + next_spin[l] * next_radius;
            let slip = vy * ux - vx * uy - surface;
            let friction = friction::<COULOMB>(p, l, slip, force);
            entry.pair_rate.0[l] = rate;
            entry.pair_force.0[l] = force;
            fx[l] = -force * ux + friction * uy;
            fy[l] = -force * uy - friction * ux;
            torque[l] = radius * friction;
            next_torque[l] = next_radius * friction;
            shares[Sum::BallLoss as usize].0[l] = friction * slip;
            shares[Sum::PairDamping as usize].0[l] = (force - elastic) * rate;
            if PAPER {
                let turning = radius * entry.orbit.0[l] + next_radius * next_orbit[l];
                shares[Sum::PairFrame as usize].0[l] = friction * turning;
            }
        }
        let alone = p.layout.members() == 1;
        add(&mut w.sums, &Sum::TOUCHING, &shares, alone, block);
        if PAPER {
            add(&mut w.sums, &[Sum::PairFrame], &shares, alone, block);
        }
    }
    // Each contact acts on the ball ahead, too. The torques there wait in `behind`.
    let [.., scratch, _] = &mut w.next;
    scratch.copy_from_slice(behind_torque);
    backwards(p, scratch, behind_torque);
    backwards(p, ahead_x, behind_x);
    backwards(p, ahead_y, behind_y);
    for (block, entry) in w.entries.iter_mut().enumerate() {
        for l in 0..LANES {
            entry.fx.0[l] = entry.fx.0[l] - behind_x[block].0[l] + ahead_x[block].0[l];
            entry.fy.0[l] = entry.fy.0[l] - behind_y[block].0[l] + ahead_y[block].0[l];
            entry.torque.0[l] =
                entry.torque.0[l] + behind_torque[block].0[l] + ahead_torque[block].0[l];
        }
    }
}

/// Accelerations of the balls (Zhao 2022, Eq. (12), (13)).
#[inline(always)]
fn accelerations(p: &Parameters, w: &Workspace, y: &[f64], dydt: &mut [f64]) {
    let n = p.layout.stride;
    dydt[..2 * n].copy_from_slice(&y[2 * n..4 * n]);
    for (block, entry) in w.entries.iter().enumerate() {
        let ball = p.ball(block);
        let at = block * LANES;
        let shares = [
            (2, &entry.fx, &ball.inverse_mass),
            (3, &entry.fy, &ball.inverse_mass),
            (4, &entry.torque, &ball.inverse_inertia),
        ];
        for (group, sum, inverse) in shares {
            let rates = block_mut(dydt, group * n + at);
            for l in 0..LANES {
                rates[l] = sum.0[l] * inverse.0[l];
            }
        }
    }
}

/// Acceleration of the inner ring (Zhao 2022, Eq. (14)) and the powers of the energy ledger
/// of one bearing.
#[inline(always)]
fn ring_and_ledger<const PAPER: bool>(
    p: &Parameters,
    member: usize,
    ring: &[Block; 4],
    total: &impl Fn(Sum) -> f64,
    dydt: &mut [f64],
) {
    let layout = p.layout.of_member(member);
    let of = |block: &Block| block.0[member];
    let (mass, drag, load) = (of(&p.ring_mass), of(&p.ring_drag), of(&p.radial_load));
    let (vx, vy) = (of(&ring[2]), of(&ring[3]));
    let weight = mass * of(&p.gravity);
    dydt[layout.ring(0)] = vx;
    dydt[layout.ring(1)] = vy;
    dydt[layout.ring(2)] = (total(Sum::RingX) - drag * vx) / mass;
    dydt[layout.ring(3)] = (total(Sum::RingY) - drag * vy - load - weight) / mass;
    let mut power = |work: Work, value: f64| dydt[layout.work(work)] = value;
    power(Work::Drive, total(Sum::Drive));
    power(Work::Load, -load * vy);
    power(Work::Weight, total(Sum::Weight) - weight * vy);
    power(Work::InnerFriction, total(Sum::InnerLoss));
    power(Work::OuterFriction, total(Sum::OuterLoss));
    power(Work::BallFriction, total(Sum::BallLoss));
    let damping = total(Sum::DampingLoss) + total(Sum::PairDamping);
    power(Work::Damping, damping);
    power(Work::Drag, drag * (vx * vx + vy * vy));
    if PAPER {
        power(Work::Centrifugal, total(Sum::Centrifugal));
        power(Work::Direction, total(Sum::Direction));
        power(Work::Frame, total(Sum::Frame) + total(Sum::PairFrame));
    } else {
        power(Work::Centrifugal, 0.0);
        power(Work::Direction, 0.0);
        power(Work::Frame, 0.0);
    }
}
