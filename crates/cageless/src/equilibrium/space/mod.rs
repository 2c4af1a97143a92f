//! Static equilibrium in space: three displacements and two tilts of the inner ring, two
//! coordinates of every ball.
//!
//! Each ball stays at its ψ and moves along the radius and the axis between two grooves, of which
//! the discrete one is taken with both of its flanks; the ring takes radial and axial load,
//! weight, and moments, or its tilt is given. Friction is left out, as in the plane, of which this is
//! the extension: without axial load and tilt the two agree on a conventional ring.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::equilibrium::space;
//!
//! let mut case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! case.operation.space.axial_load_n = 300.0;
//!
//! let rest = space::solve(&case)?;
//! assert!(rest.ring_z_m > 0.0); // the load pushes the ring along +Z
//! // The loaded balls touch the inner ring under an angle.
//! assert!(rest.inner_contact_angle_rad[0] > 0.0);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod ball;
mod ball_in_row;
mod groove_point;
mod load_balance;
pub(crate) mod outer_section;
mod rolling_ball;

use std::convert::Infallible;

use crate::ball::BothContacts;
use crate::bearing::BeyondGroove;
use crate::case::{Case, Row, Tilt};
use crate::control::Control;
use crate::equilibrium::{Equilibrium, EquilibriumError, effective_radius_m, start_angles_rad};
use crate::error::InputError;
use crate::kinematics::orbit_speed_in_space_rad_s;
use crate::numerics::cholesky::solve as solve_equations;
use crate::numerics::vector::SectionVector;
use crate::raceway_contact::{RacewayContact, RacewayPoint};
use ball::{Ring, SpatialBall};
use ball_in_row::ball_in_row;
pub(crate) use ball_in_row::slot;
pub use groove_point::{GroovePoint, inner_point, outer_points};
use load_balance::{Balanced, LoadBalance, Z};
use outer_section::SectionContact;
pub(crate) use rolling_ball::RollingBall;

/// Ring and balls in equilibrium.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct SpatialEquilibrium {
    /// Results in common with a planar equilibrium, for the balls of all rows, one row after the other. A force
    /// at the outer raceway is the resultant of both flanks, a contact there the more loaded one.
    pub rest: Equilibrium,
    /// z of every ball.
    pub ball_z_m: Vec<f64>,
    /// Displacement of the inner ring along the axis.
    pub ring_z_m: f64,
    /// Tilt of the inner ring about X, −q.
    pub tilt_x_rad: f64,
    /// Tilt of the inner ring about Y, p.
    pub tilt_y_rad: f64,
    /// Row of each ball, from 0.
    pub row: Vec<usize>,
    /// Displacement of the outer ring of each row by −σ times this: as given, or by its spring.
    pub row_preload_m: Vec<f64>,
    /// Force of the balls of each row on its outer ring along the axis.
    pub row_axial_force_n: Vec<f64>,
    /// Contact angle at the inner raceway, positive where the axial load along +Z presses; NaN
    /// without contact.
    pub inner_contact_angle_rad: Vec<f64>,
    /// Angle of the force at the outer raceway; NaN without contact.
    pub outer_contact_angle_rad: Vec<f64>,
    /// Forces at the flanks of the outer raceway, that towards +Z first; on the plain raceway the first
    /// is all.
    pub flank_force_n: Vec<[f64; 2]>,
    /// Angles of the normals there from the radius, rad; NaN without contact.
    pub flank_angle_rad: Vec<[f64; 2]>,
    /// Stiffness matrix over (X, Y, Z, tilt about X, tilt about Y), every ball staying in
    /// equilibrium under unchanged centrifugal forces: N/m, N/rad and N, N·m/rad; `None` where
    /// nothing holds the ring in a direction that is free.
    pub stiffness: Option<[[f64; 5]; 5]>,
    /// Orbital speed of each ball in rolling under these contact angles.
    pub orbit_speed_rad_s: Vec<f64>,
    /// Largest |α| + a/R to which a contact ellipse reaches: inner, outer groove.
    pub ellipse_edge_max_rad: [f64; 2],
}

