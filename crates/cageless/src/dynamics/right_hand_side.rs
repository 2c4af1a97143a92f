//! The right-hand side, once, for every instruction set.
//!
//! The body is a sequence of plain loops over the balls; [`RightHandSide`] holds it
//! compiled for several instruction sets and picks one at run time. No operation
//! depends on the width of a vector and none is fused, so all give the same bits.

use super::lanes::{Lane, Lanes, sum};
use super::model::{Groove, Model};
use crate::case::{FrictionLaw, Profile};
use crate::integrator::{Drift, System};
use crate::snapshot::{RingSnapshot, Snapshot};
use crate::state::{BALLS_MAX, LANES, State, Work};
use crate::traction::tanh;

/// Vector instructions that the right-hand side was compiled for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum InstructionSet {
    /// What every processor of the target has.
    Baseline,
    /// 256-bit vectors (x86-64).
    Avx2,
    /// 512-bit vectors (x86-64).
    Avx512,
}

impl InstructionSet {
    /// The widest that this processor has.
    pub fn detect() -> Self {
        #[cfg(target_arch = "x86_64")]
        {
            if std::arch::is_x86_feature_detected!("avx512f")
                && std::arch::is_x86_feature_detected!("avx512vl")
                && std::arch::is_x86_feature_detected!("avx512dq")
            {
                return Self::Avx512;
            }
            if std::arch::is_x86_feature_detected!("avx2") {
                return Self::Avx2;
            }
        }
        Self::Baseline
    }

    /// Name in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Baseline => "baseline",
            Self::Avx2 => "avx2",
            Self::Avx512 => "avx512",
        }
    }
}

/// The model with the work arrays to evaluate it.
#[derive(Clone)]
pub struct RightHandSide<'m> {
    model: &'m Model,
    lanes: Box<Lanes>,
    isa: InstructionSet,
    evaluations: u64,
    drifts: [Drift; 2],
}

impl<'m> RightHandSide<'m> {
    /// For the widest instructions of this processor.
    pub fn new(model: &'m Model) -> Self {
        Self::with_instruction_set(model, InstructionSet::detect())
    }

    /// For given instructions; wider ones than the processor has are replaced by its
    /// own widest.
    pub fn with_instruction_set(model: &'m Model, isa: InstructionSet) -> Self {
        let widest = InstructionSet::detect();
        let isa = if isa as u8 > widest as u8 {
            widest
        } else {
            isa
        };
        let layout = model.layout;
        let at = layout.ring();
        let balls = Drift {
            places: layout.group(0),
            rates: layout.group(2),
            count: 2 * layout.stride,
        };
        let ring = Drift {
            places: at,
            rates: at + 2,
            count: 2,
        };
        Self {
            model,
            lanes: Lanes::new(model.balls()),
            isa,
            evaluations: 0,
            drifts: [balls, ring],
        }
    }

