//! The discrete raceway: contact path, effective contact radius, groove curve and
//! surface (Zhao 2022, Eq. (4) to (9)).
//!
//! In Eq. (4) to (8) the paper's Rm stands for Ro − Rw
//! ([`Bearing::outer_orbit_radius_m`]), so that the path ends on the plain raceway
//! at any clearance. Local coordinates have the middle of the raceway at −Y.
//!
//! ```
//! # mod common { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/common/mod.rs")); }
//! use cageless::{Raceway, RacewayDimensions};
//!
//! # use cageless::Bearing;
//! let bearing = Bearing::new(common::dimensions(), common::steel())?; // Zhao 2022, Table 1
//!
//! let dimensions = RacewayDimensions {
//!     axial_span_m: 5.1e-3,
//!     half_angle_rad: 25.2_f64.to_radians(),
//!     centre_angle_rad: 0.0,
//! };
//! let raceway = Raceway::new(dimensions, &bearing)?;
//! // The effective contact radius is smallest in the middle: balls are slowest there.
//! assert!(raceway.effective_radius_m(0.0) < bearing.ball_radius_m());
//! # Ok::<(), cageless::InputError>(())
//! ```

mod contact_path;
mod groove_surface;

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::bearing::Bearing;
use crate::error::{Allowed, InputError};
use crate::limits::positive;
use crate::numerics::chebyshev::Polynomial;

pub use groove_surface::SurfacePoint;
pub(crate) use groove_surface::{groove_centre, surface_point};

/// The three numbers that define a discrete raceway.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RacewayDimensions {
    /// lC, largest axial distance between the two contact points.
    pub axial_span_m: f64,
    /// θ, half the angle that the raceway takes up.
    pub half_angle_rad: f64,
    /// ψ of the raceway centre, rad.
    pub centre_angle_rad: f64,
}

/// A discrete raceway in the outer ring of a given bearing.
#[derive(Debug, Clone, PartialEq)]
pub struct Raceway {
    dimensions: RacewayDimensions,
    /// Rw.
    ball_radius_m: f64,
    /// Ro.
    groove_bottom_radius_m: f64,
    /// Re.
    groove_curvature_radius_m: f64,
    /// a, b, c of Zhao 2022, Eq. (5): m⁻³, m⁻¹, m.
    path: [f64; 3],
    /// r over sin²ψ.
    radius_polynomial: Polynomial,
    /// 1/√(1 + y′² + z′²) over sin²ψ.
    direction_polynomial: Polynomial,
    /// Depth error at the centre, m.
    depth_error_m: f64,
    /// αg by which the section is turned about the centre of the ball, rad.
    section_angle_rad: f64,
}

/// Fraction of the way to an end of the path up to which slopes follow from r; closer to it r r′/z
/// and r′/sin α are mostly rounding.
const NEAR_END: f64 = 1.0 - 1e-4;
/// Error of r(sin²ψ), m: a few roundings of Ro.
const RADIUS_TOLERANCE_M: f64 = 1e-17;
/// Error of the direction factor.
const DIRECTION_TOLERANCE: f64 = 1e-13;

