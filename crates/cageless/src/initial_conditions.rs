//! The state that a run starts from.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::initial_state;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let (state, angles) = initial_state(&case)?;
//! assert_eq!(angles.len(), 14);
//! assert!(state.y_m()[0] < 0.0); // ball 1 at the bottom
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::ball::BallMotion;
use crate::case::{Case, Row, StartState, Tilt};
use crate::control::Control;
use crate::dynamics::layout::Layout;
use crate::dynamics::state::State;
use crate::equilibrium::space::{self, SpatialEquilibrium};
use crate::equilibrium::{
    self, EquilibriumError, effective_radius_m, settle_controlled, start_angles_rad,
};
use crate::kinematics::{
    orbit_speed_of_rad_s, rolling_relative_rotation_rad_s, rolling_rotation_rad_s,
};
use crate::numerics::vector::PlaneVector;
use crate::step_limits;
use crate::world::body::{self, RestingRing};

/// State at t = 0 and ψ of every ball.
///
/// `Rolling`: balls on Rm, or with interference where both rings press them alike, with Ω(r) and the spin of Zhao 2022, Eq. (1) to (3), each with
/// its own r. `Settled`: the same speeds at the distances of the static equilibrium. In the
/// `physical` formulation no contact slides then; in `paper` the inner one by some mm/s, as
/// its Eq. (2) and (3) agree only on Rm. `AtRest`: balls there and both rings at the centre, all
/// at rest, and the rotor, if there is one, where the magnetic bearing held it.
///
/// # Errors
/// The case is impossible, has no equilibrium, or one in which balls overlap.
pub fn initial_state(case: &Case) -> Result<(State, Vec<f64>), EquilibriumError> {
    initial_state_controlled(case, &mut || Control::Continue(()))
}

/// [`initial_state`], with `control` called before every place of the ring that is tried.
///
/// # Errors
/// Those of [`initial_state`], or `control` ended the search.
pub fn initial_state_controlled(
    case: &Case,
    control: &mut dyn FnMut() -> Control,
) -> Result<(State, Vec<f64>), EquilibriumError> {
    step_limits::check(case)?;
    case.check_motion()?;
    let beginning = Beginning::of_case(case, control)?;
    let mut state = State::zero(Layout::of_case(case));
    // Every row alike.
    let angles = start_angles_rad(case).repeat(beginning.rows.len());
    for (k, &angle_rad) in angles.iter().enumerate() {
        beginning.set_ball(&mut state, k, angle_rad);
    }
    for (coordinate, value) in body::start(case, &beginning.resting_ring()) {
        state.set(coordinate, value);
    }
    let sliding = body::sliding_ring::start_m(&beginning.rows, &beginning.row_preload_m);
    for (k, z_m) in sliding.enumerate() {
        state.set_sliding(k, z_m);
    }
    Ok((state, angles))
}

/// Places of rings and balls at the start of a case.
struct Beginning<'a> {
    case: &'a Case,
    rows: Vec<Row>,
    /// The equilibrium from which they are taken, if there is one.
    resting: Option<SpatialEquilibrium>,
    /// Centre of the inner ring in the plane, m.
    ring_m: [f64; 2],
    /// |rb| of every ball, m.
    ball_distance_m: Vec<f64>,
    /// Displacement of the outer ring of each row against its contact sign, m.
    row_preload_m: Vec<f64>,
}

impl<'a> Beginning<'a> {
    fn of_case(
        case: &'a Case,
        control: &mut dyn FnMut() -> Control,
    ) -> Result<Self, EquilibriumError> {
        let rows = case.all_rows();
        let resting = resting_at_start(case, &rows, control)?;
        let (ring_m, ball_distance_m) = match (&resting, case.start.state) {
            (Some(e), _) => (
                [e.rest.ring_x_m, e.rest.ring_y_m],
                e.rest.ball_distance_m.clone(),
            ),
            (None, StartState::Rolling { ring_x_m, ring_y_m }) => {
                let ring_m = [ring_x_m, ring_y_m];
                let place_m = PlaneVector {
                    x: ring_x_m,
                    y: ring_y_m,
                };
                (ring_m, distances_between_rings_m(case, place_m))
            }
            (None, _) => (
                [0.0; 2],
                distances_between_rings_m(case, PlaneVector::default()),
            ),
        };
        let row_preload_m = match &resting {
            Some(e) => e.row_preload_m.clone(),
            // A rolling start finds outer rings where their springs held them at rest.
            None if rows.iter().any(|row| row.preload_n > 0.0) => {
                space::solve_controlled(&at_rest(case), control)?.row_preload_m
            }
            None => rows.iter().map(|row| row.preload_m).collect(),
        };
        Ok(Self {
            case,
            rows,
            resting,
            ring_m,
            ball_distance_m,
            row_preload_m,
        })
    }

    /// Ball `k` at ψ = `angle_rad`.
    fn ball(&self, k: usize, angle_rad: f64) -> Rest {
        if let Some(e) = &self.resting {
            let rest = Rest::of_ball(e, k);
            return match self.case.start.state {
                StartState::AtRest => Rest {
                    orbit_speed_rad_s: 0.0,
                    ..rest
                },
                StartState::Settled | StartState::Rolling { .. } => rest,
            };
        }
        let bearing = &self.case.bearing;
        let (row, in_row) = (k / bearing.balls(), k % bearing.balls());
        let r = effective_radius_m(self.case, in_row, angle_rad, self.ball_distance_m[k]);
        let radius_m = bearing.ball(in_row).radius_m;
        let inner_speed = inner_speed_at_start_rad_s(self.case);
        let preload_m = self.row_preload_m[row];
        let row = &self.rows[row];
        Rest {
            effective_radius_m: r,
            orbit_speed_rad_s: orbit_speed_of_rad_s(bearing, radius_m, inner_speed, r),
            // Halfway between where its grooves hold it.
            z_m: row.axial_position_m - 0.5 * row.contact_sign * preload_m,
            pitch_angle_rad: 0.0,
        }
    }

