//! Every constant of the equations of motion, derived once from a case.

use crate::case::{Case, FrictionLaw, Profile};
use crate::error::InputError;
use crate::state::{Layout, State, Work};
use crate::traction::restitution_damping;

/// Constants of one discrete raceway as the right-hand side uses them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Groove {
    pub sin_centre: f64,
    pub cos_centre: f64,
    /// sin²θ.
    pub end: f64,
    /// u = scale·sin²ψ + shift.
    pub scale: f64,
    pub shift: f64,
    /// r over u.
    pub radius: Vec<f64>,
    /// 1/√(1 + y′² + z′²) over u.
    pub direction: Vec<f64>,
    /// dy/dx = x(4a x² + 2b).
    pub slope: [f64; 2],
}

/// The equations of motion of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    pub(super) layout: Layout,
    pub(super) profile: Profile,
    pub(super) law: FrictionLaw,
    /// Rw.
    pub(super) ball_radius: f64,
    /// Rm.
    pub(super) pitch_radius: f64,
    /// Ro − Rw.
    pub(super) touching_radius: f64,
    /// Ri.
    pub(super) inner_radius: f64,
    pub(super) ball_mass: f64,
    pub(super) ball_inertia: f64,
    pub(super) ring_mass: f64,
    pub(super) ring_drag: f64,
    pub(super) inner_speed: f64,
    pub(super) radial_load: f64,
    pub(super) gravity: f64,
    pub(super) inner_stiffness: f64,
    pub(super) outer_stiffness: f64,
    pub(super) ball_stiffness: f64,
    pub(super) damping: f64,
    /// α √(m K) of the contact between balls.
    pub(super) ball_damping: f64,
    pub(super) friction: f64,
    /// 1/scale of the smooth law.
    pub(super) inverse_slip_scale: f64,
    /// Coulomb law: friction per slip within the cone, N·s/m.
    pub(super) stick_gain: f64,
    pub(super) grooves: Vec<Groove>,
    pub(super) ball_angle: f64,
}

/// Coulomb law: share of a slip within the friction cone that one step takes away.
///
/// Rolling needs a friction force inside the cone that no function of the state
/// gives; F = g·ΔV, bounded by ±μN, with g this share of what stops the slip within
/// a step, supplies it. It is implicit stick relaxed over a few steps: the slip that
/// remains is a creep proportional to the step, and where the ball slides, the law
/// is μ·sign(ΔV)·N exactly. Both raceway contacts of a ball together relax at up
/// to 10/7 of it, inside the stability interval of ABM4 (1.25); contacts between balls,
/// which would add to it, always slide.
const STICK_SHARE: f64 = 0.4;

