//! Step limits of a case, from the stiffest contact and the stability of the method.
//!
//! ```
//! use cageless::IntegrationMethod;
//! use cageless::reference::Structure;
//! use cageless::step_limits::StepLimits;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! let step_s = StepLimits::new(&case).automatic_s(IntegrationMethod::Abm4);
//! assert!(step_s > 0.0 && step_s < 1e-5);
//! ```

use crate::case::{Case, Gaps, Row, StartState, Tilt, series_stiffness_n_m1_5};
use crate::contact::Regularisation;
use crate::contact::creep::rolling_speed_m_s;
use crate::contact::friction::STICK_FRACTION;
use crate::contact::hertz::{self, DEFLECTION_FRACTION_MAX};
use crate::error::{Allowed, InputError};
use crate::film::{Rolling, RollingModel};
use crate::integrator::IntegrationMethod;
use crate::kinematics::rolling_orbit_speed_rad_s;
use crate::numerics::root::last_where;
use crate::raceway::Raceway;
use crate::world::body::{self, ContactStiffness};
use crate::world::joint::impact::Impact;

impl Case {
    /// Sets the integration method, with its automatic step for this case.
    pub fn set_method(&mut self, method: IntegrationMethod) {
        self.solver.method = method;
        self.solver.step_s = StepLimits::new(self).automatic_s(method);
    }

    /// Passes a case whose motion can be computed with its own method and step: creep of rolling contacts leaves an
    /// explicit method no energy balance at longer steps than it resolves their friction with.
    ///
    /// # Errors
    /// An [`InputError`] of [`Case::check_motion`], or naming the step.
    pub fn check_run(&self) -> Result<(), InputError> {
        self.check_motion()?;
        let creeps = self.contact.regularisation == Regularisation::Kalker;
        // From standstill, and in a drop, the limit is that of an instant.
        if !creeps || self.rotor.is_some() || !self.has_constant_operation() {
            return Ok(());
        }
        let resolved_s = StepLimits::new(self).friction_resolved_to_s(self.solver.method);
        let why = "beyond it an explicit method does not follow the friction of rolling contacts; \"verlet\" treats it \
                   implicitly, at any step";
        Allowed::AtMost(resolved_s, why).check("step_s", self.solver.step_s)
    }
}

/// Checks a case, and its step against the stability of the method.
///
/// # Errors
/// An [`InputError`] naming the first field that cannot be.
pub fn check(case: &Case) -> Result<(), InputError> {
    case.check()?;
    let (step_s, method) = (case.solver.step_s, case.solver.method);
    let largest_s = StepLimits::new(case).largest_s(method);
    let why = "the method is unstable beyond it for the stiffest contact of this case";
    Allowed::AtMost(largest_s, why).check("step_s", step_s)
}

/// Fastest rates of a case.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepLimits {
    /// ω of the fastest oscillation: a ball on the stiffness of its contacts under the
    /// largest forces to be expected, and the inner ring on those that carry it.
    pub contact_rad_s: f64,
    /// Decay of the bounce of a ball by contact damping, and of the ring by that and its drag.
    pub damping_1_s: f64,
    /// Decay of slip by friction of the smooth laws on a loaded ball; of explicit methods only.
    pub friction_1_s: f64,
    /// Growth, per second of step, of the creep that the relaxed stick of Coulomb friction
    /// leaves in explicit methods at the limit of a loaded contact, m/s²; 0 under the smooth laws.
    creep_m_s2: f64,
    /// Growth of slip where friction falls with the sliding speed, 1/s; 0 where it never does.
    pub falling_1_s: f64,
    /// Whether the contacts are damped.
    pub damped: bool,
    /// Whether impacts, rather than the load, turn the energy over.
    pub light: bool,
    /// Whether balls move along the damping of a contact: balls that touch from the start, and
    /// balls at rest with uneven gaps, of which few take the impact of a rotor.
    pub touching: bool,
    /// Time in which a ball in space passes the shortest run-out of a raceway before its end, s; infinite
    /// without one.
    run_out_s: f64,
    /// Factor on the slopes of the contacts, dF/dδ ∝ F^(1/3), while the ring is wedged between two
    /// balls; 1 if it never is. The automatic step allows for it, the limits do not.
    wedged: f64,
}