/// Times that the centrifugal forces follow the contact angles.
const SPEED_ROUNDS: usize = 20;

/// Relative change of a centrifugal force that ends them.
const TURNING_TOLERANCE: f64 = 1e-12;

/// Solves the equilibrium of `case` in space with its balls at their starting angles.
///
/// # Errors
/// The case is impossible, a contact leaves its groove, no ball carries a tilted ring, or the
/// iteration does not converge.
pub fn solve(case: &Case) -> Result<SpatialEquilibrium, EquilibriumError> {
    solve_controlled(case, &mut || Control::Continue(()))
}

/// [`solve`], with `control` called before every place of the ring that is tried.
///
/// # Errors
/// Those of [`solve`], or `control` ended the search.
pub(crate) fn solve_controlled(
    case: &Case,
    control: &mut dyn FnMut() -> Control,
) -> Result<SpatialEquilibrium, EquilibriumError> {
    case.check()?;
    case.check_without_rotor()?;
    let (balance, settled) = settled(case, false, control)?;
    let (solved, beyond) = result(case, &balance, &settled);
    check(case, &solved)?;
    match beyond {
        Some(beyond) => Err(beyond.into()),
        None => Ok(solved),
    }
}

/// The lowest place of the ring, and every ball.
pub(super) fn settled(
    case: &Case,
    planar: bool,
    control: &mut dyn FnMut() -> Control,
) -> Result<(LoadBalance, Balanced), EquilibriumError> {
    let depth = contact_depth_m(case);
    let inner_speed = case.operation.inner_speed_rad_s;
    rolling(case, planar, inner_speed, |balance| {
        balance.settle(depth, control)
    })
}

/// Balls that roll at the speeds that their contact angles give, where `seat` puts them.
pub(super) fn rolling<E>(
    case: &Case,
    planar: bool,
    inner_speed_rad_s: f64,
    mut seat: impl FnMut(&LoadBalance) -> Result<Balanced, E>,
) -> Result<(LoadBalance, Balanced), E> {
    let mut balance = balance(case, planar, inner_speed_rad_s);
    let mut seated = seat(&balance)?;
    for _ in 0..SPEED_ROUNDS {
        if !follow_speeds(case, &mut balance, &seated, inner_speed_rad_s) {
            break;
        }
        seated = seat(&balance)?;
    }
    Ok((balance, seated))
}

/// Every ball of a case that rolls, the inner ring held at **R**, p, q.
pub(crate) fn rolling_balls(case: &Case, ring: Ring) -> Vec<RollingBall> {
    let planar = !case.moves_in_space();
    let inner_speed_rad_s = case.operation.inner_speed_rad_s;
    let Ok((balance, seated)) = rolling(case, planar, inner_speed_rad_s, |balance| {
        Ok::<_, Infallible>(balance.around(ring))
    });
    let balls = balance.balls.iter().zip(&seated.rests);
    let rolling = balls.map(|(ball, rest)| {
        let (arms, angle) = arms_m(case, ball, rest.place, ring);
        let orbit = orbit_speed_in_space_rad_s(&case.bearing, inner_speed_rad_s, arms, angle);
        RollingBall {
            angle_rad: ball.angle_rad,
            distance_m: ball.distance_m(rest.place),
            speed_m_s: orbit * case.bearing.pitch_radius_m(),
            outer_arm: arms.outer / ball.radius_m,
            inner_depth_m: ball.inner_depth_m(rest.place, ring),
        }
    });
    rolling.collect()
}

/// Forces of every ball at both raceways and the row of each without weight and centrifugal force,
/// on a plain outer raceway.
///
/// # Errors
/// Those of [`solve`].
pub(crate) fn forces_at_rest(case: &Case) -> Result<SpatialEquilibrium, EquilibriumError> {
    let mut still = case.conventional();
    still.operation.gravity_m_s2 = 0.0;
    // What keeps an unloaded ball in its groove is next to nothing.
    still.operation.inner_speed_rad_s *= 1e-4;
    solve(&still)
}

