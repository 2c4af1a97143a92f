//! A case: the physics of one computation, in SI units.
//!
//! ```
//! use cageless::reference::Structure;
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! assert_eq!(case.bearing.balls(), 14);
//! assert!(case.check().is_ok());
//! // Balls orbit at somewhat less than half the speed of the inner ring.
//! let ratio = case.rolling_orbit_speed_rad_s() / case.operation.inner_speed_rad_s;
//! assert!(0.35 < ratio && ratio < 0.45);
//! ```

mod check;
mod contact;
mod creep;
mod inner_ring_drive;
mod operating_clearance;
mod over_time;
mod plain;
mod space;
mod spatial_load;
mod traction;

use std::f64::consts::TAU;

use crate::bearing::Bearing;
use crate::film::Film;
use crate::flank_model::FlankModel;
use crate::formulation::Formulation;
use crate::integrator::IntegrationMethod;
use crate::kinematics::rolling_orbit_speed_rad_s;
use crate::numerics::random::{RandomStream, split_mix};
use crate::numerics::root;
use crate::raceway::{Raceway, RacewayForm};
use crate::rotating_ring::{RingDiameters, rotating_growth_m};
use crate::rotor::{Rotor, Support};
use crate::time_table::TimeTable;
use crate::unbalance::{Unbalance, UnbalanceForce};

pub use contact::{Contact, STRIPS_MAX};
pub(crate) use inner_ring_drive::InnerRingDrive;
pub use space::SPATIAL_FIELDS;
pub use spatial_load::{Motion, Row, SpatialLoad, Tilt};

/// Loads and speed.
#[derive(Debug, Clone, PartialEq)]
pub struct Operation {
    /// Whether the inner ring turns clockwise. The case is then seen from the other face of the
    /// bearing, from which it turns counter-clockwise: ψ counts in the sense of rotation.
    pub clockwise: bool,
    /// ωi, counter-clockwise; where a table is given its value at t = 0, with a rotor 0.
    pub inner_speed_rad_s: f64,
    /// Fr, along −Y; where a table is given its value at t = 0, with a rotor 0.
    pub radial_load_n: f64,
    /// g, along −Y.
    pub gravity_m_s2: f64,
    /// ωi over time, where it changes; not with a rotor.
    pub inner_speed_table: Option<TimeTable>,
    /// Fr over time, where it changes; not with a rotor.
    pub radial_load_table: Option<TimeTable>,
    /// Unbalance that turns with the inner ring; not with a rotor.
    pub unbalance: Unbalance,
    /// Load out of the plane.
    pub space: SpatialLoad,
}

impl Operation {
    /// Largest ωi, rad/s.
    pub fn largest_inner_speed_rad_s(&self) -> f64 {
        let table = self.inner_speed_table.as_ref();
        table.map_or(self.inner_speed_rad_s, |table| table.range()[1])
    }

    /// Largest force of the unbalance, m·e·ωi², N.
    pub fn unbalance_force_n(&self) -> f64 {
        self.unbalance.amount_kg_m * self.largest_inner_speed_rad_s().powi(2)
    }

    /// The force of the unbalance over time; none without one.
    pub(crate) fn unbalance_force(&self) -> Option<UnbalanceForce> {
        let speed = self.inner_speed_table.as_ref();
        UnbalanceForce::new(self.unbalance, self.inner_speed_rad_s, speed)
    }

    /// How a clockwise bearing is shown; empty for the other sense of rotation.
    pub fn view(&self) -> &'static str {
        if self.clockwise {
            "The inner ring turns clockwise: the bearing is seen from its other face, from which it \
             turns counter-clockwise; angles are positive in the sense of rotation."
        } else {
            ""
        }
    }

    /// Operation with its time counted from `time_s`.
    pub fn from_time(&self, time_s: f64) -> Self {
        let mut later = self.clone();
        if let Some(force) = self.unbalance_force() {
            later.unbalance.phase_rad = force.direction_rad(time_s);
        }
        for (value, table) in [
            (&mut later.inner_speed_rad_s, &mut later.inner_speed_table),
            (&mut later.radial_load_n, &mut later.radial_load_table),
        ] {
            if let Some(table) = table {
                *table = table.beginning_at(time_s);
                *value = table.value(0.0);
            }
        }
        later
    }
}