impl Raceway {
    /// Lays the contact path (Zhao 2022, Eq. (4), (5)) and checks that the ring can
    /// carry it.
    ///
    /// # Errors
    /// An [`InputError`] if the span violates Eq. (8), the path leaves the plain
    /// raceway outwards (Eq. (9)), or an angle is out of range.
    pub fn new(dimensions: RacewayDimensions, bearing: &Bearing) -> Result<Self, InputError> {
        let RacewayDimensions {
            axial_span_m: span,
            half_angle_rad: theta,
            centre_angle_rad,
        } = dimensions;
        positive("axial_span_m", span)?;
        positive("half_angle_rad", theta)?;
        if theta >= FRAC_PI_2 {
            return Err(InputError::new(
                "half_angle_rad",
                theta,
                Allowed::Below(FRAC_PI_2, ""),
            ));
        }
        if !(centre_angle_rad.abs() <= TAU) {
            return Err(InputError::new(
                "centre_angle_rad",
                centre_angle_rad,
                Allowed::Between(-TAU, TAU, ""),
            ));
        }
        let limit = axial_span_limit_m(bearing);
        if span >= limit {
            return Err(InputError::new(
                "axial_span_m",
                span,
                Allowed::Below(
                    limit,
                    "the contact points must stay on the groove, Zhao 2022, Eq. (8)",
                ),
            ));
        }
        let d = bearing.dimensions();
        let mut raceway = Self {
            dimensions,
            ball_radius_m: d.ball_radius_m,
            groove_bottom_radius_m: d.outer_groove_bottom_radius_m,
            groove_curvature_radius_m: d.outer_groove_curvature_radius_m,
            path: path_coefficients(bearing, span, theta),
            radius_polynomial: Polynomial::fit(|_| 0.0, 0.0, 1.0, 0.0),
            direction_polynomial: Polynomial::fit(|_| 0.0, 0.0, 1.0, 0.0),
            depth_error_m: 0.0,
            section_angle_rad: 0.0,
        };
        raceway.check_path()?;
        let end = theta.sin().powi(2);
        raceway.radius_polynomial = Polynomial::fit(
            |s| raceway.radius_by_root(s.sqrt().asin()),
            0.0,
            end,
            RADIUS_TOLERANCE_M,
        );
        raceway.direction_polynomial = Polynomial::fit(
            |s| {
                let x = raceway.path_x_m(s.sqrt().asin());
                let (dy, dz) = (raceway.path_slope(x), raceway.path_axial_slope(x));
                1.0 / (1.0 + dy * dy + dz * dz).sqrt()
            },
            0.0,
            end,
            DIRECTION_TOLERANCE,
        );
        Ok(raceway)
    }

    /// Zhao 2022, Eq. (9), r ≤ Rw, all along the path.
    fn check_path(&self) -> Result<(), InputError> {
        let theta = self.dimensions.half_angle_rad;
        let end = self.path_end_m();
        let (a, b) = (self.path[0], self.path[1]);
        let places = (0..1000).map(|k| f64::from(k) / 1000.0);
        for place in places.chain([NEAR_END]) {
            let x = end * place;
            let rho = x.hypot(self.path_y_m(x));
            // Going along the path, ψ and r must both grow from the middle to the end.
            let turning = -self.path_y_m(x) + x * x * (4.0 * a * x * x + 2.0 * b);
            let rising = x == 0.0 || x + self.path_y_m(x) * self.path_slope(x) > 0.0;
            let within = rho < self.groove_bottom_radius_m && self.end_curvature_per_m() > 0.0;
            if !within || turning <= 0.0 || !rising {
                return Err(InputError::rule(
                    "half_angle_rad",
                    theta,
                    format!(
                        "an angle at which the contact path rises steadily to the plain raceway \
                         (Zhao 2022, Eq. (9)): for axial_span_m = {} it turns back or leaves the \
                         groove",
                        self.dimensions.axial_span_m
                    ),
                ));
            }
        }
        Ok(())
    }

    /// Raceway with the depth error `depth_error_m` at its centre (positive: too deep; negative: not deep
    /// enough), measured along the normal of its flanks. The error runs out to nothing at the
    /// ends, as E (1 − sin²ψ/sin²θ)².
    ///
    /// # Errors
    /// An [`InputError`] beyond a tenth of Re − Rw: the ball would touch elsewhere.
    pub fn with_depth_error(mut self, depth_error_m: f64) -> Result<Self, InputError> {
        let most = self.depth_error_max_m();
        if !(depth_error_m.abs() <= most) {
            return Err(InputError::new(
                "depth_error_m",
                depth_error_m,
                Allowed::Between(
                    -most,
                    most,
                    "a tenth of what the groove's curvature radius exceeds the ball's",
                ),
            ));
        }
        self.depth_error_m = depth_error_m;
        Ok(self)
    }

    /// Largest depth error that [`Self::with_depth_error`] takes, either way.
    pub fn depth_error_max_m(&self) -> f64 {
        0.1 * (self.groove_curvature_radius_m - self.ball_radius_m)
    }

    /// Depth error at the centre, m.
    pub fn depth_error_m(&self) -> f64 {
        self.depth_error_m
    }