/// ψ of the balls of a row, with the number of each in its row.
fn row_angles_rad(case: &Case, row: &Row) -> Vec<f64> {
    match row.balls.filter(|n| *n != case.bearing.balls()) {
        None => start_angles_rad(case),
        Some(n) => {
            let lead = case.start.lead_ball_angle_rad;
            let pitch = std::f64::consts::TAU / n as f64;
            (0..n).map(|k| lead + k as f64 * pitch).collect()
        }
    }
}

/// Balls and loads of a case, the balls rolling as in the plane.
fn balance(case: &Case, planar: bool, inner_speed_rad_s: f64) -> LoadBalance {
    let bearing = &case.bearing;
    let d = bearing.dimensions();
    let in_plane = Row {
        contact_sign: 0.0,
        ..Row::default()
    };
    let rows = match planar {
        true => vec![in_plane],
        false => case.all_rows(),
    };
    let mut balls = vec![];
    for (number, row) in rows.iter().enumerate() {
        for (k, angle_rad) in row_angles_rad(case, row).into_iter().enumerate() {
            balls.push(SpatialBall {
                row: number,
                ..ball_in_row(case, row, planar, k, angle_rad, inner_speed_rad_s)
            });
        }
    }
    let weight = d.inner_ring_mass_kg * case.operation.gravity_m_s2;
    let spring = |row: &Row| (row.preload_n > 0.0).then_some(row.contact_sign * row.preload_n);
    LoadBalance {
        planar,
        balls,
        springs_n: rows.iter().map(spring).collect(),
        down_n: case.operation.radial_load_n + weight,
        axial_n: case.operation.space.axial_load_n,
        tilt: case.operation.space.tilt,
        arm_m: bearing.pitch_radius_m(),
        longest_m: 0.05 * bearing.ball_radius_m(),
        clearance_m: bearing.shoulder_clearance_m(),
    }
}

/// Contact of a ball at ψ with the outer raceway under this contact angle and force.
fn outer_contact(
    case: &Case,
    angle_rad: f64,
    contact_angle_rad: f64,
    force_n: f64,
) -> RacewayContact {
    let bearing = &case.bearing;
    match slot(case, angle_rad) {
        Some((slot, local)) => RacewayContact::new(&slot.contact(local, bearing), force_n),
        None => RacewayContact::new(&bearing.contacts_at([contact_angle_rad; 2])[1], force_n),
    }
}

/// Contact with the inner raceway under this contact angle and force.
fn inner_contact(case: &Case, contact_angle_rad: f64, force_n: f64) -> RacewayContact {
    RacewayContact::new(
        &case.bearing.contacts_at([contact_angle_rad; 2])[0],
        force_n,
    )
}

/// Depth of the ring below the middle from which to search: half the clearance and the deflection
/// under the load (Stribeck).
fn contact_depth_m(case: &Case) -> f64 {
    let bearing = &case.bearing;
    let [inner, outer, _] = case.stiffness_n_m1_5();
    let load = case.operation.radial_load_n
        + bearing.dimensions().inner_ring_mass_kg * case.operation.gravity_m_s2;
    let share = 4.37 * load / bearing.balls() as f64;
    let series = crate::case::series_stiffness_n_m1_5(inner, outer);
    let thrown = (case.centrifugal_force_n() / outer).powf(2.0 / 3.0);
    0.5 * bearing.radial_internal_clearance_m().max(0.0) + (share / series).powf(2.0 / 3.0) + thrown
}

