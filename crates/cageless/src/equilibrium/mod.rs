//! Static equilibrium at speed: where the ring settles and how the balls share the load.
//!
//! Each ball stays at its ψ and takes its weight, the centrifugal force m·vt²/|rb| of
//! rolling (in the `paper` formulation Fw of Zhao 2022, Eq. (15), on top) and the normal
//! forces of both raceways; friction is left out. The ring takes load, weight and the
//! reactions.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::equilibrium;
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//!
//! let rest = equilibrium::solve(&case)?;
//! assert!(rest.ring_y_m < 0.0); // the load presses the ring down
//! assert_eq!(rest.inner_force_n.len(), 14);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod ball_seat;
mod error;
mod plane;
pub mod space;

use std::convert::Infallible;

use crate::case::Case;
use crate::contact::hertz::{PointContact, STRESS_LIMIT_PA};
use crate::control::Control;
use crate::flank_model::FlankModel;
use crate::formulation::Formulation;
use crate::numerics::vector::PlaneVector;
pub(crate) use ball_seat::{ball_outer_geometry, effective_radius_m, start_angles_rad};
pub use error::EquilibriumError;
pub use plane::Equilibrium;
use space::SpatialEquilibrium;

/// Message of `Equilibrium::overload` for a case, at the time of its largest load or speed; `None` also without
/// equilibrium.
pub fn overload(case: &Case) -> Option<String> {
    let held = case.extreme_times_s();
    held.into_iter().find_map(|t| overload_of(&case.held_at(t)))
}

fn overload_of(case: &Case) -> Option<String> {
    let bearing = &case.bearing;
    let operation = &case.operation;
    let balls_kg = bearing.balls() as f64 * bearing.ball_mass_kg();
    let most = operation.radial_load_n
        + case.preload_n()
        + (bearing.dimensions().inner_ring_mass_kg + balls_kg) * operation.gravity_m_s2
        + case.centrifugal_force_n();
    // One ball that carried everything would bear it easily, on a discrete raceway as well.
    let easily = |contact: &PointContact| contact.peak_pressure_pa(most) < 0.8 * STRESS_LIMIT_PA;
    if easily(bearing.inner_contact()) && easily(bearing.outer_contact()) {
        return None;
    }
    solve(case).ok()?.overload()
}

impl SpatialEquilibrium {
    /// Warnings, as sentences, of overload, truncated contact ellipses and rows without thrust.
    pub fn warnings(&self, case: &Case) -> Vec<String> {
        let overload = self.rest.overload().into_iter();
        let edges_rad = ellipse_edge_max_rad(case).unwrap_or(self.ellipse_edge_max_rad);
        let truncated = case.bearing.truncation_warnings(edges_rad);
        let rows = self.rows_without_thrust(case);
        overload.chain(truncated).chain(rows).collect()
    }
}

/// Largest |α| + a/R to which a contact ellipse reaches at rest, inner and outer groove, rad, at the times of the largest
/// load and speed; in the plane on flanks that yield, also where those of the case are rigid. `None` without equilibrium.
pub fn ellipse_edge_max_rad(case: &Case) -> Option<[f64; 2]> {
    let times = case.extreme_times_s().into_iter();
    let edges = times.filter_map(|t| ellipse_edge_of_rad(&case.held_at(t)));
    edges.reduce(|a, b| [0, 1].map(|ring| a[ring].max(b[ring])))
}

fn ellipse_edge_of_rad(case: &Case) -> Option<[f64; 2]> {
    let yielding = Case {
        flanks: FlankModel::Elastic,
        formulation: Formulation::Physical,
        ..case.clone()
    };
    let as_it_is = case.moves_in_space() || case.raceways.is_empty();
    let settled = settle(if as_it_is { case } else { &yielding });
    Some(settled.ok()?.ellipse_edge_max_rad)
}

/// Solves the equilibrium of `case` with its balls at their starting angles, in the plane.
///
/// # Errors
/// The case is impossible or not planar, or the iteration does not converge.
pub fn solve(case: &Case) -> Result<Equilibrium, EquilibriumError> {
    Ok(in_plane(case, &mut || Control::Continue(()))?.rest)
}

/// Solves the equilibrium of `case`, in space where it moves there.
///
/// # Errors
/// Those of [`solve`] and of [`space::solve`].
pub fn settle(case: &Case) -> Result<SpatialEquilibrium, EquilibriumError> {
    settle_controlled(case, &mut || Control::Continue(()))
}

/// [`settle`], with `control` called before every place of the ring that is tried.
///
/// # Errors
/// Those of [`settle`], or `control` ended the search.
pub fn settle_controlled(
    case: &Case,
    control: &mut dyn FnMut() -> Control,
) -> Result<SpatialEquilibrium, EquilibriumError> {
    match case.moves_in_space() {
        true => space::solve_controlled(case, control),
        false => in_plane(case, control),
    }
}

fn in_plane(
    case: &Case,
    control: &mut dyn FnMut() -> Control,
) -> Result<SpatialEquilibrium, EquilibriumError> {
    case.check()?;
    case.check_without_rotor()?;
    case.check_planar()?;
    let (balance, settled) = space::settled(case, true, control)?;
    Ok(space::result(case, &balance, &settled).0)
}

/// |rb| of every ball that is in equilibrium at its starting angle, for a given place of the
/// inner ring, which turns at `inner_speed_rad_s`.
pub(crate) fn seated_distances_m(
    case: &Case,
    ring_m: PlaneVector,
    inner_speed_rad_s: f64,
) -> Vec<f64> {
    let Ok((balance, seated)) = space::rolling(case, true, inner_speed_rad_s, |balance| {
        Ok::<_, Infallible>(balance.around([ring_m.x, ring_m.y, 0.0, 0.0, 0.0]))
    });
    let balls = balance.balls.iter().zip(&seated.rests);
    balls
        .map(|(ball, rest)| ball.distance_m(rest.place))
        .collect()
}
