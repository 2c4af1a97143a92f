//! Every constant of the equations of motion, derived once from a case.

use crate::bearing::Bearing;
use crate::case::{Case, FrictionLaw, Profile};
use crate::error::InputError;
use crate::raceway::Raceway;
use crate::seat::seat;
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
    /// dr/du over u.
    pub radius_slope: Vec<f64>,
    /// 1/√(1 + y′² + z′²) over u.
    pub direction: Vec<f64>,
    /// dy/dx = x(4a x² + 2b).
    pub slope: [f64; 2],
    /// Depth milled too much in the middle.
    pub error: f64,
}

/// Constants of one ball and of its contact with the ball ahead.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct BallConstants {
    pub radius: f64,
    pub mass: f64,
    pub inertia: f64,
    pub inner_stiffness: f64,
    pub outer_stiffness: f64,
    /// Distance of the centres when ball and ball ahead touch.
    pub pair_distance: f64,
    pub pair_stiffness: f64,
    /// α √(m K), m the reduced mass of the two.
    pub pair_damping: f64,
    /// Angle between the two when they touch on the pitch circle.
    pub pair_angle: f64,
}

/// The equations of motion of one case.
#[derive(Debug, Clone, PartialEq)]
pub struct Model {
    pub(super) layout: Layout,
    pub(super) profile: Profile,
    pub(super) law: FrictionLaw,
    pub(super) balls: Vec<BallConstants>,
    /// Whether seats differ from those of nominal balls in raceways as designed.
    pub(super) unequal: bool,
    /// Rw, nominal.
    pub(super) ball_radius: f64,
    /// Re.
    pub(super) groove_curvature_radius: f64,
    /// Rm.
    pub(super) pitch_radius: f64,
    /// Ro.
    pub(super) outer_radius: f64,
    /// Ri.
    pub(super) inner_radius: f64,
    pub(super) ring_mass: f64,
    pub(super) ring_drag: f64,
    pub(super) inner_speed: f64,
    pub(super) radial_load: f64,
    pub(super) gravity: f64,
    pub(super) damping: f64,
    pub(super) ball_damped: bool,
    pub(super) friction: f64,
    /// 1/scale of the smooth law.
    pub(super) inverse_slip_scale: f64,
    /// Coulomb law: friction per slip within the cone, N·s/m.
    pub(super) stick_gain: f64,
    pub(super) grooves: Vec<Groove>,
    bearing: Bearing,
    raceways: Vec<Raceway>,
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
        let alpha = restitution_damping(c.ball_restitution);
        let balls: Vec<BallConstants> = (0..d.balls)
            .map(|k| {
                let (ball, next) = (bearing.ball(k), bearing.ball((k + 1) % d.balls));
                let [inner_stiffness, outer_stiffness, pair_stiffness] =
                    case.ball_stiffness_n_m1_5(k);
                let reduced = ball.mass_kg * next.mass_kg / (ball.mass_kg + next.mass_kg);
                BallConstants {
                    radius: ball.radius_m,
                    mass: ball.mass_kg,
                    inertia: ball.inertia_kg_m2,
                    inner_stiffness,
                    outer_stiffness,
                    pair_distance: ball.radius_m + next.radius_m,
                    pair_stiffness,
                    pair_damping: alpha * (reduced * pair_stiffness).sqrt(),
                    pair_angle: bearing.pair_angle_rad(k),
                }
            })
            .collect();
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
                    radius_slope: (1..radius.coefficients.len())
                        .map(|k| k as f64 * radius.coefficients[k])
                        .collect(),
                    direction: raceway.direction_polynomial().coefficients.clone(),
                    slope: [4.0 * a, 2.0 * b],
                    error: raceway.depth_error_m(),
                }
            })
            .collect();
        // 2/7 m is the mass that a force at the surface of a free ball feels.
        let lightest = balls.iter().map(|b| b.mass).fold(f64::INFINITY, f64::min);
        let stick_gain = STICK_SHARE * 2.0 / 7.0 * lightest / case.solver.step_s;
        Ok(Self {
            layout: Layout::new(d.balls),
            profile: case.profile,
            law: c.friction_law,
            balls,
            unequal: !case.nominal_seats(),
            ball_radius: d.ball_radius_m,
            groove_curvature_radius: d.outer_groove_curvature_radius_m,
            pitch_radius: bearing.pitch_radius_m(),
            outer_radius: d.outer_groove_bottom_radius_m,
            inner_radius: d.inner_groove_bottom_radius_m,
            ring_mass: d.inner_ring_mass_kg,
            ring_drag: d.inner_ring_drag_n_s_m,
            inner_speed: case.operation.inner_speed_rad_s,
            radial_load: case.operation.radial_load_n,
            gravity: case.operation.gravity_m_s2,
            damping: c.damping_n_s_m1_5,
            ball_damped: alpha > 0.0,
            friction: c.friction_coefficient,
            inverse_slip_scale: 1.0 / c.slip_scale_m_s,
            stick_gain,
            grooves,
            bearing: bearing.clone(),
            raceways: case.raceways.clone(),
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

    /// What bearings side by side must have in common.
    pub fn kind(&self) -> impl PartialEq + use<> {
        (self.balls(), self.profile, self.law, self.unequal)
    }

    /// Angle between ball `k` and the ball ahead when they touch on the pitch circle.
    pub fn pair_angle_rad(&self, k: usize) -> f64 {
        self.balls[k].pair_angle
    }

    /// Distance of the centres of ball `k` and the ball ahead when they touch.
    pub fn pair_distance_m(&self, k: usize) -> f64 {
        self.balls[k].pair_distance
    }

    /// Kinetic and elastic energy, J. In the `paper` profile the spin is that of
    /// Eq. (13), relative to the orbit.
    pub fn energy_j(&self, state: &State) -> f64 {
        let (x, y) = (state.x_m(), state.y_m());
        let [ring_x, ring_y, ring_vx, ring_vy] = state.ring();
        let elastic = |k: f64, deflection: f64| 0.4 * k * deflection.max(0.0).powf(2.5);
        let mut sum = 0.5 * self.ring_mass * (ring_vx * ring_vx + ring_vy * ring_vy);
        for (k, ball) in self.balls.iter().enumerate() {
            let (vx, vy) = (state.vx_m_s()[k], state.vy_m_s()[k]);
            let spin = state.spin_state_rad_s()[k];
            let next = (k + 1) % self.balls();
            let touching = if self.unequal {
                let angle = x[k].atan2(-y[k]);
                seat(&self.bearing, &self.raceways, angle, ball.radius).touching_radius_m
            } else {
                self.outer_radius - ball.radius
            };
            sum += 0.5 * ball.mass * (vx * vx + vy * vy)
                + 0.5 * ball.inertia * spin * spin
                + elastic(ball.outer_stiffness, x[k].hypot(y[k]) - touching)
                + elastic(
                    ball.inner_stiffness,
                    self.inner_radius + ball.radius - (x[k] - ring_x).hypot(y[k] - ring_y),
                )
                + elastic(
                    ball.pair_stiffness,
                    ball.pair_distance - (x[next] - x[k]).hypot(y[next] - y[k]),
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