    /// The model.
    pub fn model(&self) -> &'m Model {
        self.model
    }

    /// Instructions in use.
    pub fn instruction_set(&self) -> InstructionSet {
        self.isa
    }

    /// Evaluations so far.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    fn evaluate(&mut self, y: &[f64], dydt: &mut [f64]) {
        self.evaluations += 1;
        let (m, l) = (self.model, &mut *self.lanes);
        match self.isa {
            InstructionSet::Baseline => body(m, l, y, dydt),
            // SAFETY: `with_instruction_set` admits only what the processor has.
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx2 => unsafe { body_avx2(m, l, y, dydt) },
            // SAFETY: as above.
            #[cfg(target_arch = "x86_64")]
            InstructionSet::Avx512 => unsafe { body_avx512(m, l, y, dydt) },
            #[cfg(not(target_arch = "x86_64"))]
            _ => body(m, l, y, dydt),
        }
    }

    /// Normal forces of the pair contacts (entry k: ball k and the ball ahead), their
    /// deflections and the rates of these, as of the last evaluation.
    pub fn pairs(&self) -> (&[f64], &[f64], &[f64]) {
        let n = self.model.balls();
        let l = &self.lanes;
        (
            &l.pair_force[..n],
            &l.pair_deflection[..n],
            &l.pair_rate[..n],
        )
    }

    /// Normal forces at the inner and outer raceway as of the last evaluation.
    pub fn normal_forces(&self) -> (&[f64], &[f64]) {
        let n = self.model.balls();
        (&self.lanes.inner_force[..n], &self.lanes.outer_force[..n])
    }

    /// ΔVi and ΔVo as of the last evaluation.
    pub fn slips(&self) -> (&[f64], &[f64]) {
        let n = self.model.balls();
        (&self.lanes.inner_slip[..n], &self.lanes.outer_slip[..n])
    }

    /// Deflections at the inner and outer raceway (negative: apart), as of the last
    /// evaluation.
    pub fn deflections(&self) -> (&[f64], &[f64]) {
        let n = self.model.balls();
        (
            &self.lanes.inner_deflection[..n],
            &self.lanes.outer_deflection[..n],
        )
    }

    /// What the balls put on the outer ring, friction included, as of the last evaluation.
    pub fn outer_ring_force_n(&self) -> [f64; 2] {
        let l = &self.lanes;
        (0..self.model.balls()).fold([0.0; 2], |[x, y], j| {
            [
                x + l.outer_force[j] * l.ex[j] + l.outer_friction[j] * l.dir_x[j],
                y + l.outer_force[j] * l.ey[j] + l.outer_friction[j] * l.dir_y[j],
            ]
        })
    }

    /// Everything that can be seen of `state`. `angle_rad` are the continuous ψ of its
    /// balls, which the state alone does not know beyond a turn.
    pub fn snapshot(&mut self, time_s: f64, state: &State, angle_rad: &[f64]) -> Snapshot {
        let mut rate = vec![0.0; state.layout().len()];
        self.evaluate(state.values(), &mut rate);
        let n = self.model.balls();
        let l = &self.lanes;
        let take = |lane: &[f64; BALLS_MAX]| lane[..n].to_vec();
        let at = state.layout().ring();
        let [x_m, y_m, vx_m_s, vy_m_s] = state.ring();
        let [outer_force_x_n, outer_force_y_n] = self.outer_ring_force_n();
        Snapshot {
            time_s,
            angle_rad: angle_rad.to_vec(),
            x_m: take(&l.x),
            y_m: take(&l.y),
            vx_m_s: take(&l.vx),
            vy_m_s: take(&l.vy),
            spin_rad_s: take(&l.absolute),
            orbit_speed_rad_s: (0..n).map(|j| l.vt[j] / l.rho[j]).collect(),
            gap_rad: (0..n)
                .map(|j| {
                    let ahead = (j + 1) % n;
                    let turn = if ahead == 0 {
                        std::f64::consts::TAU
                    } else {
                        0.0
                    };
                    angle_rad[ahead] + turn - angle_rad[j] - self.model.ball_angle
                })
                .collect(),
            effective_radius_m: take(&l.radius),
            inner_force_n: take(&l.inner_force),
            outer_force_n: take(&l.outer_force),
            inner_slip_m_s: take(&l.inner_slip),
            outer_slip_m_s: take(&l.outer_slip),
            ring: RingSnapshot {
                x_m,
                y_m,
                vx_m_s,
                vy_m_s,
                ax_m_s2: rate[at + 2],
                ay_m_s2: rate[at + 3],
                outer_force_x_n,
                outer_force_y_n,
            },
        }
    }
}

