//! The state that a run starts from.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::initial_conditions::initial_state;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let (state, angles) = initial_state(&case)?;
//! assert_eq!(angles.len(), 14);
//! assert!(state.ring_motion().y < 0.0);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use crate::ball::BallMotion;
use crate::case::{Case, StartState, Tilt};
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
    let bearing = &case.bearing;
    let (n, rows) = (bearing.balls(), case.all_rows());
    let pitch = bearing.pitch_radius_m();
    let mut state = State::zero(Layout::of_case(case));
    // Every row alike.
    let angles = start_angles_rad(case).repeat(rows.len());
    let starts_at_rest = case.start.state == StartState::AtRest;
    let inner_speed = match starts_at_rest {
        true => 0.0,
        false => case.operation.inner_speed_rad_s,
    };
    // Balls on Rm between rings that press them would spring to where the two forces are equal.
    let between = |ring| match bearing.radial_internal_clearance_m() < 0.0 {
        true => equilibrium::seated_distances_m(case, ring, inner_speed).repeat(rows.len()),
        false => vec![pitch; case.balls()],
    };
    let sprung = rows.iter().any(|row| row.preload_n > 0.0);
    let preloaded = sprung || rows.iter().any(|row| row.preload_m > 0.0);
    // Rows hold each other's balls; those without preload may be too loose for an equilibrium.
    let mut resting = match starts_at_rest && (preloaded || rows.len() > 1) {
        false => None,
        true => match space::solve_controlled(&at_rest(case), control) {
            Err(EquilibriumError::NotConverged { .. }) if !preloaded => None,
            found => Some(found?),
        },
    };
    let (distances, ring) = match case.start.state {
        StartState::Rolling { ring_x_m, ring_y_m } => {
            (between([ring_x_m, ring_y_m]), [ring_x_m, ring_y_m])
        }
        StartState::AtRest => match &resting {
            Some(e) => (
                e.rest.ball_distance_m.clone(),
                [e.rest.ring_x_m, e.rest.ring_y_m],
            ),
            None => (between([0.0; 2]), [0.0; 2]),
        },
        StartState::Settled => {
            let e = &resting.insert(settle_controlled(case, control)?).rest;
            e.check_balls_apart(bearing)?;
            (e.ball_distance_m.clone(), [e.ring_x_m, e.ring_y_m])
        }
    };
    let row_preload_m = match &resting {
        Some(e) => e.row_preload_m.clone(),
        // A rolling start finds outer rings where their springs held them at rest.
        None if sprung => space::solve_controlled(&at_rest(case), control)?.row_preload_m,
        None => rows.iter().map(|row| row.preload_m).collect(),
    };
    for (k, (&angle, &distance)) in angles.iter().zip(&distances).enumerate() {
        let rest = resting.as_ref().map(|e| Rest {
            orbit_speed_rad_s: if starts_at_rest {
                0.0
            } else {
                e.orbit_speed_rad_s[k]
            },
            ..Rest::of_ball(e, k)
        });
        let rest = rest.unwrap_or_else(|| {
            let r = effective_radius_m(case, k % n, angle, distance);
            let radius = bearing.ball(k % n).radius_m;
            let row = &rows[k / n];
            Rest {
                effective_radius_m: r,
                orbit_speed_rad_s: orbit_speed_of_rad_s(bearing, radius, inner_speed, r),
                // Halfway between where its grooves hold it.
                z_m: row.axial_position_m - 0.5 * row.contact_sign * row_preload_m[k / n],
                pitch_angle_rad: 0.0,
            }
        });
        let (r, orbit) = (rest.effective_radius_m, rest.orbit_speed_rad_s);
        let (speed, spin) = match case.formulation.equations().spin_relative_to_orbit {
            false => (orbit * pitch, rolling_rotation_rad_s(bearing, orbit, r)),
            true => (
                orbit * distance,
                rolling_relative_rotation_rad_s(bearing, orbit, r),
            ),
        };
        let (sin, cos) = angle.sin_cos();
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
    let held = match case.operation.space.tilt {
        Tilt::Held { x_rad, y_rad } => [x_rad, y_rad],
        Tilt::Free { .. } => [0.0; 2],
    };
    let rest = resting.as_ref();
    let [x_rad, y_rad] = rest.map_or(held, |e| [e.tilt_x_rad, e.tilt_y_rad]);
    let resting_ring = RestingRing {
        place_m: [ring[0], ring[1], rest.map_or(0.0, |e| e.ring_z_m)],
        axis: [y_rad, -x_rad],
    };
    for (coordinate, value) in body::start(case, &resting_ring) {
        state.set(coordinate, value);
    }
    for (k, z_m) in body::sliding_ring::start_m(&rows, &row_preload_m).enumerate() {
        state.set_sliding(k, z_m);
    }
    Ok((state, angles))
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