/// Gaps between neighbouring balls at the start.
#[derive(Debug, Clone, PartialEq)]
pub enum Gaps {
    /// 2π/N − ε everywhere.
    Uniform,
    /// N gaps; gap k lies between ball k and ball k+1 (the last: ball N and ball 1).
    List(Vec<f64>),
}

/// Gaps within a bunch over the mean gap: balls that share a load at different contact angles sit at different
/// radii, and would overlap if they touched on the pitch circle.
const GAP_IN_BUNCH: f64 = 0.05;

impl Gaps {
    /// Balls in one group, which begins with ball 1.
    pub fn bunched(bearing: &Bearing) -> Self {
        Self::List(bunched_gaps_rad(bearing))
    }

    /// Gaps of which every division of the free angle is equally likely, by a seed.
    pub fn random(bearing: &Bearing, seed: u64) -> Self {
        /// Number of this use of random numbers among all.
        const START: u64 = 101;
        let mut stream = RandomStream::new(seed, START, 0, 0);
        Self::List(random_gaps_rad(bearing, &mut stream))
    }

    /// Gaps of start `start` under `seed`, each drawn evenly between 0 and twice the mean and scaled to the free
    /// angle, rad.
    pub fn uneven_rad(bearing: &Bearing, seed: u64, start: u64) -> Vec<f64> {
        let count = bearing.balls();
        let drawn: Vec<f64> = (0..count as u64).map(|k| unit(seed, start, k)).collect();
        let free_rad = count as f64 * bearing.nominal_gap_rad();
        let sum: f64 = drawn.iter().sum();
        drawn.iter().map(|d| d / sum * free_rad).collect()
    }
}

/// A number in (0, 1) for each triple of numbers.
fn unit(seed: u64, start: u64, k: u64) -> f64 {
    let of_start = seed.wrapping_add((start + 1).wrapping_mul(0xd1b5_4a32_d192_ed03));
    let z = split_mix(of_start, k + 1);
    ((z >> 12) as f64 + 0.5) / (1u64 << 52) as f64
}

/// Gaps of [`Gaps::bunched`], rad.
pub(crate) fn bunched_gaps_rad(bearing: &Bearing) -> Vec<f64> {
    let (count, mean_rad) = (bearing.balls(), bearing.mean_gap_rad());
    let within_rad = GAP_IN_BUNCH * mean_rad;
    let mut gaps_rad = vec![within_rad; count];
    gaps_rad[count - 1] = count as f64 * mean_rad - (count - 1) as f64 * within_rad;
    gaps_rad
}

/// Exponential numbers over their sum, times the free angle, rad.
pub(crate) fn random_gaps_rad(bearing: &Bearing, stream: &mut RandomStream) -> Vec<f64> {
    let shares: Vec<_> = (0..bearing.balls()).map(|_| stream.exponential()).collect();
    let scale = bearing.balls() as f64 * bearing.mean_gap_rad() / shares.iter().sum::<f64>();
    shares.iter().map(|share| share * scale).collect()
}

/// Initial state of rings and balls, but for where the balls are along the raceways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StartState {
    /// Static equilibrium at speed, balls rolling.
    Settled,
    /// Every ball on Rm in pure rolling, the ring at rest where it is put.
    Rolling {
        /// Centre of the inner ring.
        ring_x_m: f64,
        /// Centre of the inner ring.
        ring_y_m: f64,
    },
    /// Everything at rest in the middle: balls on Rm, both rings at the centre.
    AtRest,
}

/// Initial state.
#[derive(Debug, Clone, PartialEq)]
pub struct Start {
    /// State of rings and balls.
    pub state: StartState,
    /// Gaps at the start.
    pub gaps: Gaps,
    /// ψ of ball 1.
    pub lead_ball_angle_rad: f64,
}

impl Start {
    /// The start with these gaps, ball 1 at `lead_ball_angle_rad`.
    pub fn new(state: StartState, gaps: Gaps, lead_ball_angle_rad: f64) -> Self {
        Self {
            state,
            gaps,
            lead_ball_angle_rad,
        }
    }
}