    /// Sets the motion of ball `k` at ψ = `angle_rad`.
    fn set_ball(&self, state: &mut State, k: usize, angle_rad: f64) {
        let (case, distance) = (self.case, self.ball_distance_m[k]);
        let bearing = &case.bearing;
        let rest = self.ball(k, angle_rad);
        let (r, orbit) = (rest.effective_radius_m, rest.orbit_speed_rad_s);
        let (speed, spin) = match case.formulation.equations().spin_relative_to_orbit {
            false => (
                orbit * bearing.pitch_radius_m(),
                rolling_rotation_rad_s(bearing, orbit, r),
            ),
            true => (
                orbit * distance,
                rolling_relative_rotation_rad_s(bearing, orbit, r),
            ),
        };
        let (sin, cos) = angle_rad.sin_cos();
        let (across, along) = rest.pitch_angle_rad.sin_cos();
        state.set_ball(
            k,
            BallMotion {
                x: distance * sin,
                y: -distance * cos,
                vx: speed * cos,
                vy: speed * sin,
                spin: spin * along,
            },
        );
        // The axis of rotation lies across the force at the outer raceway.
        state.set_ball_in_space(k, rest.z_m, [spin * across * sin, -spin * across * cos]);
    }

    /// The inner ring.
    fn resting_ring(&self) -> RestingRing {
        let held = match self.case.operation.space.tilt {
            Tilt::Held { x_rad, y_rad } => [x_rad, y_rad],
            Tilt::Free { .. } => [0.0; 2],
        };
        let rest = self.resting.as_ref();
        let [x_rad, y_rad] = rest.map_or(held, |e| [e.tilt_x_rad, e.tilt_y_rad]);
        let [x_m, y_m] = self.ring_m;
        RestingRing {
            place_m: [x_m, y_m, rest.map_or(0.0, |e| e.ring_z_m)],
            axis: [y_rad, -x_rad],
        }
    }
}

/// ωi at the start, rad/s.
fn inner_speed_at_start_rad_s(case: &Case) -> f64 {
    match case.start.state {
        StartState::AtRest => 0.0,
        StartState::Settled | StartState::Rolling { .. } => case.operation.inner_speed_rad_s,
    }
}

/// |rb| of every ball about an inner ring that is put somewhere, m: Rm, but where rings press the balls, which would
/// spring from there to where the two forces are equal.
fn distances_between_rings_m(case: &Case, ring_m: PlaneVector) -> Vec<f64> {
    let bearing = &case.bearing;
    match bearing.radial_internal_clearance_m() < 0.0 {
        true => {
            let inner_speed = inner_speed_at_start_rad_s(case);
            let of_row = equilibrium::seated_distances_m(case, ring_m, inner_speed);
            of_row.repeat(case.all_rows().len())
        }
        false => vec![bearing.pitch_radius_m(); case.balls()],
    }
}

/// The equilibrium from which a case starts; `None` of a start that has none.
fn resting_at_start(
    case: &Case,
    rows: &[Row],
    control: &mut dyn FnMut() -> Control,
) -> Result<Option<SpatialEquilibrium>, EquilibriumError> {
    match case.start.state {
        StartState::Rolling { .. } => Ok(None),
        StartState::Settled => {
            let settled = settle_controlled(case, control)?;
            settled.rest.check_balls_apart(&case.bearing)?;
            Ok(Some(settled))
        }
        StartState::AtRest => {
            let preloaded = rows
                .iter()
                .any(|row| row.preload_n > 0.0 || row.preload_m > 0.0);
            // Rows hold each other's balls; those without preload may be too loose for an equilibrium.
            if !preloaded && rows.len() == 1 {
                return Ok(None);
            }
            match space::solve_controlled(&at_rest(case), control) {
                Err(EquilibriumError::NotConverged { .. }) if !preloaded => Ok(None),
                found => found.map(Some),
            }
        }
    }
}

/// Equilibrium of a bearing in space before a rotor falls or loads come: of rows that press each other.
///
/// # Errors
/// Those of [`space::solve`].
pub fn unloaded_equilibrium(case: &Case) -> Result<SpatialEquilibrium, EquilibriumError> {
    space::solve(&at_rest(case))
}

/// A bearing at rest before a rotor falls or loads come: nothing loads it, and it hardly turns, as what keeps an unloaded
/// ball in its groove is next to nothing.
fn at_rest(case: &Case) -> Case {
    let mut still = case.clone();
    still.operation.inner_speed_rad_s = 1e-2 * case.largest_inner_speed_rad_s().max(1.0);
    (still.operation.gravity_m_s2, still.operation.radial_load_n) = (0.0, 0.0);
    still.operation.space.axial_load_n = 0.0;
    (
        still.operation.inner_speed_table,
        still.operation.radial_load_table,
    ) = (None, None);
    (still.rotor, still.support) = (None, None);
    still
}

/// A ball at the start.
struct Rest {
    effective_radius_m: f64,
    orbit_speed_rad_s: f64,
    z_m: f64,
    pitch_angle_rad: f64,
}

impl Rest {
    /// Ball `k` in equilibrium.
    fn of_ball(e: &SpatialEquilibrium, k: usize) -> Self {
        let angle = e.outer_contact_angle_rad[k];
        Self {
            effective_radius_m: e.rest.effective_radius_m[k],
            orbit_speed_rad_s: e.orbit_speed_rad_s[k],
            z_m: e.ball_z_m[k],
            pitch_angle_rad: if angle.is_nan() { 0.0 } else { angle },
        }
    }
}