/// Arms of rolling at the outer and the inner contact of a ball, and the inner contact angle: the
/// axis of rotation lies across the force at the outer raceway, in the plane along that of the bearing.
fn arms_m(
    case: &Case,
    ball: &SpatialBall,
    place: SectionVector,
    ring: Ring,
) -> (BothContacts, f64) {
    if ball.planar {
        let arm_m = effective_radius_m(case, ball.number, ball.angle_rad, ball.distance_m(place));
        let arms_m = BothContacts {
            outer: arm_m,
            inner: ball.radius_m,
        };
        return (arms_m, 0.0);
    }
    let contacts = ball.outer.contacts(place);
    let inner = ball.inner_contact(place, ring);
    let [along, across, sum] = resultant(&contacts);
    let pitch = if sum > 0.0 { across.atan2(along) } else { 0.0 };
    let outer = if sum > 0.0 {
        along.hypot(across) / sum
    } else {
        1.0
    };
    let angle = inner.map_or(pitch, |(_, angle)| angle);
    let inner = inner.map_or(1.0, |(_, angle)| (angle - pitch).cos());
    let arms_m = BothContacts {
        outer: outer * ball.radius_m,
        inner: inner * ball.radius_m,
    };
    (arms_m, angle)
}

/// Resultant of the forces at a section along the radius and the axis, and their sum, all over the
/// force K δe^(3/2).
fn resultant(contacts: &[SectionContact]) -> [f64; 3] {
    contacts.iter().fold([0.0; 3], |[x, y, sum], c| {
        let (sin, cos) = c.angle_rad.sin_cos();
        [x + c.share * cos, y + c.share * sin, sum + c.share]
    })
}

/// Puts the centrifugal forces right for the contact angles; whether that changes anything.
fn follow_speeds(
    case: &Case,
    balance: &mut LoadBalance,
    settled: &Balanced,
    inner_speed_rad_s: f64,
) -> bool {
    let bearing = &case.bearing;
    let mut changed = false;
    for (ball, rest) in balance.balls.iter_mut().zip(&settled.rests) {
        let (arms, angle) = arms_m(case, ball, rest.place, settled.ring_of(ball.row));
        let speed = bearing.pitch_radius_m()
            * orbit_speed_in_space_rad_s(bearing, inner_speed_rad_s, arms, angle);
        let turning = ball.mass_kg * speed * speed;
        changed |= (turning - ball.turning_n_m).abs() > TURNING_TOLERANCE * turning;
        ball.turning_n_m = turning;
    }
    changed
}

/// The results, and every contact with a groove.
pub(super) fn result(
    case: &Case,
    balance: &LoadBalance,
    settled: &Balanced,
) -> (SpatialEquilibrium, Option<BeyondGroove>) {
    let ring = settled.ring;
    let [inner_stiffness_n_m1_5, outer_stiffness_n_m1_5, _] = case.stiffness_n_m1_5();
    let stiffness = stiffness(settled);
    let held = match balance.tilt {
        Tilt::Held { .. } => holds::<3>(&stiffness, balance.arm_m),
        Tilt::Free { .. } => holds::<5>(&stiffness, balance.arm_m),
    };
    let mut solved = SpatialEquilibrium {
        rest: Equilibrium {
            ring_x_m: ring[0],
            ring_y_m: ring[1],
            inner_stiffness_n_m1_5,
            outer_stiffness_n_m1_5,
            stiffness_n_m: holds::<2>(&stiffness, balance.arm_m)
                .then(|| [0, 1].map(|i| [stiffness[i][0], stiffness[i][1]])),
            ..Equilibrium::default()
        },
        ring_z_m: ring[2],
        tilt_x_rad: -ring[4],
        tilt_y_rad: ring[3],
        row_preload_m: (case.all_rows().iter().zip(&settled.shifts_m))
            .map(|(row, shift)| row.preload_m - row.contact_sign * shift)
            .collect(),
        row_axial_force_n: vec![0.0; settled.shifts_m.len()],
        stiffness: held.then_some(stiffness),
        ..SpatialEquilibrium::default()
    };
    let mut beyond = None;
    for (ball, rest) in balance.balls.iter().zip(&settled.rests) {
        // Without friction the force goes through the ball.
        solved.row_axial_force_n[ball.row] += rest.local.gradient[Z];
        solved
            .ball_z_m
            .push(ball.axial_m + settled.shifts_m[ball.row] + rest.place.axial);
        let ring = settled.ring_of(ball.row);
        beyond = push_ball(&mut solved, case, ball, rest.place, ring).or(beyond);
    }
    let largest =
        |contacts: &[RacewayContact]| contacts.iter().map(|c| c.pressure_pa).fold(0.0, f64::max);
    solved.rest.inner_pressure_max_pa = largest(&solved.rest.inner_contact);
    solved.rest.outer_pressure_max_pa = largest(&solved.rest.outer_contact);
    (solved, beyond)
}