/// Method and step of the integration.
#[derive(Debug, Clone, PartialEq)]
pub struct Solver {
    /// Method.
    pub method: IntegrationMethod,
    /// Step; the largest one of the adaptive method.
    pub step_s: f64,
    /// Error per step of the adaptive method, in the scales 10 µm, 1 m/s, 200 rad/s (ring
    /// 0.1 m/s).
    pub tolerance: f64,
    /// Simulated time.
    pub duration_s: f64,
    /// Time at its start that results leave out; `None`: two orbits of the balls, at most half.
    pub transient_s: Option<f64>,
}

impl Solver {
    /// Steps of the whole time; at least as many with the adaptive method.
    pub fn steps(&self) -> f64 {
        (self.duration_s / self.step_s).ceil()
    }
}

/// Housing that carries the outer ring: one mass on a spring and a damper in
/// each direction. It turns the reaction on the outer ring into an acceleration;
/// the ring itself stays fixed in the equations of motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Housing {
    /// Mass of housing and outer ring.
    pub mass_kg: f64,
    /// Stiffness of the support.
    pub stiffness_n_m: f64,
    /// Damping of the support.
    pub damping_n_s_m: f64,
}

/// The physics of one computation, complete.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Rings and balls.
    pub bearing: Bearing,
    /// Discrete raceways; none for a conventional outer ring.
    pub raceways: Vec<Raceway>,
    /// Loads and speed.
    pub operation: Operation,
    /// Contact and friction.
    pub contact: Contact,
    /// Equations.
    pub formulation: Formulation,
    /// Space in which the bearing moves.
    pub motion: Motion,
    /// Flanks of the discrete raceways in the plane.
    pub flanks: FlankModel,
    /// Initial state.
    pub start: Start,
    /// Integration.
    pub solver: Solver,
    /// Housing for the vibration of the outer ring.
    pub housing: Option<Housing>,
    /// Rotor that falls onto the inner ring at t = 0.
    pub rotor: Option<Rotor>,
    /// Support of the outer ring under a rotor; without one it is fixed.
    pub support: Option<Support>,
    /// Rows of balls on one inner ring; none for a single row in the middle plane.
    pub rows: Vec<Row>,
    /// Oil film of the contacts with the raceways; the motion is dry without one.
    pub film: Option<Film>,
}

/// K of a ball between two raceways whose forces on it are equal, N·m^(−3/2).
pub(crate) fn series_stiffness_n_m1_5(inner: f64, outer: f64) -> f64 {
    (inner.powf(-2.0 / 3.0) + outer.powf(-2.0 / 3.0)).powf(-1.5)
}

/// Sliding speed that nothing reaches, over that of the fastest surface: two of them that meet head on have twice it.
const SLIDING_OVER_SURFACE: f64 = 4.0;

/// Least of such a sliding speed, m/s: parts that start at rest move as well.
const SLIDING_BOUND_MIN_M_S: f64 = 10.0;

/// Longest run that is accepted, in steps.
pub(crate) const STEPS_MAX: f64 = 1e12;

/// Shortest run that is accepted.
pub(crate) const DURATION_MIN_S: f64 = 1e-15;

impl Case {
    /// N, balls of all rows.
    pub fn balls(&self) -> usize {
        self.bearing.balls() * self.rows.len().max(1)
    }

    /// The rows of the bearing, that of a bearing without further rows in the middle plane.
    pub fn all_rows(&self) -> Vec<Row> {
        match self.rows.is_empty() {
            false => self.rows.clone(),
            true => vec![Row::default()],
        }
    }

    /// Indices of the rows whose outer rings slide under preload springs.
    pub(crate) fn sprung_rows(&self) -> Vec<usize> {
        let rows = self.rows.iter().enumerate();
        let sprung = rows.filter(|(_, row)| row.preload_n > 0.0);
        sprung.map(|(row, _)| row).collect()
    }

    /// Growth of the diameter of the inner raceway at the largest speed of the inner ring, m: that of a free ring from
    /// bore to bottom of the groove.
    pub fn speed_expansion_m(&self) -> f64 {
        let raceway_m = 2.0 * self.bearing.dimensions().inner_groove_bottom_radius_m;
        let diameters = RingDiameters {
            inside_m: 2.0 * self.bearing.bore_radius_or_estimate_m(),
            outside_m: raceway_m,
        };
        let speed_rad_s = self.largest_inner_speed_rad_s();
        rotating_growth_m(
            &self.bearing.materials().ring,
            speed_rad_s,
            &diameters,
            raceway_m,
        )
    }

