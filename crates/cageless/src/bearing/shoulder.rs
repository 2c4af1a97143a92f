//! Shoulders of the grooves, and contacts that reach them.

use super::Bearing;
use crate::error::degrees;

/// Names of the rings in the order in which pairs of them come.
const RINGS: [&str; 2] = ["inner", "outer"];

/// A contact beyond the end of its groove.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
#[error(
    "ball {} over the shoulder of the {} ring: its contact angle is {:.1}°, the groove ends at \
     {:.1}°",
    self.ball + 1, RINGS[self.ring], degrees(self.angle_rad), degrees(self.shoulder_rad)
)]
pub(crate) struct BeyondGroove {
    /// The ball, from 0, through all rows.
    pub ball: usize,
    /// The ring: 0 for the inner, 1 for the outer one.
    pub ring: usize,
    /// Contact angle of the ball, rad.
    pub angle_rad: f64,
    /// The contact angle at which the groove ends.
    pub shoulder_rad: f64,
}

impl Bearing {
    /// Contact angles at the shoulders of inner and outer ring.
    pub fn shoulder_angles_rad(&self) -> [f64; 2] {
        let d = &self.dimensions;
        let (ri, re) = (
            d.inner_groove_curvature_radius_m,
            d.outer_groove_curvature_radius_m,
        );
        let inner_height = d.inner_shoulder_height_m();
        let outer_height = d.outer_groove_bottom_radius_m - d.outer_shoulder_radius_m;
        [(inner_height, ri), (outer_height, re)]
            .map(|(height, radius)| (1.0 - height / radius).clamp(0.0, 1.0).acos())
    }

    /// A contact at this angle of ball `ball` with a ring, if it is beyond the shoulder.
    pub(crate) fn beyond_groove(
        &self,
        ball: usize,
        ring: usize,
        angle_rad: f64,
    ) -> Option<BeyondGroove> {
        let shoulder_rad = self.shoulder_angles_rad()[ring];
        (angle_rad.abs() > shoulder_rad).then_some(BeyondGroove {
            ball,
            ring,
            angle_rad,
            shoulder_rad,
        })
    }

    /// [`Self::truncation_warning`] of inner and outer ring.
    pub fn truncation_warnings(&self, edges_rad: [f64; 2]) -> impl Iterator<Item = String> {
        let edges_rad = edges_rad.into_iter().enumerate();
        edges_rad.filter_map(|(ring, edge_rad)| self.truncation_warning(ring, edge_rad))
    }

    /// Warning if contact ellipses that reach to this |α| + a/Rw are cut off by the shoulder of a
    /// ring: 0 for the inner, 1 for the outer one.
    pub fn truncation_warning(&self, ring: usize, edge_rad: f64) -> Option<String> {
        let shoulder_rad = self.shoulder_angles_rad()[ring];
        (edge_rad > shoulder_rad).then(|| {
            format!(
                "the shoulder of the {} ring cuts off contact ellipses: they reach to {:.1}°, the \
                 groove to {:.1}°; pressures and lives leave that out",
                RINGS[ring],
                degrees(edge_rad),
                degrees(shoulder_rad)
            )
        })
    }
}
