//! Geometry of the outer contact on a discrete raceway.

use super::flank_section::FlankSection;
use super::{OuterGeometry, OuterRaceway};
use crate::ball::{Ball, PolarMotion};
use crate::numerics::lanes::lane_struct;

lane_struct! {
    /// Constants of one discrete raceway, or of a stretch of one.
    pub(crate) struct RacewayConstants per lane RacewayConstantsLanes {
        /// Sine of ψ of its middle.
        sin_centre,
        /// Cosine of ψ of its middle.
        cos_centre,
        /// sin²ψ from which on this stretch of it reaches.
        begin,
        /// sin²ψ up to which it reaches; −1 where there is no raceway.
        end,
        /// 1/sin²θ.
        inverse_end,
        /// u = scale·sin²ψ + shift, the variable of the polynomials.
        scale,
        /// See `scale`.
        shift,
        /// Depth milled too much in the middle, m.
        depth_error,
        /// How much deeper a ball in the middle sits than on the plain raceway, m.
        depth,
    }
}

lane_struct! {
    /// Angular position of a ball from the middle of a raceway.
    pub(crate) struct RacewayPosition per lane RacewayPositionLanes {
        /// Sine of the angle; [`OUTSIDE`] beyond the ends of the raceway.
        sine,
        /// Cosine of the angle.
        cosine,
        /// Variable of the polynomials.
        u,
    }
}

lane_struct! {
    /// Values of the polynomials of a raceway at one ball.
    pub(crate) struct RacewayValues per lane RacewayValuesLanes {
        /// r of the nominal ball, m.
        radius,
        /// dr/du, m.
        radius_slope,
        /// (2 cos αc)^(−2/3), a² of the ellipse of one flank over that of one contact that takes all.
        ellipse,
    }
}

/// [`RacewayPosition::sine`] of a ball that is not in the raceway.
pub(crate) const OUTSIDE: f64 = 2.0;

impl RacewayPosition {
    /// Position of a ball; the raceway covers |ψ| < θ (Zhao 2022, Eq. (6)), a stretch of it one of
    /// sin²ψ.
    #[inline(always)]
    pub(crate) fn new(raceway: &RacewayConstants, polar: &PolarMotion) -> Self {
        let sine = polar.ex * raceway.cos_centre + polar.ey * raceway.sin_centre;
        let cosine = polar.ex * raceway.sin_centre - polar.ey * raceway.cos_centre;
        let square = sine * sine;
        Self {
            sine: if cosine > 0.0 && square >= raceway.begin && square < raceway.end {
                sine
            } else {
                OUTSIDE
            },
            cosine,
            u: square * raceway.scale + raceway.shift,
        }
    }

    /// Whether the ball is in the raceway.
    #[inline(always)]
    pub(crate) fn inside(&self) -> bool {
        self.sine <= 1.0
    }
}

/// Geometry of a nominal ball: r of Zhao 2022, Eq. (6), on the discrete raceway, `plain`
/// elsewhere.
#[inline(always)]
pub(crate) fn nominal_geometry(
    position: &RacewayPosition,
    values: &RacewayValues,
    plain: OuterGeometry,
) -> OuterGeometry {
    OuterGeometry {
        effective_radius: if position.inside() {
            values.radius
        } else {
            plain.effective_radius
        },
        ..plain
    }
}

/// Flanks of a discrete raceway at one ball of any radius R, milled too deep by
/// e = E (1 − sin²ψ/sin²θ)², deeper by t likewise, and how they change with ψ.
#[derive(Debug, Clone, Copy)]
pub(crate) struct FlankShape {
    /// The flanks.
    pub section: FlankSection,
    /// dc/dψ of c = cos αc.
    pub cosine_slope: f64,
    /// de/dψ, m.
    pub error_slope: f64,
    /// t, how much deeper the ball sits than on the plain raceway, m.
    pub depth: f64,
    /// dt/dψ, m.
    pub depth_slope: f64,
    /// See [`RacewayValues::ellipse`].
    pub ellipse: f64,
}

impl FlankShape {
    /// Flanks at a place in a raceway.
    #[inline(always)]
    pub(crate) fn new(
        raceway: &RacewayConstants,
        outer: &OuterRaceway,
        ball: &Ball,
        position: &RacewayPosition,
        values: &RacewayValues,
    ) -> Self {
        let (sine, cosine) = (position.sine, position.cosine);
        let c = values.radius / outer.ball_radius;
        let left = 1.0 - sine * sine * raceway.inverse_end;
        let error = raceway.depth_error * left * left;
        let (f, g) = (
            outer.curvature_offset,
            outer.curvature + error - ball.radius,
        );
        // d(sin²ψ)/dψ, and u = scale sin²ψ + shift.
        let turning = 2.0 * sine * cosine;
        Self {
            section: FlankSection {
                gap: g,
                height: (g * g - f * f * (1.0 - c * c)).sqrt(),
                cosine: c,
            },
            cosine_slope: values.radius_slope * raceway.scale * turning / outer.ball_radius,
            error_slope: -2.0 * raceway.depth_error * left * raceway.inverse_end * turning,
            depth: raceway.depth * left * left,
            depth_slope: -2.0 * raceway.depth * left * raceway.inverse_end * turning,
            ellipse: values.ellipse,
        }
    }
}

/// Geometry of a ball of another radius R, or in a raceway milled too deep by e, see
/// [`crate::outer_contact_geometry`]. With f = Re − Rw, c = r/Rw and g = Re + e − R the ball's centre lies
/// h = √(g² − f²(1 − c²)) beyond Oe, so that |rb| = Ro − Rw + h − f c + t and r = R h/g, with
/// the slope d|rb|/dψ = (g e′ + f² c c′)/h − f c′ + t′ and e = E (1 − sin²ψ/sin²θ)², t likewise.
#[inline(always)]
pub(crate) fn unequal_geometry(
    raceway: &RacewayConstants,
    outer: &OuterRaceway,
    ball: &Ball,
    position: &RacewayPosition,
    values: &RacewayValues,
    plain: OuterGeometry,
) -> OuterGeometry {
    let shape = FlankShape::new(raceway, outer, ball, position, values);
    let (f, g) = (outer.curvature_offset, shape.section.gap);
    let (h, c, c_slope) = (
        shape.section.height,
        shape.section.cosine,
        shape.cosine_slope,
    );
    let inside = position.inside();
    let select = |new: f64, old: f64| if inside { new } else { old };
    OuterGeometry {
        orbit_radius: select(
            outer.orbit_radius + h - f * c + shape.depth,
            plain.orbit_radius,
        ),
        slope: select(
            (g * shape.error_slope + f * f * c * c_slope) / h - f * c_slope + shape.depth_slope,
            plain.slope,
        ),
        effective_radius: select(ball.radius * h / g, plain.effective_radius),
    }
}