    /// Largest ωi of the run, rad/s; with a rotor that of an inner ring without balls that rolls
    /// on the rotor at its speed at the start.
    pub fn largest_inner_speed_rad_s(&self) -> f64 {
        match (&self.rotor, self.bearing.inner_ring_bore()) {
            (Some(rotor), Some(bore)) => {
                rotor.speed_rad_s.abs() * (bore.radius_m - rotor.radial_clearance_m) / bore.radius_m
            }
            _ => self.operation.largest_inner_speed_rad_s(),
        }
    }

    /// Largest Fr of the run, N.
    pub(crate) fn largest_radial_load_n(&self) -> f64 {
        let table = self.operation.radial_load_table.as_ref();
        table.map_or(self.operation.radial_load_n, |t| t.range()[1])
    }

    /// Whether speed and load are constant.
    pub fn has_constant_operation(&self) -> bool {
        self.check_constant_operation("").is_ok()
    }

    /// Orbital speed of a nominal ball that rolls on the plain raceway, rad/s, at the largest
    /// speed of the inner ring.
    pub fn rolling_orbit_speed_rad_s(&self) -> f64 {
        let bearing = &self.bearing;
        rolling_orbit_speed_rad_s(
            bearing,
            self.largest_inner_speed_rad_s(),
            bearing.ball_radius_m(),
        )
    }

    /// Sliding speed that no contact of the case reaches, m/s: four times that of the fastest surface, at least 10 m/s.
    pub(crate) fn sliding_speed_bound_m_s(&self) -> f64 {
        let groove_m = self.bearing.dimensions().inner_groove_bottom_radius_m;
        let ring_m_s = self.largest_inner_speed_rad_s().abs() * groove_m;
        let bore_m = self.bearing.inner_ring_bore().map(|bore| bore.radius_m);
        let journal_m_s = self.rotor.as_ref().zip(bore_m).map(|(rotor, bore_m)| {
            let gain = rotor.drive_torque_n_m / rotor.polar_inertia_kg_m2 * self.solver.duration_s;
            let turning_m_s = (rotor.speed_rad_s.abs() + gain.abs()) * bore_m;
            turning_m_s + rotor.vx_m_s.hypot(rotor.vy_m_s).hypot(rotor.vz_m_s)
        });
        let surface_m_s = ring_m_s.max(journal_m_s.unwrap_or(0.0));
        (SLIDING_OVER_SURFACE * surface_m_s).max(SLIDING_BOUND_MIN_M_S)
    }

    /// Time of one orbit of such a ball, s.
    pub fn rolling_orbit_s(&self) -> f64 {
        TAU / self.rolling_orbit_speed_rad_s()
    }

    /// Centrifugal force on such a ball, N.
    pub(crate) fn centrifugal_force_n(&self) -> f64 {
        let bearing = &self.bearing;
        let speed = self.rolling_orbit_speed_rad_s() * bearing.pitch_radius_m();
        bearing.ball_mass_kg() * speed.powi(2) / bearing.pitch_radius_m()
    }

    /// Force with which rings that fit together by interference press each nominal ball without
    /// load, weight and speed, N: both contacts in series; 0 unless the clearance is negative. That of
    /// an axial preload is `axial_preload_n`.
    pub fn preload_n(&self) -> f64 {
        let [inner, outer, _] = self.stiffness_n_m1_5();
        let interference = (-0.5 * self.bearing.radial_internal_clearance_m()).max(0.0);
        series_stiffness_n_m1_5(inner, outer) * interference.powf(1.5)
    }

    /// Force with which the largest axial preload of a row presses each of its balls between rings that
    /// nothing else moves, N.
    pub(crate) fn axial_preload_n(&self) -> f64 {
        let most = |of: fn(&Row) -> f64| self.rows.iter().map(of).fold(0.0, f64::max);
        let by_displacement_n = self.pressed_along_axis(most(|row| row.preload_m))[0];
        match most(|row| row.preload_n) {
            0.0 => by_displacement_n,
            spring_n => by_displacement_n.max(self.thrust_on_ball(spring_n)[0]),
        }
    }