impl Model {
    /// Derives the constants.
    ///
    /// # Errors
    /// The [`InputError`] of [`Case::check`].
    pub fn new(case: &Case) -> Result<Self, InputError> {
        case.check()?;
        let bearing = &case.bearing;
        let d = bearing.dimensions();
        let c = &case.contact;
        let ball_mass = bearing.ball_mass_kg();
        let [inner_stiffness, outer_stiffness, ball_stiffness] = case.stiffness_n_m1_5();
        let grooves = case
            .raceways
            .iter()
            .map(|raceway| {
                let [a, b, _] = raceway.path_coefficients();
                let (sin_centre, cos_centre) = raceway.dimensions().centre_angle_rad.sin_cos();
                let radius = raceway.radius_polynomial();
                Groove {
                    sin_centre,
                    cos_centre,
                    end: raceway.half_angle_rad().sin().powi(2),
                    scale: radius.scale,
                    shift: radius.shift,
                    radius: radius.coefficients.clone(),
                    direction: raceway.direction_polynomial().coefficients.clone(),
                    slope: [4.0 * a, 2.0 * b],
                }
            })
            .collect();
        // 2/7 m is the mass that a force at the surface of a free ball feels.
        let stick_gain = STICK_SHARE * 2.0 / 7.0 * ball_mass / case.solver.step_s;
        Ok(Self {
            layout: Layout::new(d.balls),
            profile: case.profile,
            law: c.friction_law,
            ball_radius: d.ball_radius_m,
            pitch_radius: bearing.pitch_radius_m(),
            touching_radius: bearing.touching_radius_m(),
            inner_radius: d.inner_groove_bottom_radius_m,
            ball_mass,
            ball_inertia: bearing.ball_inertia_kg_m2(),
            ring_mass: d.inner_ring_mass_kg,
            ring_drag: d.inner_ring_drag_n_s_m,
            inner_speed: case.operation.inner_speed_rad_s,
            radial_load: case.operation.radial_load_n,
            gravity: case.operation.gravity_m_s2,
            inner_stiffness,
            outer_stiffness,
            ball_stiffness,
            damping: c.damping_n_s_m1_5,
            ball_damping: restitution_damping(c.ball_restitution)
                * (ball_mass / 2.0 * ball_stiffness).sqrt(),
            friction: c.friction_coefficient,
            inverse_slip_scale: 1.0 / c.slip_scale_m_s,
            stick_gain,
            grooves,
            ball_angle: bearing.ball_angle_rad(),
        })
    }

    /// Layout of the state vector.
    pub fn layout(&self) -> Layout {
        self.layout
    }

    /// Which equations.
    pub fn profile(&self) -> Profile {
        self.profile
    }

    /// N.
    pub fn balls(&self) -> usize {
        self.layout.balls
    }

    /// K at the inner raceway, N·m^(−3/2).
    pub fn inner_stiffness_n_m1_5(&self) -> f64 {
        self.inner_stiffness
    }

    /// K at the outer raceway, N·m^(−3/2).
    pub fn outer_stiffness_n_m1_5(&self) -> f64 {
        self.outer_stiffness
    }

    /// Kinetic and elastic energy, J. In the `paper` profile the spin is that of
    /// Eq. (13), relative to the orbit.
    pub fn energy_j(&self, state: &State) -> f64 {
        let (x, y) = (state.x_m(), state.y_m());
        let [ring_x, ring_y, ring_vx, ring_vy] = state.ring();
        let elastic = |k: f64, deflection: f64| 0.4 * k * deflection.max(0.0).powf(2.5);
        let mut sum = 0.5 * self.ring_mass * (ring_vx * ring_vx + ring_vy * ring_vy);
        for k in 0..self.balls() {
            let (vx, vy) = (state.vx_m_s()[k], state.vy_m_s()[k]);
            let spin = state.spin_state_rad_s()[k];
            let next = (k + 1) % self.balls();
            sum += 0.5 * self.ball_mass * (vx * vx + vy * vy)
                + 0.5 * self.ball_inertia * spin * spin
                + elastic(
                    self.outer_stiffness,
                    x[k].hypot(y[k]) - self.touching_radius,
                )
                + elastic(
                    self.inner_stiffness,
                    self.inner_radius + self.ball_radius - (x[k] - ring_x).hypot(y[k] - ring_y),
                )
                + elastic(
                    self.ball_stiffness,
                    2.0 * self.ball_radius - (x[next] - x[k]).hypot(y[next] - y[k]),
                );
        }
        sum
    }

    /// What the state lacks to balance its ledger: energy now − energy at the start −
    /// net work, J, and the sum of the absolute entries including the change of
    /// energy, to which it is to be compared.
    pub fn energy_residual_j(&self, start_energy_j: f64, state: &State) -> (f64, f64) {
        let change = self.energy_j(state) - start_energy_j;
        let (mut net, mut sum) = (0.0, change.abs());
        for work in Work::ALL {
            let value = state.work_j(work);
            net += if work.is_loss() { -value } else { value };
            sum += value.abs();
        }
        (change - net, sum)
    }
}