/// Lower bound of the ball–ball approach speed in the estimate, m/s.
const LEAST_IMPACT_M_S: f64 = 0.1;
/// Fraction of the balls whose stiffness at full load together carries the ring.
const CARRYING_FRACTION: f64 = 0.25;
/// Fraction of the balls whose stiffness together carries a preloaded ring: the mean of cos² over
/// the circle, as interference presses all of them.
const PRELOADED_FRACTION: f64 = 0.5;
/// Peaks over the static load that the limits allow for.
const OVERLOAD: f64 = 1.25;

/// Force of a ball between the rings that no load presses there: a ball larger than nominal or
/// a raceway not milled deep enough against both contacts in series, and the overlap with
/// which a rolling start begins, against one.
fn squeezed_n(case: &Case) -> f64 {
    let bearing = &case.bearing;
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let force = |k: f64, depth: f64| k * depth.max(0.0).powf(1.5);
    let deviations = bearing.ball_radius_deviations_m();
    let larger = deviations.iter().fold(0.0, |most: f64, d| most.max(*d));
    let shallow = case
        .raceways
        .iter()
        .fold(0.0, |most: f64, r| most.max(-r.depth_error_m()));
    let clearance = 0.5 * bearing.radial_internal_clearance_m();
    let series = series_stiffness_n_m1_5(inner, outer);
    let squeezed = force(series, 2.0 * larger + shallow - clearance);
    // Balls on Rm, half of the clearance off either raceway, the ring off the centre.
    let pressed = |off: f64| {
        let depth = larger - 0.5 * clearance;
        squeezed
            .max(force(inner, off + depth))
            .max(force(outer, depth + shallow))
    };
    match case.start.state {
        StartState::Settled => squeezed,
        StartState::Rolling { ring_x_m, ring_y_m } => pressed(ring_x_m.hypot(ring_y_m)),
        StartState::AtRest => pressed(0.0),
    }
}

/// Ratio of the largest axial force of a ball under a moment M to M/(N·Rm): one over the mean of |cos ψ|^(5/2).
const MOMENT_FACTOR: f64 = 2.2;

/// Force of the most loaded ball under axial load and tilt or moments alone, N.
fn pressed_along_axis_n(case: &Case) -> f64 {
    let (load, pitch) = (&case.operation.space, case.bearing.pitch_radius_m());
    let thrust_n = load.axial_load_n.abs();
    match load.tilt {
        Tilt::Free {
            moment_x_n_m,
            moment_y_n_m,
        } => {
            let moment_n_m = moment_x_n_m.hypot(moment_y_n_m);
            case.thrust_on_ball(thrust_n + MOMENT_FACTOR * moment_n_m / pitch)[0]
        }
        Tilt::Held { x_rad, y_rad } => {
            let tilt_rad = x_rad.hypot(y_rad);
            match case.rows.is_empty() || tilt_rad == 0.0 {
                true => {
                    case.thrust_on_ball(thrust_n)[0] + case.pressed_along_axis(pitch * tilt_rad)[0]
                }
                false => tilted_rows_n(case, tilt_rad, thrust_n),
            }
        }
    }
}