impl System for RightHandSide<'_> {
    fn dimension(&self) -> usize {
        self.model.layout.len()
    }

    fn derivative(&mut self, _time_s: f64, y: &[f64], dydt: &mut [f64]) {
        self.evaluate(y, dydt);
    }

    /// Damped contacts, whose force starts with infinite slope and ends with a kink where
    /// it is clamped at zero, and, in the `paper` profile, the raceway's ends, where the
    /// direction of friction jumps.
    fn regime(&self) -> u64 {
        let (m, l) = (self.model, &self.lanes);
        let phase = |damped: bool, deflection: f64, force: f64| {
            if damped {
                u64::from(deflection > 0.0) + u64::from(force > 0.0)
            } else {
                0
            }
        };
        let (raceways, balls) = (m.damping > 0.0, m.ball_damping > 0.0);
        let mut hash = 0u64;
        for j in 0..m.balls() {
            let bits = phase(raceways, l.inner_deflection[j], l.inner_force[j])
                | phase(raceways, l.outer_deflection[j], l.outer_force[j]) << 2
                | phase(balls, l.pair_deflection[j], l.pair_force[j]) << 4
                | u64::from(m.profile == Profile::Paper && l.inside[j] > 0.0) << 6;
            hash = (hash ^ bits)
                .wrapping_mul(0x0000_0100_0000_01b3)
                .rotate_left(5);
        }
        hash
    }

    fn drifts(&self) -> &[Drift] {
        &self.drifts
    }

    fn error_norm(&self, difference: &[f64]) -> f64 {
        // Scales of the reference trajectories: what moves visibly within one passage.
        const SCALES: [f64; 5] = [1e-5, 1e-5, 1.0, 1.0, 200.0];
        const RING: [f64; 4] = [1e-5, 1e-5, 0.1, 0.1];
        let layout = self.model.layout;
        let mut sum = 0.0;
        for (group, scale) in SCALES.iter().enumerate() {
            for d in &difference[layout.group(group)..][..layout.balls] {
                sum += (d / scale).powi(2);
            }
        }
        for (d, scale) in difference[layout.ring()..].iter().zip(RING) {
            sum += (d / scale).powi(2);
        }
        (sum / (5 * layout.balls + 4) as f64).sqrt()
    }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2")]
