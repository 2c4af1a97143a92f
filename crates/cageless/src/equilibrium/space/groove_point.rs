//! Points at which a ball of a given place touches its grooves.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::equilibrium::space::{outer_points, solve};
//!
//! let mut case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! case.operation.space.axial_load_n = 150.0;
//!
//! // Ball 1, in the middle of the raceway, rests on both flanks.
//! let found = solve(&case)?;
//! let place = [found.rest.ball_distance_m[0], found.ball_z_m[0]];
//! let [plus, minus] = outer_points(&case, 0, 0.0, place, found.rest.outer_force_n[0]);
//! assert!(plus.unwrap().angle_rad > 0.5 && minus.unwrap().angle_rad < -0.5);
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

use super::ball_in_row::outer_section;
use super::{inner_contact, outer_contact, resultant};
use crate::case::Case;
use crate::numerics::vector::SectionVector;
use crate::raceway_contact::RacewayContact;

/// Share of the force below which a flank is left out: its ellipse is shorter than 1 % of the other.
const OPEN: f64 = 1e-6;

/// A point of contact.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroovePoint {
    /// Angle of the normal from the radius.
    pub angle_rad: f64,
    /// Pressure and ellipse there.
    pub contact: RacewayContact,
}

/// Points of ball `k` of all rows, from 0, at ψ and this distance from the axis and z, on the outer
/// raceway under a resultant force: of two flanks that towards +Z first, on the plain raceway the
/// first alone.
pub fn outer_points(
    case: &Case,
    k: usize,
    angle_rad: f64,
    [distance_m, z_m]: [f64; 2],
    resultant_n: f64,
) -> [Option<GroovePoint>; 2] {
    let bearing = &case.bearing;
    let balls = bearing.balls();
    let (row, k) = (case.all_rows()[k / balls], k % balls);
    let touching_m = bearing.dimensions().outer_groove_bottom_radius_m - bearing.ball(k).radius_m;
    let section = outer_section(case, &row, k, angle_rad);
    let contacts = section.contacts(SectionVector {
        radial: distance_m - touching_m,
        axial: z_m - row.axial_position_m,
    });
    let [along, across, _] = resultant(&contacts);
    let force_n = resultant_n / along.hypot(across);
    let mut points = [None; 2];
    for (n, contact) in contacts.iter().enumerate() {
        let angle = contact.angle_rad;
        // One flank alone is that to whose side the ball leans.
        let leans_back = (section.flanks).is_some_and(|f| angle < f.section_angle_rad);
        let other = n == 1 || contacts.len() == 1 && leans_back;
        if force_n > 0.0 && contact.share > OPEN {
            points[usize::from(other)] = Some(GroovePoint {
                angle_rad: angle,
                contact: outer_contact(case, angle_rad, angle, contact.share * force_n),
            });
        }
    }
    points
}

/// Point on the inner raceway under this contact angle and force; `None` without a force.
pub fn inner_point(case: &Case, angle_rad: f64, force_n: f64) -> Option<GroovePoint> {
    (force_n > 0.0).then(|| GroovePoint {
        angle_rad,
        contact: inner_contact(case, angle_rad, force_n),
    })
}