/// Force of the most loaded ball of tilted rows beyond that of their preload, N. A row at z moves by zφ across the axis and
/// its balls by Rm φ along it, on top of preload and thrust: what adds is approach, F ∝ δ^(3/2).
fn tilted_rows_n(case: &Case, tilt_rad: f64, thrust_n: f64) -> f64 {
    let most = |of: fn(&Row) -> f64| case.rows.iter().map(of).fold(0.0, f64::max);
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let series = series_stiffness_n_m1_5(inner, outer);
    let approach = |force_n: f64| (force_n / series).powf(2.0 / 3.0);
    let along_m = most(|row| row.preload_m) + case.bearing.pitch_radius_m() * tilt_rad;
    let spring_n = most(|row| row.preload_n);
    let borne_n = [
        case.pressed_along_axis(along_m)[0],
        case.thrust_on_ball(thrust_n + spring_n)[0],
    ];
    let across_m = most(|row| row.axial_position_m.abs()) * tilt_rad;
    let pressed_m = borne_n.map(approach).iter().sum::<f64>() + across_m;
    series * pressed_m.powf(1.5) - case.axial_preload_n()
}

/// Number of balls whose stiffness together carries the ring.
fn carrying(case: &Case) -> f64 {
    let preloaded = case.bearing.radial_internal_clearance_m() < 0.0;
    let fraction = match preloaded {
        true => PRELOADED_FRACTION,
        false => CARRYING_FRACTION,
    };
    fraction * case.bearing.balls() as f64
}

/// Displacements of a ring into an opening that are tried, over the radius of the ball: the first,
/// the last and the ratio of two.
const WEDGED: (f64, f64, f64) = (1e-5, 2.0, 1.1);

/// Openings up to this angle leave the ring on more than two balls, as six or more evenly spaced
/// ones do.
const WEDGE_RAD: f64 = std::f64::consts::FRAC_PI_3;

/// Largest force of a ball while a ring under `down` is pressed into the widest opening between
/// the balls at the start, which may turn to any place: about down/(2 cos(opening/2)) on each
/// of the two balls at its ends. `down` grows by what the ring needs to follow the opening round
/// through its clearance. Where the balls do not hold the ring it falls between them, and this is
/// the largest force that the guard of a run admits. Centrifugal force and friction are left out.
fn wedged_n(case: &Case, down: f64) -> f64 {
    let bearing = &case.bearing;
    let gaps = match &case.start.gaps {
        Gaps::Uniform => &vec![bearing.mean_gap_rad(); bearing.balls()],
        Gaps::List(gaps) => gaps,
    };
    let (mut angle, mut widest) = (0.0, (0.0, 0.0));
    let mut angles = vec![];
    for (k, gap) in gaps.iter().enumerate() {
        let opening = bearing.pair_angle_rad(k) + gap;
        angles.push(angle);
        if opening > widest.0 {
            widest = (opening, angle + 0.5 * opening);
        }
        angle += opening;
    }
    if widest.0 <= WEDGE_RAD {
        return 0.0;
    }
    let (d, orbit_rad_s) = (bearing.dimensions(), case.rolling_orbit_speed_rad_s());
    let whirl = orbit_rad_s * 0.5 * bearing.radial_internal_clearance_m().max(0.0);
    let down = down + (d.inner_ring_damping_n_s_m + d.inner_ring_mass_kg * orbit_rad_s) * whirl;
    let cosines: Vec<f64> = angles.iter().map(|a| (a - widest.1).cos()).collect();
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let series = series_stiffness_n_m1_5(inner, outer);
    let orbit = bearing.outer_orbit_radius_m();
    let reach = orbit - 0.5 * bearing.radial_internal_clearance_m();
    // Force on the ring against its displacement, and the largest on a ball.
    let pressed = |ring: f64| {
        let balls = cosines.iter().map(|cosine| {
            let along = orbit * cosine - ring;
            let across = orbit * (1.0 - cosine * cosine).max(0.0).sqrt();
            let distance = along.hypot(across);
            let force = series * (reach - distance).max(0.0).powf(1.5);
            (force * along / distance, force)
        });
        balls.fold((0.0, 0.0), |(held, largest): (f64, f64), (part, force)| {
            (held + part, largest.max(force))
        })
    };
    let (first, last, ratio) = WEDGED;
    let (mut free, mut ring) = (0.0, first * bearing.ball_radius_m());
    while ring < last * bearing.ball_radius_m() {
        if pressed(ring).0 >= down {
            let near = 1e-6 * (ring - free);
            return pressed(last_where(ring, free, near, |r| pressed(r).0 >= down)).1;
        }
        (free, ring) = (ring, ring * ratio);
    }
    inner * (DEFLECTION_FRACTION_MAX * bearing.ball_radius_m()).powf(1.5)
}