/// Adds the results of one ball; a contact of it beyond a groove.
fn push_ball(
    solved: &mut SpatialEquilibrium,
    case: &Case,
    ball: &SpatialBall,
    place: SectionVector,
    ring: Ring,
) -> Option<BeyondGroove> {
    let seated = SeatedBall::new(case, ball, place, ring);
    let number = solved.row.len();
    let outer_contact = seated.outer_contact();
    let rest = &mut solved.rest;
    rest.ball_angle_rad.push(ball.angle_rad);
    rest.ball_distance_m.push(ball.distance_m(place));
    rest.effective_radius_m.push(seated.arms_m.outer);
    rest.inner_force_n.push(seated.inner_force_n);
    rest.outer_force_n.push(seated.resultant_n);
    rest.inner_contact.push(seated.inner_contact());
    rest.outer_contact.push(outer_contact);
    let flanks = seated.flanks();
    (solved.flank_force_n).push(flanks.map(|flank| flank.force_n));
    (solved.flank_angle_rad).push(flanks.map(|flank| flank.angle_rad));
    solved.row.push(ball.row);
    (solved.inner_contact_angle_rad).push(seated.inner_angle_rad);
    (solved.outer_contact_angle_rad).push(seated.outer_angle_rad);
    solved.orbit_speed_rad_s.push(seated.orbit_speed_rad_s());
    let loaded = seated.on_grooves(outer_contact);
    let beyond = loaded.into_iter().fold(None, |beyond, at| {
        let edge = &mut solved.ellipse_edge_max_rad[at.ring];
        *edge = edge.max(at.angle_rad.abs() + at.contact.semi_axes_m[1] / ball.radius_m);
        beyond.or(case.bearing.beyond_groove(number, at.ring, at.angle_rad))
    });
    // In the plane nothing presses a ball over a shoulder.
    beyond.filter(|_| !ball.planar)
}

/// Contact of a ball with the groove of a ring, 0 the inner one.
struct OnGroove {
    ring: usize,
    angle_rad: f64,
    contact: RacewayContact,
}

/// A ball at rest in its grooves.
struct SeatedBall<'a> {
    case: &'a Case,
    ball: &'a SpatialBall,
    inner_force_n: f64,
    inner_angle_rad: f64,
    outer: Vec<SectionContact>,
    /// K δe^(3/2) at the outer raceway.
    outer_force_n: f64,
    /// Force at the outer raceway and its angle.
    resultant_n: f64,
    outer_angle_rad: f64,
    /// Arms of the contacts with the outer and the inner raceway.
    arms_m: BothContacts,
    /// Angle of the axis of rolling.
    rolling_angle_rad: f64,
}

impl<'a> SeatedBall<'a> {
    fn new(case: &'a Case, ball: &'a SpatialBall, place: SectionVector, ring: Ring) -> Self {
        let (inner_force_n, inner_angle_rad) =
            ball.inner_contact(place, ring).unwrap_or((0.0, f64::NAN));
        let outer = ball.outer.contacts(place);
        let outer_force_n = ball.outer_force_n(place);
        let [along, across, sum] = resultant(&outer);
        let (arms_m, rolling_angle_rad) = arms_m(case, ball, place, ring);
        Self {
            case,
            ball,
            inner_force_n,
            inner_angle_rad,
            outer,
            outer_force_n,
            resultant_n: outer_force_n * along.hypot(across),
            outer_angle_rad: match sum > 0.0 {
                true => across.atan2(along),
                false => f64::NAN,
            },
            arms_m,
            rolling_angle_rad,
        }
    }