    /// Depth error at ψ, m.
    pub fn depth_error_at_m(&self, angle_rad: f64) -> f64 {
        let (local, end) = (self.local_angle_rad(angle_rad), self.half_angle_rad());
        if local.abs() < end {
            self.depth_error_m * (1.0 - (local.sin() / end.sin()).powi(2)).powi(2)
        } else {
            0.0
        }
    }

    /// Raceway whose section is turned about the centre of the ball by αg towards +Z, as a bearing
    /// of that contact angle needs it.
    ///
    /// # Errors
    /// An [`InputError`] if a flank reaches beyond the shoulder of the outer ring.
    pub fn with_section_angle(
        mut self,
        angle_rad: f64,
        bearing: &Bearing,
    ) -> Result<Self, InputError> {
        let [_, shoulder] = bearing.shoulder_angles_rad();
        let most = shoulder - self.contact_angle_rad(0.0)[0];
        if angle_rad != 0.0 && !(angle_rad.abs() < most) {
            let why = "with a larger one a flank of the raceway reaches beyond the shoulder";
            let allowed = Allowed::Between(-most, most, why);
            return Err(InputError::new(
                "raceway_contact_angle_rad",
                angle_rad,
                allowed,
            ));
        }
        self.section_angle_rad = angle_rad;
        Ok(self)
    }

    /// αg by which the section is turned about the centre of the ball, rad.
    pub fn section_angle_rad(&self) -> f64 {
        self.section_angle_rad
    }

    /// lC, θ and position.
    pub fn dimensions(&self) -> &RacewayDimensions {
        &self.dimensions
    }

    /// θ.
    pub fn half_angle_rad(&self) -> f64 {
        self.dimensions.half_angle_rad
    }

    /// Checks that the raceway was laid out for this bearing.
    pub(crate) fn fits(&self, bearing: &Bearing) -> Result<(), InputError> {
        let d = bearing.dimensions();
        let same = self.ball_radius_m == d.ball_radius_m
            && self.groove_bottom_radius_m == d.outer_groove_bottom_radius_m
            && self.groove_curvature_radius_m == d.outer_groove_curvature_radius_m;
        if same && self.dimensions.axial_span_m < axial_span_limit_m(bearing) {
            return Ok(());
        }
        Err(InputError::rule(
            "axial_span_m",
            self.dimensions.axial_span_m,
            "the span of a raceway laid out for this very bearing (Raceway::new)",
        ))
    }
}

/// Checks that no two raceways overlap.
pub(crate) fn apart(raceways: &[Raceway]) -> Result<(), InputError> {
    for (k, one) in raceways.iter().enumerate() {
        for other in &raceways[k + 1..] {
            let distance = one.local_angle_rad(other.dimensions.centre_angle_rad).abs();
            let least = one.half_angle_rad() + other.half_angle_rad();
            if distance < least {
                return Err(InputError::rule(
                    "centre_angle_rad",
                    other.dimensions.centre_angle_rad,
                    format!(
                        "at least {least} away from the middle of every other raceway, or they overlap"
                    ),
                ));
            }
        }
    }
    Ok(())
}

/// 2·√(Rw² − (Ros − Rm)²), which lC must stay below (Zhao 2022, Eq. (8)).
pub fn axial_span_limit_m(bearing: &Bearing) -> f64 {
    let rise = bearing.dimensions().outer_shoulder_radius_m - bearing.outer_orbit_radius_m();
    2.0 * (bearing.ball_radius_m().powi(2) - rise.max(0.0).powi(2))
        .max(0.0)
        .sqrt()
}

/// a, b, c of Zhao 2022, Eq. (5).
fn path_coefficients(bearing: &Bearing, span_m: f64, theta: f64) -> [f64; 3] {
    let ro = bearing.dimensions().outer_groove_bottom_radius_m;
    let rw = bearing.ball_radius_m();
    let (sin, cos) = theta.sin_cos();
    let c = -(bearing.outer_orbit_radius_m() + (rw * rw - span_m * span_m / 4.0).sqrt());
    let rise = ro * sin * theta.tan();
    let a = (rise + 2.0 * ro * cos + 2.0 * c) / (2.0 * ro.powi(4) * sin.powi(4));
    let b = -(4.0 * c + rise + 4.0 * ro * cos) / (2.0 * ro * ro * sin * sin);
    [a, b, c]
}