/// λh of friction up to which explicit velocity Verlet has unbiased statistics.
const FRICTION_RESOLVED: f64 = 0.7;
/// A load below this many times the peak force of the least impact is light.
const LIGHT: f64 = 4.0;
/// Fraction of the automatic λh that contact damping has where balls move along it: the
/// production method extrapolates the velocity along the path, and is stable there up to a λh of
/// 0.5. One that a neighbour pressed was unstable at 0.53, not at 0.45.
const TOUCHING: f64 = 0.5;
/// Steps in which a ball passes the run-out of a raceway at least: with four the largest forces of an ellipse under
/// axial load are within 2 % of those of a sixteenth of the step, with two within 5 %.
const RUN_OUT_STEPS: f64 = 4.0;
/// ωh at which impacts lose 1e-3 of their energy in the ledger.
const IMPACT_FRACTION: f64 = 0.2;

/// Decay of creep at the raceway contacts of a ball under a load, at the speed of the run at which it is slowest; 0
/// where the regularisation speed is given.
fn creep_1_s(case: &Case, load_n: f64) -> f64 {
    if case.contact.regularisation != Regularisation::Kalker {
        return 0.0;
    }
    let [outer, inner] = case.creep_stiffness_n1_3();
    let rolling_m_s = rolling_speed_m_s(case.least_rolling_speed_m_s());
    5.0 * outer.max(inner) * load_n.powf(2.0 / 3.0) / (case.bearing.ball_mass_kg() * rolling_m_s)
}

/// Decay of sliding by the films of the contacts of a ball under a load, at the speed of the run at which it is
/// slowest; 0 where the law alone is the friction.
fn film_1_s(case: &Case, load_n: f64) -> f64 {
    if !case.mixes_friction() {
        return 0.0;
    }
    let Some(films) = RollingModel::new(case).and_then(|film| film.traction) else {
        return 0.0;
    };
    let rolling = Rolling {
        load_n,
        speed_m_s: case.least_rolling_speed_m_s(),
    };
    let [outer, inner] = [films.outer, films.inner].map(|film| film.slope_n_s_m(rolling));
    5.0 * outer.max(inner) / case.bearing.ball_mass_kg()
}

/// Largest tangential speed of a ball with this contact radius in its orbit, m/s.
fn orbit_m_s(case: &Case, contact_radius_m: f64) -> f64 {
    let (bearing, inner_rad_s) = (&case.bearing, case.largest_inner_speed_rad_s());
    rolling_orbit_speed_rad_s(bearing, inner_rad_s, contact_radius_m) * bearing.pitch_radius_m()
}

/// Speed at which balls meet, m/s: their speed difference in the deepest raceway.
fn approach_m_s(case: &Case) -> f64 {
    let outside_m_s = orbit_m_s(case, case.bearing.ball_radius_m());
    let in_middle_m_s = |raceway: &Raceway| {
        let middle_rad = raceway.dimensions().centre_angle_rad;
        orbit_m_s(case, raceway.effective_radius_m(middle_rad))
    };
    let slower_m_s = case.raceways.iter().map(|r| outside_m_s - in_middle_m_s(r));
    slower_m_s.fold(LEAST_IMPACT_M_S, f64::max)
}

/// Time in which a ball in space passes the shortest run-out of a raceway before its end, s; infinite without one.
fn run_out_s(case: &Case) -> f64 {
    match case.moves_in_space() {
        true => {
            let lengths_m = case.raceways.iter().filter_map(Raceway::run_out_m);
            let shortest_m = lengths_m.fold(f64::INFINITY, f64::min);
            shortest_m / orbit_m_s(case, case.bearing.ball_radius_m())
        }
        false => f64::INFINITY,
    }
}