    /// Largest axial force of `balls` balls between unloaded rings, N: each bears 4200 MPa.
    pub(crate) fn axial_preload_max_n(&self, balls: usize) -> f64 {
        let [force_n, sine] = self.pressed_along_axis(self.bearing.axial_preload_max_m());
        balls as f64 * force_n * sine
    }

    /// Force with which a ball is pressed between rings that nothing moves but a displacement along the
    /// axis from where they touch it, N, and the sine of its contact angle there.
    pub(crate) fn pressed_along_axis(&self, displacement_m: f64) -> [f64; 2] {
        let [inner, outer, _] = self.stiffness_n_m1_5();
        let room = self.bearing.dimensions().groove_distance_m();
        let approach = self.bearing.axial_approach_m(displacement_m);
        let angle = self.bearing.contact_angle_rad();
        let sine = (room * angle.sin() + displacement_m) / (room + approach);
        [
            series_stiffness_n_m1_5(inner, outer) * approach.powf(1.5),
            sine,
        ]
    }

    /// Force with which each ball of one row bears a thrust without any other load, N, and the sine of its
    /// contact angle then.
    pub(crate) fn thrust_on_ball(&self, thrust_n: f64) -> [f64; 2] {
        let balls = self.bearing.balls() as f64;
        let beyond = |displacement_m: f64| {
            let [force_n, sine] = self.pressed_along_axis(displacement_m);
            balls * force_n * sine - thrust_n
        };
        let most = self.bearing.dimensions().groove_distance_m();
        let displacement_m = root::brent(beyond, 0.0, most, 0.0).unwrap_or(most);
        self.pressed_along_axis(displacement_m)
    }

    /// K at the inner raceway, at the outer raceway and between balls, N·m^(−3/2): as
    /// given, else from Hertz.
    pub fn stiffness_n_m1_5(&self) -> [f64; 3] {
        let (c, b) = (&self.contact, &self.bearing);
        [
            c.inner_stiffness_n_m1_5
                .unwrap_or(b.inner_contact().stiffness_n_m1_5),
            c.outer_stiffness_n_m1_5
                .unwrap_or(b.outer_contact().stiffness_n_m1_5),
            c.ball_stiffness_n_m1_5
                .unwrap_or(b.ball_contact().stiffness_n_m1_5),
        ]
    }

    /// K of ball `k` at the inner raceway, at the outer raceway and against the ball ahead,
    /// N·m^(−3/2): as given, else from Hertz with the radii of these balls.
    pub(crate) fn ball_stiffness_n_m1_5(&self, k: usize) -> [f64; 3] {
        let c = &self.contact;
        let [inner, outer, ball] = self.bearing.ball_stiffness_n_m1_5(k);
        [
            c.inner_stiffness_n_m1_5.unwrap_or(inner),
            c.outer_stiffness_n_m1_5.unwrap_or(outer),
            c.ball_stiffness_n_m1_5.unwrap_or(ball),
        ]
    }

    /// Whether every ball sits in the outer ring where a nominal one does in a raceway as
    /// designed.
    pub(crate) fn has_nominal_geometry(&self) -> bool {
        self.bearing.ball_radius_deviations_m().is_empty()
            && self.raceways.iter().all(Raceway::is_flush)
    }

    /// Case with a plain outer raceway in place of its discrete ones.
    pub fn conventional(&self) -> Self {
        self.with_raceways(vec![])
    }

    /// Form of the first raceway; without one the quartic shape of Zhao 2022, on elastic flanks with machined
    /// ends.
    pub fn raceway_form(&self) -> RacewayForm {
        let quartic = || RacewayForm {
            ends: self.flanks.usual_ends(),
            ..RacewayForm::default()
        };
        self.raceways.first().map_or_else(quartic, Raceway::form)
    }

    /// Case with other raceways.
    pub fn with_raceways(&self, raceways: Vec<Raceway>) -> Self {
        Self {
            raceways,
            ..self.clone()
        }
    }
}
