//! Outer contact of a ball that sits on both flanks of a discrete raceway.

use super::NormalForce;
use super::outer::{OuterContact, OuterGeometry, OuterRaceway, outer_deflection, outer_slip};
use super::outer_geometry::FlankShape;
use crate::ball::{Ball, BallMotion, PolarMotion};
use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// Contacts of one ball with both flanks, beside its [`OuterContact`].
    pub(crate) struct FlankContact per lane FlankContactLanes {
        /// δe, m; 0 apart.
        deflection,
        /// ∂δe/∂ρ.
        lever,
        /// sin² α.
        sine_square,
        /// Normal force of both flanks together, N.
        load,
        /// a², square of the semi-axis across the groove of the contact ellipse of a flank, m².
        axis_square,
    }
}

/// Outer contact of a ball on flanks of this shape, and its geometry: r, and as slope dρ/dψ of equal
/// δe. `geometry` has the place where it just touches.
///
/// With f = Re − Rw, c = cos αc and the depth error e
///
///   dρ/dψ = (e′ + δe c′)/cos α − f c′ (1 − f c/(h + u)).
///
/// The ellipse is that of the plain groove under the elastic part of N = F/(2 c),
/// a² = A δe/(2 c)^(2/3) with A the [`OuterRaceway::axis_square_per_m`].
#[inline(always)]
pub(crate) fn flank_contact(
    ball: &Ball,
    raceway: &OuterRaceway,
    shape: &FlankShape,
    geometry: &OuterGeometry,
    motion: &BallMotion,
    polar: &PolarMotion,
) -> (OuterGeometry, OuterContact, FlankContact) {
    let deflection = outer_deflection(polar.distance, geometry);
    let press = shape.section.press(deflection);
    let (f, c, c_slope) = (
        raceway.curvature_offset,
        shape.section.cosine,
        shape.cosine_slope,
    );
    let yielding = shape.error_slope + press.deflection * c_slope;
    let slope = yielding * press.inverse_cosine
        - f * c_slope * (1.0 - f * c * press.inverse_height)
        + shape.depth_slope;
    let geometry = OuterGeometry {
        effective_radius: ball.radius * press.cosine,
        slope,
        ..*geometry
    };
    let normal = NormalForce::at_raceway(
        ball.outer_stiffness_n_m1_5,
        ball.raceway_damping,
        press.deflection,
        press.lever * (polar.radial - slope * polar.orbit),
    );
    let outer = OuterContact {
        deflection,
        force: normal.force_n * press.lever,
        slip: outer_slip(&geometry, motion, polar),
        friction_normal: raceway.friction_factor * normal.force_n * press.inverse_flank_cosine,
        damping_power: normal.damping_power_w,
    };
    let flanks = FlankContact {
        deflection: press.deflection,
        lever: press.lever,
        sine_square: press.sine_square,
        load: normal.force_n * press.inverse_flank_cosine,
        axis_square: raceway.axis_square_per_m * press.deflection * shape.ellipse,
    };
    (geometry, outer, flanks)
}