/// Largest force on a ball that takes `force_n` of the loads, N: with its centrifugal force, peaks over both, and
/// what the rings press without load.
fn under_n(case: &Case, force_n: f64) -> f64 {
    OVERLOAD * (force_n + case.centrifugal_force_n()) + case.preload_n() + case.axial_preload_n()
}

/// Forces that the limits allow for.
struct BallForces {
    /// Radial load of the inner ring with weights and impact, N.
    down_n: f64,
    /// Force of all loads on the most loaded ball, N.
    carried_n: f64,
    /// Peak of the impact of a ball on a raceway, N.
    struck_n: f64,
    /// Largest force on a ball, N.
    largest_n: f64,
}

impl BallForces {
    fn of_case(case: &Case, impact: &Impact) -> Self {
        let d = case.bearing.dimensions();
        let mass = case.bearing.ball_mass_kg();
        let [inner, outer, _] = case.stiffness_n_m1_5();
        let down_n = case.largest_radial_load_n()
            + case.operation.unbalance_force_n()
            + impact.force_n.max(impact.axial_as_radial_n)
            + (d.inner_ring_mass_kg + mass) * case.operation.gravity_m_s2;
        let of_loads_n = 5.0 * down_n / d.balls as f64 + pressed_along_axis_n(case);
        let carried_n = under_n(case, of_loads_n);
        // A ball of mass m against a raceway: the reduced mass is m.
        let (_, struck_n, _) = hertz::impact(inner.max(outer), 2.0 * mass, LEAST_IMPACT_M_S);
        Self {
            down_n,
            carried_n,
            struck_n,
            largest_n: carried_n.max(squeezed_n(case)).max(struck_n),
        }
    }
}

/// Rates of the slip under friction.
struct FrictionRates {
    /// Decay under the smooth laws, 1/s.
    decay_1_s: f64,
    /// Creep under Coulomb's law per second of step, m/s².
    creep_m_s2: f64,
    /// Growth where friction falls with the sliding speed, 1/s.
    growth_1_s: f64,
}

impl FrictionRates {
    /// Rates of friction of a ball under `load_n`, and of an impact.
    fn of_case(case: &Case, load_n: f64, impact: &Impact) -> Self {
        let (contact, mass) = (&case.contact, case.bearing.ball_mass_kg());
        let factor = contact.friction_factor_max();
        let coefficient_max = factor * contact.friction_law.coefficient_max(&contact.friction);
        let fall = contact.friction_law.steepest_fall(&contact.friction);
        let growth_1_s = (5.0 * factor * fall * load_n / mass).max(impact.falling_1_s);
        if contact.friction_law.sticks() {
            // The stick of explicit methods is relaxed with the step, see `Model`.
            let stick = STICK_FRACTION * 2.0 / 7.0 * mass;
            return Self {
                decay_1_s: impact.friction_1_s,
                creep_m_s2: coefficient_max * load_n / stick,
                growth_1_s,
            };
        }
        // Both friction forces of a ball together feel 1/5 of its mass.
        let largest = 5.0 * coefficient_max * load_n;
        let rate = largest / (mass * contact.friction.regularisation_speed_m_s);
        Self {
            decay_1_s: (rate.max(creep_1_s(case, load_n)) + film_1_s(case, load_n))
                .max(impact.friction_1_s),
            creep_m_s2: 0.0,
            growth_1_s,
        }
    }
}