    /// r over the radius of the ball.
    fn cosine(&self) -> f64 {
        self.arms_m.outer / self.ball.radius_m
    }

    fn orbit_speed_rad_s(&self) -> f64 {
        let speed = self.case.operation.inner_speed_rad_s;
        orbit_speed_in_space_rad_s(
            &self.case.bearing,
            speed,
            self.arms_m,
            self.rolling_angle_rad,
        )
    }

    fn inner_contact(&self) -> RacewayContact {
        let angle_rad = match self.inner_angle_rad.is_nan() {
            true => 0.0,
            false => self.inner_angle_rad,
        };
        inner_contact(self.case, angle_rad, self.inner_force_n)
    }

    fn outer_contact_at(&self, contact: &SectionContact) -> RacewayContact {
        let force_n = self.outer_force_n * contact.share;
        outer_contact(self.case, self.ball.angle_rad, contact.angle_rad, force_n)
    }

    /// Contact with the outer raceway that bears most.
    fn outer_contact(&self) -> RacewayContact {
        if self.ball.planar {
            // A rigid flank has the angle of the ball on it.
            let point = RacewayPoint::of_outer(self.cosine(), self.resultant_n);
            return RacewayContact::outer(&self.case.bearing, point);
        }
        let heavier = (self.outer.iter()).max_by(|a, b| a.share.total_cmp(&b.share));
        match heavier {
            Some(one) => self.outer_contact_at(one),
            None => outer_contact(self.case, self.ball.angle_rad, 0.0, 0.0),
        }
    }

    /// Loads of the flanks towards +z and −z.
    fn flanks(&self) -> [FlankLoad; 2] {
        match self.ball.planar {
            true => planar_flanks(self.cosine(), self.resultant_n),
            false => flanks_in_space(self.ball, &self.outer, self.outer_force_n),
        }
    }

    /// Contacts under load; `outer_contact` that which bears most.
    fn on_grooves(&self, outer_contact: RacewayContact) -> Vec<OnGroove> {
        let on = |ring: usize, angle_rad: f64, contact: RacewayContact| OnGroove {
            ring,
            angle_rad,
            contact,
        };
        let mut all = match self.ball.planar {
            // One of two points, at the angle of the ball on its flanks.
            true if self.resultant_n > 0.0 => {
                vec![on(1, self.cosine().min(1.0).acos(), outer_contact)]
            }
            true => vec![],
            false => (self.outer.iter())
                .map(|c| on(1, c.angle_rad, self.outer_contact_at(c)))
                .collect(),
        };
        if self.inner_force_n > 0.0 {
            all.push(on(0, self.inner_angle_rad, self.inner_contact()));
        }
        all
    }
}

/// Load of a flank under a ball.
#[derive(Clone, Copy)]
struct FlankLoad {
    force_n: f64,
    angle_rad: f64,
}

impl FlankLoad {
    const NONE: Self = Self {
        force_n: 0.0,
        angle_rad: f64::NAN,
    };
}

/// Loads of the flanks towards +z and −z under a ball in the plane, r over its radius `cosine`; at the plain raceway
/// the first alone.
fn planar_flanks(cosine: f64, resultant_n: f64) -> [FlankLoad; 2] {
    let force_n = RacewayPoint::of_outer(cosine, resultant_n).force_n;
    let at = |angle_rad: f64| FlankLoad { force_n, angle_rad };
    let angle_rad = cosine.min(1.0).acos();
    match cosine < 1.0 {
        true => [at(angle_rad), at(-angle_rad)],
        false => [at(0.0), FlankLoad::NONE],
    }
}