fn body_avx2(m: &Model, l: &mut Lanes, y: &[f64], dydt: &mut [f64]) {
    body(m, l, y, dydt);
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx512f,avx512vl,avx512dq")]
fn body_avx512(m: &Model, l: &mut Lanes, y: &[f64], dydt: &mut [f64]) {
    body(m, l, y, dydt);
}

#[inline(always)]
fn body(m: &Model, l: &mut Lanes, y: &[f64], dydt: &mut [f64]) {
    match (m.profile, m.law) {
        (Profile::Physical, FrictionLaw::Smooth) => equations::<false, false>(m, l, y, dydt),
        (Profile::Physical, FrictionLaw::Coulomb) => equations::<false, true>(m, l, y, dydt),
        (Profile::Paper, FrictionLaw::Smooth) => equations::<true, false>(m, l, y, dydt),
        (Profile::Paper, FrictionLaw::Coulomb) => equations::<true, true>(m, l, y, dydt),
    }
}

#[inline(always)]
fn equations<const PAPER: bool, const COULOMB: bool>(
    m: &Model,
    l: &mut Lanes,
    y: &[f64],
    dydt: &mut [f64],
) {
    let n = m.layout.stride;
    assert!(n <= BALLS_MAX && y.len() == m.layout.len() && dydt.len() == y.len());
    l.x[..n].copy_from_slice(&y[..n]);
    l.y[..n].copy_from_slice(&y[n..2 * n]);
    l.vx[..n].copy_from_slice(&y[2 * n..3 * n]);
    l.vy[..n].copy_from_slice(&y[3 * n..4 * n]);
    l.spin[..n].copy_from_slice(&y[4 * n..5 * n]);
    let ring = [y[5 * n], y[5 * n + 1], y[5 * n + 2], y[5 * n + 3]];

    positions::<PAPER>(m, l, n);
    for groove in &m.grooves {
        raceway::<PAPER>(m, groove, l, n);
    }
    outer_contact::<PAPER, COULOMB>(m, l, n);
    inner_contact::<PAPER, COULOMB>(m, l, n, ring);
    let touching = pair_deflections(m, l, n);
    if touching {
        pair_contact::<PAPER, COULOMB>(m, l, n);
    }
    assemble::<PAPER>(m, l, n, ring, touching, dydt);
}

/// e, |rb|, vt, vr of every ball, and r and the direction of outer friction on the
/// plain raceway.
#[inline(always)]
fn positions<const PAPER: bool>(m: &Model, l: &mut Lanes, n: usize) {
    for j in 0..n {
        let rho = (l.x[j] * l.x[j] + l.y[j] * l.y[j]).sqrt();
        let inverse = 1.0 / rho;
        let (ex, ey) = (l.x[j] * inverse, l.y[j] * inverse);
        let vt = l.vy[j] * ex - l.vx[j] * ey;
        l.rho[j] = rho;
        l.ex[j] = ex;
        l.ey[j] = ey;
        l.vt[j] = vt;
        l.vr[j] = l.vx[j] * ex + l.vy[j] * ey;
        l.absolute[j] = if PAPER {
            l.spin[j] - vt * inverse
        } else {
            l.spin[j]
        };
        l.radius[j] = m.ball_radius;
        l.dir_x[j] = -ey;
        l.dir_y[j] = ex;
        l.inside[j] = 0.0;
    }
}

/// r on a discrete raceway (Zhao 2022, Eq. (6)) and, in the `paper` profile, the
/// direction of friction there, (1, y′)/√(1 + y′² + z′²), the in-plane part of r_f.
#[inline(always)]
fn raceway<const PAPER: bool>(m: &Model, g: &Groove, l: &mut Lanes, n: usize) {
    for j in 0..n {
        // sin and cos of ψ from the middle of the raceway.
        let sine = l.ex[j] * g.cos_centre + l.ey[j] * g.sin_centre;
        let cosine = l.ex[j] * g.sin_centre - l.ey[j] * g.cos_centre;
        let s = sine * sine;
        l.u[j] = s * g.scale + g.shift;
        l.sine[j] = if cosine > 0.0 && s < g.end { sine } else { 2.0 };
    }
    horner(&g.radius, &l.u, &mut l.p, n);
    if PAPER {
        horner(&g.direction, &l.u, &mut l.q, n);
    }
    for j in 0..n {
        let inside = l.sine[j] <= 1.0;
        l.radius[j] = if inside { l.p[j] } else { l.radius[j] };
        if PAPER {
            let x = (l.p[j] + m.touching_radius) * l.sine[j];
            let slope = x * (g.slope[0] * x * x + g.slope[1]);
            let along = l.q[j];
            let across = along * slope;
            let dir_x = along * g.cos_centre - across * g.sin_centre;
            let dir_y = along * g.sin_centre + across * g.cos_centre;
            l.dir_x[j] = if inside { dir_x } else { l.dir_x[j] };
            l.dir_y[j] = if inside { dir_y } else { l.dir_y[j] };
            l.inside[j] = if inside { 1.0 } else { l.inside[j] };
        }
    }
}

/// Σ c_k u^k for every entry; the sums of one vector of entries stay in registers.
#[inline(always)]
fn horner(coefficients: &[f64], u: &Lane, sums: &mut Lane, n: usize) {
    for (u, sums) in u[..n]
        .chunks_exact(LANES)
        .zip(sums[..n].chunks_exact_mut(LANES))
    {
        let mut sum = [0.0; LANES];
        for &c in coefficients.iter().rev() {
            for (s, u) in sum.iter_mut().zip(u) {
                *s = *s * u + c;
            }
        }
        sums.copy_from_slice(&sum);
    }
}

/// Friction force along −ΔV under normal force N: μ·tanh(ΔV/scale)·N, or Coulomb's
/// cone with the relaxed stick explained at `STICK_SHARE`.
#[inline(always)]
fn friction<const COULOMB: bool>(m: &Model, slip: f64, normal: f64) -> f64 {
    let most = m.friction * normal;
    if COULOMB {
        let wanted = m.stick_gain * slip;
        let bounded = if wanted > most { most } else { wanted };
        if bounded < -most { -most } else { bounded }
    } else {
        most * tanh(slip * m.inverse_slip_scale)
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
fn outer_contact<const PAPER: bool, const COULOMB: bool>(m: &Model, l: &mut Lanes, n: usize) {
    for j in 0..n {
        let deflection = l.rho[j] - m.touching_radius;
        let (force, loss) = normal_force(
            m.outer_stiffness,
            m.damping,
            above_zero(deflection),
            l.vr[j],
        );
        let force = force * l.active[j];
        let r = l.radius[j];
        let (ex, ey, vt, spin) = (l.ex[j], l.ey[j], l.vt[j], l.spin[j]);
        // Zhao 2022, Eq. (1), or the surface velocity of the ball.
        let slip = if PAPER {
            vt / l.rho[j] * (r + m.pitch_radius) - spin * r
        } else {
            vt - spin * r
        };
        let friction = friction::<COULOMB>(m, slip, force * m.ball_radius / r);
        let (dir_x, dir_y) = (l.dir_x[j], l.dir_y[j]);
        let mut fx = -force * ex - friction * dir_x;
        let mut fy = -force * ey - friction * dir_y;
        if PAPER {
            // Zhao 2022, Eq. (15).
            let centrifugal = m.ball_mass * vt * vt / m.pitch_radius * l.active[j];
            fx += centrifugal * ex;
            fy += centrifugal * ey;
            l.centrifugal[j] = centrifugal * l.vr[j];
            l.direction[j] = friction * (vt - (dir_x * l.vx[j] + dir_y * l.vy[j]));
            l.frame[j] = friction * (slip + spin * r - vt);
        }
        let weight = m.ball_mass * m.gravity * l.active[j];
        l.outer_deflection[j] = deflection;
        l.outer_force[j] = force;
        l.outer_slip[j] = slip;
        l.outer_friction[j] = friction;
        l.fx[j] = fx;
        l.fy[j] = fy - weight;
        l.torque[j] = r * friction;
        l.weight[j] = -weight * l.vy[j];
        l.outer_loss[j] = friction * slip;
        l.damping_loss[j] = loss * l.active[j];
    }
}

/// Inner raceway: δi = Ri + Rw − |rb − ri| and friction (Zhao 2022, Eq. (16), (20)).
#[inline(always)]
fn inner_contact<const PAPER: bool, const COULOMB: bool>(
    m: &Model,
    l: &mut Lanes,
    n: usize,
    ring: [f64; 4],
) {
    let surface_speed = m.inner_speed * m.inner_radius;
    for j in 0..n {
        let (dx, dy) = (l.x[j] - ring[0], l.y[j] - ring[1]);
        let distance = (dx * dx + dy * dy).sqrt();
        let inverse = 1.0 / distance;
        let (ex, ey) = (dx * inverse, dy * inverse);
        let (vx, vy) = (l.vx[j] - ring[2], l.vy[j] - ring[3]);
        let vt = vy * ex - vx * ey;
        let rate = -(vx * ex + vy * ey);
        let deflection = m.inner_radius + m.ball_radius - distance;
        let (force, loss) =
            normal_force(m.inner_stiffness, m.damping, above_zero(deflection), rate);
        let force = force * l.active[j];
        let spin = l.spin[j];
        // Zhao 2022, Eq. (2), or the surface velocities of ring and ball.
        let carried = if PAPER {
            vt * inverse * m.inner_radius
        } else {
            vt
        };
        let slip = surface_speed - (carried + spin * m.ball_radius);
        let friction = friction::<COULOMB>(m, slip, force);
        let fx = force * ex - friction * ey;
        let fy = force * ey + friction * ex;
        l.inner_deflection[j] = deflection;
        l.inner_force[j] = force;
        l.inner_slip[j] = slip;
        l.fx[j] += fx;
        l.fy[j] += fy;
        l.torque[j] += m.ball_radius * friction;
        l.ring_fx[j] = -fx;
        l.ring_fy[j] = -fy;
        l.drive[j] = friction * surface_speed;
        l.inner_loss[j] = friction * slip;
        l.damping_loss[j] += loss * l.active[j];
        if PAPER {
            l.frame[j] += friction * (vt - carried);
        }
    }
}

/// δb of each ball with the ball ahead (Zhao 2022, Eq. (17)), and whether any touch.
#[inline(always)]
fn pair_deflections(m: &Model, l: &mut Lanes, n: usize) -> bool {
    let last = m.layout.balls - 1;
    l.next_x[..last].copy_from_slice(&l.x[1..=last]);
    l.next_y[..last].copy_from_slice(&l.y[1..=last]);
    l.next_x[last] = l.x[0];
    l.next_y[last] = l.y[0];
    let mut most = [0.0f64; LANES];
    for j in 0..n {
        let (dx, dy) = (l.next_x[j] - l.x[j], l.next_y[j] - l.y[j]);
        l.pair_deflection[j] = (2.0 * m.ball_radius - (dx * dx + dy * dy).sqrt()) * l.active[j];
    }
    for chunk in l.pair_deflection[..n].chunks_exact(LANES) {
        for (a, b) in most.iter_mut().zip(chunk) {
            *a = if *b > *a { *b } else { *a };
        }
    }
    most.iter().any(|d| *d > 0.0)
}

/// Normal force and friction between neighbours.
#[inline(always)]
fn pair_contact<const PAPER: bool, const COULOMB: bool>(m: &Model, l: &mut Lanes, n: usize) {
    let last = m.layout.balls - 1;
    l.next_vx[..last].copy_from_slice(&l.vx[1..=last]);
    l.next_vy[..last].copy_from_slice(&l.vy[1..=last]);
    l.next_absolute[..last].copy_from_slice(&l.absolute[1..=last]);
    l.next_vx[last] = l.vx[0];
    l.next_vy[last] = l.vy[0];
    l.next_absolute[last] = l.absolute[0];
    if PAPER {
        for j in 0..=last {
            l.p[j] = l.spin[j] - l.absolute[j];
        }
        l.next_orbit[..last].copy_from_slice(&l.p[1..=last]);
        l.next_orbit[last] = l.p[0];
    }
    for j in 0..n {
        let (dx, dy) = (l.next_x[j] - l.x[j], l.next_y[j] - l.y[j]);
        let inverse = 1.0 / (dx * dx + dy * dy).sqrt();
        let (ux, uy) = (dx * inverse, dy * inverse);
        let (vx, vy) = (l.vx[j] - l.next_vx[j], l.vy[j] - l.next_vy[j]);
        let rate = vx * ux + vy * uy;
        let deflection = above_zero(l.pair_deflection[j]);
        // δ^(1/4): the root of the root.
        let root = deflection.sqrt();
        let elastic = m.ball_stiffness * deflection * root;
        let damped = elastic + m.ball_damping * root.sqrt() * rate;
        let force = if damped > 0.0 { damped } else { 0.0 };
        // p is u turned by +90°.
        let slip = vy * ux - vx * uy - (l.absolute[j] + l.next_absolute[j]) * m.ball_radius;
        let friction = friction::<COULOMB>(m, slip, force);
        l.pair_rate[j] = rate;
        l.pair_force[j] = force;
        l.pair_fx[j] = -force * ux + friction * uy;
        l.pair_fy[j] = -force * uy - friction * ux;
        l.pair_torque[j] = m.ball_radius * friction;
        l.ball_loss[j] = friction * slip;
        l.pair_damping[j] = (force - elastic) * rate;
        if PAPER {
            l.pair_frame[j] = m.ball_radius * friction * (l.p[j] + l.next_orbit[j]);
        }
    }
    // Each contact acts on the ball ahead, too.
    l.fx[0] -= l.pair_fx[last];
    l.fy[0] -= l.pair_fy[last];
    l.torque[0] += l.pair_torque[last];
    for j in 0..last {
        l.fx[j + 1] -= l.pair_fx[j];
        l.fy[j + 1] -= l.pair_fy[j];
        l.torque[j + 1] += l.pair_torque[j];
    }
    for j in 0..n {
        l.fx[j] += l.pair_fx[j];
        l.fy[j] += l.pair_fy[j];
        l.torque[j] += l.pair_torque[j];
    }
}

/// Accelerations of balls and ring (Zhao 2022, Eq. (12) to (14)) and the powers of the
/// energy ledger.
#[inline(always)]
fn assemble<const PAPER: bool>(
    m: &Model,
    l: &mut Lanes,
    n: usize,
    ring: [f64; 4],
    touching: bool,
    dydt: &mut [f64],
) {
    let (inverse_mass, inverse_inertia) = (1.0 / m.ball_mass, 1.0 / m.ball_inertia);
    dydt[..n].copy_from_slice(&l.vx[..n]);
    dydt[n..2 * n].copy_from_slice(&l.vy[..n]);
    for (a, f) in dydt[2 * n..3 * n].iter_mut().zip(&l.fx[..n]) {
        *a = f * inverse_mass;
    }
    for (a, f) in dydt[3 * n..4 * n].iter_mut().zip(&l.fy[..n]) {
        *a = f * inverse_mass;
    }
    for (a, t) in dydt[4 * n..5 * n].iter_mut().zip(&l.torque[..n]) {
        *a = t * inverse_inertia;
    }
    let force_x = sum(&l.ring_fx, n) - m.ring_drag * ring[2];
    let force_y =
        sum(&l.ring_fy, n) - m.ring_drag * ring[3] - m.radial_load - m.ring_mass * m.gravity;
    let at = m.layout.ring();
    dydt[at] = ring[2];
    dydt[at + 1] = ring[3];
    dydt[at + 2] = force_x / m.ring_mass;
    dydt[at + 3] = force_y / m.ring_mass;

    if !touching {
        // The arrays keep the last contact otherwise.
        l.pair_force[..n].fill(0.0);
        l.pair_rate[..n].fill(0.0);
    }
    let power = &mut dydt[m.layout.ledger()..];
    power[Work::Drive as usize] = sum(&l.drive, n);
    power[Work::Load as usize] = -m.radial_load * ring[3];
    power[Work::Weight as usize] = sum(&l.weight, n) - m.ring_mass * m.gravity * ring[3];
    power[Work::InnerFriction as usize] = sum(&l.inner_loss, n);
    power[Work::OuterFriction as usize] = sum(&l.outer_loss, n);
    power[Work::Damping as usize] = sum(&l.damping_loss, n);
    power[Work::Drag as usize] = m.ring_drag * (ring[2] * ring[2] + ring[3] * ring[3]);
    power[Work::BallFriction as usize] = 0.0;
    power[Work::Centrifugal as usize] = 0.0;
    power[Work::Direction as usize] = 0.0;
    power[Work::Frame as usize] = 0.0;
    if touching {
        power[Work::BallFriction as usize] = sum(&l.ball_loss, n);
        power[Work::Damping as usize] += sum(&l.pair_damping, n);
    }
    if PAPER {
        power[Work::Centrifugal as usize] = sum(&l.centrifugal, n);
        power[Work::Direction as usize] = sum(&l.direction, n);
        power[Work::Frame as usize] = sum(&l.frame, n);
        if touching {
            power[Work::Frame as usize] += sum(&l.pair_frame, n);
        }
    }
}