impl StepLimits {
    /// Estimates the rates: the largest of Qmax ≈ 5 (Fr + weights)/N + what axial load and tilt press +
    /// centrifugal force, a quarter more, + the preload, of what presses the parts together without load
    /// (`squeezed_n`) and of the peak of an impact on a raceway, in both raceway contacts of one
    /// ball, and an impact of two balls at the speed difference that the deepest raceway makes.
    /// Springs between ball and ring count at both masses: k (1/m + n/M) is an upper bound of ω².
    pub fn new(case: &Case) -> Self {
        let mass = case.bearing.ball_mass_kg();
        let [inner, outer, ball] = case.stiffness_n_m1_5();
        let carrying = carrying(case);
        let impact = Impact::of_case(case, carrying);
        let forces = BallForces::of_case(case, &impact);
        let load = forces.largest_n;
        // dF/dδ = 3/2 K^(2/3) F^(1/3).
        let slope = |k: f64, force: f64| 1.5 * k.powf(2.0 / 3.0) * force.cbrt();
        let raceways = slope(inner, load) + slope(outer, load);
        let (_, peak, _) = hertz::impact(ball, mass, approach_m_s(case));
        let deflection = |k: f64| (load / k).powf(2.0 / 3.0).sqrt();
        let damper = |k: f64| case.contact.damping_n_s_m1_5 * deflection(k);
        let bodies = body::fastest_rates(
            case,
            &ContactStiffness {
                carrying,
                inner_n_m: slope(inner, load),
                outer_n_m: slope(outer, load),
                journal_n_m: impact.contact_n_m,
                inner_n_s_m: damper(inner),
                outer_n_s_m: damper(outer),
                journal_n_s_m: impact.contact_n_s_m,
            },
        );
        let of_ball = (raceways + 2.0 * slope(ball, peak)) / mass;
        let square = bodies
            .iter()
            .fold(of_ball, |sum, own| sum + own.square_1_s2);
        let of_ball = (damper(inner) + damper(outer)) / mass;
        let damping_1_s = bodies.iter().fold(of_ball, |sum, own| sum + own.decay_1_s);
        let wedge = wedged_n(case, forces.down_n);
        let touching = match (&case.start.gaps, case.start.state) {
            (Gaps::List(_), StartState::AtRest) => impact.falls,
            (Gaps::List(gaps), _) => gaps.contains(&0.0),
            (Gaps::Uniform, _) => false,
        };
        let friction = FrictionRates::of_case(case, load, &impact);
        Self {
            contact_rad_s: square.sqrt(),
            damping_1_s,
            friction_1_s: friction.decay_1_s,
            creep_m_s2: friction.creep_m_s2,
            falling_1_s: friction.growth_1_s,
            damped: case.contact.damping_n_s_m1_5 > 0.0,
            // The impact of a rotor, too, where two balls have to take it.
            light: forces.carried_n < LIGHT * forces.struck_n || (impact.falls && wedge > 0.0),
            touching,
            run_out_s: run_out_s(case),
            wedged: (under_n(case, wedge) / load).max(1.0).cbrt(),
        }
    }

    /// The rates where the journal belongs to a rotor that shows it a smaller mass than the case
    /// gives it, and that has vibrations of its own up to `fastest_rad_s` and decays by its own
    /// damping at up to `fastest_decay_1_s`.
    pub(crate) fn with_linear_rotor(
        case: &Case,
        effective_mass_kg: f64,
        fastest_rad_s: f64,
        fastest_decay_1_s: f64,
    ) -> Self {
        let (limits, impact) = (Self::new(case), Impact::of_case(case, carrying(case)));
        let of_case = case.rotor.as_ref().map_or(0.0, |rotor| 1.0 / rotor.mass_kg);
        let lighter = (1.0 / effective_mass_kg - of_case).max(0.0);
        let square = limits.contact_rad_s.powi(2)
            + impact.contact_n_m * lighter
            + fastest_rad_s * fastest_rad_s;
        Self {
            contact_rad_s: square.sqrt(),
            damping_1_s: limits.damping_1_s.max(fastest_decay_1_s),
            ..limits
        }
    }

    /// Step beyond which the contacts are unstable under the method.
    pub(crate) fn largest_s(&self, method: IntegrationMethod) -> f64 {
        let properties = method.properties();
        (properties.oscillation_limit / self.contact_rad_s)
            .min(properties.decay_limit / self.damping_1_s)
    }

