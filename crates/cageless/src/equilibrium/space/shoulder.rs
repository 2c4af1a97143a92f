//! Contacts against the shoulders of their grooves.

use crate::bearing::Bearing;
use crate::equilibrium::error::{EquilibriumError, degrees};

/// A contact on a groove.
#[derive(Debug, Clone, Copy)]
pub(super) struct GrooveContact {
    /// Number of the ball, from 0, through all rows.
    pub ball: usize,
    /// 0 at the inner ring, 1 at the outer one.
    pub ring: usize,
    /// Angle of the contact.
    pub angle_rad: f64,
    /// Semi-axis of the ellipse across the direction of rolling, over the radius of the ball.
    pub reach_rad: f64,
}

const RINGS: [&str; 2] = ["inner", "outer"];

/// Refuses a contact point beyond the shoulder.
pub(super) fn check(bearing: &Bearing, contacts: &[GrooveContact]) -> Result<(), EquilibriumError> {
    let shoulders = bearing.shoulder_angles_rad();
    let beyond = |c: &&GrooveContact| c.angle_rad.abs() > shoulders[c.ring];
    contacts.iter().find(beyond).map_or(Ok(()), |c| {
        Err(EquilibriumError::BeyondGroove {
            ball: c.ball,
            ring: RINGS[c.ring],
            angle_rad: c.angle_rad,
            shoulder_rad: shoulders[c.ring],
        })
    })
}

/// A sentence for each ring whose shoulder cuts an ellipse off, |α| + a/Rw beyond the groove.
pub(super) fn truncated(bearing: &Bearing, contacts: &[GrooveContact]) -> Vec<String> {
    let shoulders = bearing.shoulder_angles_rad();
    let reach = |c: &GrooveContact| c.angle_rad.abs() + c.reach_rad;
    let of_ring = |ring: usize| {
        let here = contacts.iter().filter(|c| c.ring == ring);
        let worst = here.max_by(|a, b| reach(a).total_cmp(&reach(b)))?;
        (reach(worst) > shoulders[ring]).then(|| {
            format!(
                "the shoulder of the {} ring cuts off the contact ellipse of ball {}: it reaches to \
                 {:.1}°, the groove to {:.1}°; pressures and lives leave that out",
                RINGS[ring],
                worst.ball + 1,
                degrees(reach(worst)),
                degrees(shoulders[ring])
            )
        })
    };
    (0..2).filter_map(of_ring).collect()
}