/// Loads of the flanks towards +z and −z under a ball in space.
fn flanks_in_space(
    ball: &SpatialBall,
    contacts: &[SectionContact],
    force_n: f64,
) -> [FlankLoad; 2] {
    let flank = |contact: &SectionContact| FlankLoad {
        force_n: force_n * contact.share,
        angle_rad: contact.angle_rad,
    };
    match contacts {
        [] => [FlankLoad::NONE; 2],
        [one] if one.angle_rad < 0.0 && ball.outer.flanks.is_some() => {
            [FlankLoad::NONE, flank(one)]
        }
        [one] => [flank(one), FlankLoad::NONE],
        [one, other, ..] => [one, other].map(flank),
    }
}

/// The Hessian over (X, Y, Z, −q, p).
fn stiffness(settled: &Balanced) -> [[f64; 5]; 5] {
    const ORDER: [(usize, f64); 5] = [(0, 1.0), (1, 1.0), (2, 1.0), (4, -1.0), (3, 1.0)];
    let hessian = &settled.local.hessian;
    let entry = |i: usize, j: usize| ORDER[i].1 * ORDER[j].1 * hessian[ORDER[i].0][ORDER[j].0];
    std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j)))
}

/// Stiffness of a direction over the largest one below which the ring is free in it.
const FREE: f64 = 1e-9;

/// Whether a stiffness holds the ring in the first `N` directions, tilts taken over the radius of
/// the pitch circle: none is nothing beside the others.
fn holds<const N: usize>(stiffness: &[[f64; 5]; 5], arm_m: f64) -> bool {
    let of = |k: usize| if k < 3 { 1.0 } else { 1.0 / arm_m };
    let even: [[f64; N]; N] =
        std::array::from_fn(|i| std::array::from_fn(|j| stiffness[i][j] * of(i) * of(j)));
    let size = (0..N).map(|k| even[k][k]).fold(0.0, f64::max);
    solve_equations(&even, -FREE * size, [0.0; N]).is_some()
}

/// Refuses an equilibrium that the bearing cannot have.
fn check(case: &Case, solved: &SpatialEquilibrium) -> Result<(), EquilibriumError> {
    let rest = &solved.rest;
    if let (Tilt::Held { x_rad, y_rad }, true) = (
        case.operation.space.tilt,
        rest.inner_force_n.iter().all(|force| *force == 0.0),
    ) {
        for (field, value) in [("tilt_x_rad", x_rad), ("tilt_y_rad", y_rad)] {
            if value != 0.0 {
                let rule = "less, or with a load: no ball touches the inner ring that is tilted so";
                return Err(InputError::rule(field, value, rule).into());
            }
        }
    }
    Ok(())
}

/// Axial share of the force of a row below which nothing presses it.
const LEAST_THRUST: f64 = 1e-3;

impl SpatialEquilibrium {
    /// Warnings of angular-contact rows that carry, but not towards their contact sign.
    pub(super) fn rows_without_thrust(&self, case: &Case) -> Vec<String> {
        if case.bearing.contact_angle_rad() == 0.0 {
            return vec![];
        }
        let rows = case.all_rows();
        let carried_n = |row: usize| {
            let balls = self.row.iter().zip(&self.rest.inner_force_n);
            balls
                .filter(|(of, _)| **of == row)
                .map(|(_, force)| force)
                .sum::<f64>()
        };
        let signed_n = |row: usize| self.row_axial_force_n[row] * rows[row].contact_sign;
        (0..rows.len())
            .filter(|&row| carried_n(row) > 0.0 && signed_n(row) < LEAST_THRUST * carried_n(row))
            .map(|row| {
                format!(
                    "row {} bears {:.0} N along its axis towards its contact sign: an angular-contact row comes \
                     apart or loses its contact angle unless an axial load, a second row or preload presses it",
                    row + 1,
                    // Rounded first, what is below half a newton has no sign.
                    signed_n(row).round() + 0.0
                )
            })
            .collect()
    }
}