    /// Whether friction is stiff for the step of `case`: beyond a λh of 0.7 the production
    /// method treats it implicitly, below it, with the other forces, to second order. Coulomb's
    /// law always counts as stiff.
    pub(crate) fn friction_is_stiff(case: &Case) -> bool {
        let rotor = case.rotor.as_ref();
        let limits = Self::new(case);
        case.contact.friction_law.sticks()
            || rotor.is_some_and(|r| r.friction_law.sticks())
            || case.contact.regularisation == Regularisation::Kalker
            || case.mixes_friction()
            || limits.wedged_friction_1_s() * case.solver.step_s > FRICTION_RESOLVED
    }

    /// Decay of slip by friction on the ball that bears most while the ring is wedged.
    fn wedged_friction_1_s(&self) -> f64 {
        self.friction_1_s * self.wedged.powi(3)
    }

    /// Step beyond which smooth friction no longer settles: slip then jumps to and fro
    /// about zero, bounded by μN, where it should decay.
    pub fn friction_resolved_to_s(&self, method: IntegrationMethod) -> f64 {
        let properties = method.properties();
        match properties.solves_stiff_part {
            true => f64::INFINITY,
            false => properties.decay_limit / self.friction_1_s,
        }
    }

    /// Step beyond which the end of a step under friction that falls with the sliding speed is
    /// not unique where friction is implicit: 1/λ with the growth λ of slip.
    pub fn falling_resolved_to_s(&self, method: IntegrationMethod) -> f64 {
        match method.properties().solves_stiff_part {
            true => 1.0 / self.falling_1_s,
            // Explicit methods follow the growth.
            false => f64::INFINITY,
        }
    }

    /// Creep that the relaxed stick of Coulomb friction leaves per second of step, m/s²; 0 where
    /// friction is implicit.
    pub fn creep_m_s2(&self, method: IntegrationMethod) -> f64 {
        match method.properties().solves_stiff_part {
            true => 0.0,
            false => self.creep_m_s2,
        }
    }

    /// Step of `step_us = "auto"`: unbiased statistics, rounded down to 1, 1.5, 2, 3, 5, 7
    /// times a power of ten.
    ///
    /// Measured on CB74 (undamped, ω = 3e5 1/s): velocity Verlet is unbiased at ωh = 0.6,
    /// ABM4 at 0.15, with damping at twice that.
    ///
    /// Balls that hardly any load holds fall and bounce, and impacts are what turns the energy
    /// over: 100 rpm without load left 1.5 % of all flows unaccounted for at ωh = 0.6, and less
    /// with the square of the step.
    pub fn automatic_s(&self, method: IntegrationMethod) -> f64 {
        let properties = method.properties();
        let fraction = properties.automatic_oscillation[usize::from(self.damped)];
        // Error control finds the impacts by itself.
        let fraction = match self.light && properties.oscillation_limit.is_finite() {
            true => fraction.min(IMPACT_FRACTION),
            false => fraction,
        };
        let damping_1_s = self.damping_1_s * self.wedged;
        let decay_1_s = match properties.solves_stiff_part {
            true => damping_1_s,
            false => damping_1_s.max(self.wedged_friction_1_s()),
        };
        let contact_rad_s = self.contact_rad_s * self.wedged.sqrt();
        let decay = properties.automatic_decay * if self.touching { TOUCHING } else { 1.0 };
        let mut wanted = (fraction / contact_rad_s).min(decay / decay_1_s);
        if properties.oscillation_limit.is_finite() {
            wanted = wanted.min(self.run_out_s / RUN_OUT_STEPS);
        }
        let power = 10f64.powf(wanted.log10().floor());
        let digits = [7.0, 5.0, 3.0, 2.0, 1.5, 1.0];
        // The quotient is between 1 and 10; rounding may leave it just below 1.
        let digit = digits
            .into_iter()
            .find(|d| *d <= wanted / power)
            .unwrap_or(1.0);
        // Exact decimal: 1.5e-6 rather than 15 times 1e-7 rounded.
        format!("{digit}e{}", power.log10().round() as i32)
            .parse()
            .unwrap_or(wanted)
    }
}
