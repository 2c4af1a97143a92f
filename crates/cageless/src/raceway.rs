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

use std::f64::consts::{FRAC_PI_2, TAU};

use crate::bearing::Bearing;
use crate::error::{Allowed, InputError, positive};
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::chebyshev::Polynomial;
use crate::numerics::root;

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
}

/// A point of the raceway surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SurfacePoint {
    /// Position in the frame of the bearing.
    pub position_m: [f64; 3],
    /// Unit normal, out of the ring's material.
    pub normal: [f64; 3],
}

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
        for k in 0..1000 {
            let x = end * f64::from(k) / 1000.0;
            let rho = x.hypot(self.path_y_m(x));
            // Going along the path, ψ and r must both grow from the middle to the end.
            let turning = -self.path_y_m(x) + x * x * (4.0 * a * x * x + 2.0 * b);
            let rising = x == 0.0 || x + self.path_y_m(x) * self.path_slope(x) > 0.0;
            if rho >= self.groove_bottom_radius_m || turning <= 0.0 || !rising {
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

    /// lC, θ and position.
    pub fn dimensions(&self) -> &RacewayDimensions {
        &self.dimensions
    }

    /// θ.
    pub fn half_angle_rad(&self) -> f64 {
        self.dimensions.half_angle_rad
    }

    /// a (m⁻³), b (m⁻¹) and c (m) of Zhao 2022, Eq. (5).
    pub fn path_coefficients(&self) -> [f64; 3] {
        self.path
    }

    /// Ro sin θ, where the path meets the plain raceway.
    pub fn path_end_m(&self) -> f64 {
        self.groove_bottom_radius_m * self.dimensions.half_angle_rad.sin()
    }

    /// y = a x⁴ + b x² + c (Zhao 2022, Eq. (4)).
    pub fn path_y_m(&self, x_m: f64) -> f64 {
        let [a, b, c] = self.path;
        let x2 = x_m * x_m;
        (a * x2 + b) * x2 + c
    }

    /// dy/dx of the path.
    pub fn path_slope(&self, x_m: f64) -> f64 {
        let [a, b, _] = self.path;
        x_m * (4.0 * a * x_m * x_m + 2.0 * b)
    }

    /// z ≥ 0 of the path (Zhao 2022, Eq. (4)); the other branch is its mirror image.
    pub fn path_z_m(&self, x_m: f64) -> f64 {
        let r = self.effective_radius_at_x_m(x_m);
        (self.ball_radius_m.powi(2) - r * r).max(0.0).sqrt()
    }

    /// dz/dx of the branch z > 0: z′ = −r r′/z. At the ends, where r = Rw and
    /// r′ = 0, the limit from within.
    pub fn path_axial_slope(&self, x_m: f64) -> f64 {
        let end = self.path_end_m();
        // Closer than this to an end, r r′/z is mostly rounding; the slope itself is smooth.
        let x = x_m.clamp(-end * (1.0 - 1e-4), end * (1.0 - 1e-4));
        let y = self.path_y_m(x);
        let rho = x.hypot(y);
        let slope = (x + y * self.path_slope(x)) / rho;
        -self.effective_radius_at_x_m(x) * slope / self.path_z_m(x)
    }

    /// r at the point of the path with abscissa x (Zhao 2022, Eq. (6)).
    pub fn effective_radius_at_x_m(&self, x_m: f64) -> f64 {
        if x_m.abs() < self.path_end_m() {
            x_m.hypot(self.path_y_m(x_m)) - self.outer_orbit_radius_m()
        } else {
            self.ball_radius_m
        }
    }

    fn outer_orbit_radius_m(&self) -> f64 {
        self.groove_bottom_radius_m - self.ball_radius_m
    }

    /// ψ from the middle of the raceway, wrapped to [−π, π].
    pub fn local_angle_rad(&self, angle_rad: f64) -> f64 {
        wrap_angle_rad(angle_rad - self.dimensions.centre_angle_rad)
    }

    /// Whether a ball at ψ is inside the raceway.
    pub fn contains(&self, angle_rad: f64) -> bool {
        self.local_angle_rad(angle_rad).abs() < self.dimensions.half_angle_rad
    }

    /// r of a ball at ψ; Rw outside the raceway.
    pub fn effective_radius_m(&self, angle_rad: f64) -> f64 {
        let local = self.local_angle_rad(angle_rad);
        if local.abs() < self.dimensions.half_angle_rad {
            self.radius_polynomial.value(local.sin().powi(2))
        } else {
            self.ball_radius_m
        }
    }

    /// Abscissa of the contact point of a ball at local ψ: tan ψ = x/(−y).
    pub fn path_x_m(&self, local_angle_rad: f64) -> f64 {
        let (sin, cos) = local_angle_rad.abs().sin_cos();
        let x = root::brent(
            |x| x * cos + self.path_y_m(x) * sin,
            0.0,
            self.path_end_m() * (1.0 + 1e-12),
            0.0,
        );
        x.unwrap_or_else(|| self.path_end_m())
            .copysign(local_angle_rad)
    }

    fn radius_by_root(&self, local_angle_rad: f64) -> f64 {
        let x = self.path_x_m(local_angle_rad);
        x.hypot(self.path_y_m(x)) - self.outer_orbit_radius_m()
    }

    /// r as a polynomial in sin²ψ.
    pub(crate) fn radius_polynomial(&self) -> &Polynomial {
        &self.radius_polynomial
    }

    /// 1/√(1 + y′² + z′²) as a polynomial in sin²ψ.
    pub(crate) fn direction_polynomial(&self) -> &Polynomial {
        &self.direction_polynomial
    }

    /// α, the contact angle at local ψ within ±θ (cos α = r/Rw, from the radial direction,
    /// branch z > 0), and dα/dψ. At the ends the slope is the limit from within; it is not
    /// 0 there, which is the kink.
    pub fn contact_angle_rad(&self, local_angle_rad: f64) -> [f64; 2] {
        let theta = self.dimensions.half_angle_rad;
        let local = local_angle_rad.abs().min(theta);
        // Closer than this to an end, r'/sin α is mostly rounding, and α goes by its slope.
        let near = theta * (1.0 - 1e-4);
        let end = self.contact_angle_end_slope();
        let [angle, slope] = if local <= near {
            self.contact_angle_within(local)
        } else {
            let [_, inner] = self.contact_angle_within(near);
            let fraction = (local - near) / (theta - near);
            let slope = inner + fraction * (end - inner);
            // The slope is linear from here to the end, where α is 0.
            [(slope + end) / 2.0 * (local - theta), slope]
        };
        [angle, slope * local_angle_rad.signum()]
    }

    fn contact_angle_within(&self, local_angle_rad: f64) -> [f64; 2] {
        let x = self.path_x_m(local_angle_rad);
        let (y, slope) = (self.path_y_m(x), self.path_slope(x));
        let rho = x.hypot(y);
        let z = self.path_z_m(x);
        // dψ/dx of tan ψ = −x/y; −sin α dα = dr/Rw.
        let turning = (x * slope - y) / (rho * rho);
        let rise = (x + y * slope) / rho;
        let angle = z.atan2(rho - self.outer_orbit_radius_m());
        let slope = if rise == 0.0 {
            0.0
        } else {
            -rise / z / turning
        };
        [angle, slope]
    }

    /// dα/dψ at +θ: r ≈ Rw − κ/2 (X − x)², so that α ≈ √(κ/Rw) (X − x).
    fn contact_angle_end_slope(&self) -> f64 {
        let [a, b, _] = self.path;
        let x = self.path_end_m();
        let (y, slope) = (self.path_y_m(x), self.path_slope(x));
        let bend = 12.0 * a * x * x + 2.0 * b;
        let curvature = -(1.0 + slope * slope + y * bend) / self.groove_bottom_radius_m;
        let turning = (x * slope - y) / self.groove_bottom_radius_m.powi(2);
        -(curvature.max(0.0) / self.ball_radius_m).sqrt() / turning
    }

    /// Centre of groove curvature Oe at path abscissa x, branch z > 0 of the contact
    /// point (Zhao 2022, Eq. (7)), in local coordinates.
    pub fn groove_centre_m(&self, x_m: f64) -> [f64; 3] {
        let (rw, re) = (self.ball_radius_m, self.groove_curvature_radius_m);
        let y = self.path_y_m(x_m);
        let rho = x_m.hypot(y);
        let s = ((rw - re) * rho + self.outer_orbit_radius_m() * re) / (rw * rho);
        [x_m * s, y * s, self.path_z_m(x_m) * (rw - re) / rw]
    }

    /// Distance of Oe from the bearing axis, its z, and the derivatives of both with
    /// respect to ψ, at local ψ (branch z > 0).
    fn groove_curve(&self, local_angle_rad: f64) -> [f64; 4] {
        let offset = self.groove_curvature_radius_m - self.ball_radius_m;
        let contact = if local_angle_rad.abs() < self.dimensions.half_angle_rad {
            self.contact_angle_rad(local_angle_rad)
        } else {
            [0.0; 2]
        };
        groove_centre(self.outer_orbit_radius_m(), offset, contact)
    }

    /// Point of the raceway surface at ψ and meridian angle η, the angle at Oe between
    /// the outward radius and the point. η ≥ 0 lies on the side z ≥ 0, η < 0 on its
    /// mirror image. From the range of
    /// [`Self::meridian_range_rad`] upwards the surface is that of the groove; nearer to
    /// η = 0 the circle goes on beyond the plane z = 0.
    pub fn surface(&self, angle_rad: f64, meridian_rad: f64) -> SurfacePoint {
        let local = self.local_angle_rad(angle_rad);
        surface_point(
            self.groove_curve(local),
            self.groove_curvature_radius_m,
            angle_rad,
            meridian_rad,
        )
    }

    /// Range of |η| on one side at ψ: from the plane z = 0 to the shoulder.
    pub fn meridian_range_rad(&self, angle_rad: f64, bearing: &Bearing) -> [f64; 2] {
        let [radial, axial, ..] = self.groove_curve(self.local_angle_rad(angle_rad));
        let re = self.groove_curvature_radius_m;
        let shoulder = bearing.dimensions().outer_shoulder_radius_m;
        [
            (-axial / re).asin(),
            ((shoulder - radial) / re).clamp(-1.0, 1.0).acos(),
        ]
    }

    /// Angle between the normals of the discrete and the plain raceway where they
    /// meet, at meridian angle η. It is not zero because z′ is not.
    pub fn kink_angle_rad(&self, meridian_rad: f64) -> f64 {
        let end = self.dimensions.half_angle_rad;
        let re = self.groove_curvature_radius_m;
        let within = self.groove_curve(end * (1.0 - 1e-9));
        let plain = [self.groove_bottom_radius_m - re, 0.0, 0.0, 0.0];
        let n1 = surface_point(within, re, end, meridian_rad).normal;
        let n2 = surface_point(plain, re, end, meridian_rad).normal;
        let cross = cross(n1, n2);
        dot(cross, cross).sqrt().asin()
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

/// Eq. (7) in terms of α: Oe is Re − Rw behind the ball's centre on the line through the
/// contact point. Its distance from the axis, its z, and the derivatives of both with
/// respect to ψ, from α and dα/dψ.
pub(crate) fn groove_centre(
    touching_m: f64,
    offset_m: f64,
    [contact, slope]: [f64; 2],
) -> [f64; 4] {
    let (sin, cos) = contact.sin_cos();
    [
        touching_m - offset_m * cos,
        -offset_m * sin,
        offset_m * sin * slope,
        -offset_m * cos * slope,
    ]
}

pub(crate) fn surface_point(curve: [f64; 4], re: f64, angle: f64, meridian: f64) -> SurfacePoint {
    let [radial, axial, radial_slope, axial_slope] = curve;
    let side = if meridian < 0.0 { -1.0 } else { 1.0 };
    let (sin_m, cos_m) = meridian.abs().sin_cos();
    let (sin, cos) = angle.sin_cos();
    let (e, t) = ([sin, -cos], [cos, sin]);
    let rho = radial + re * cos_m;
    let z = axial + re * sin_m;
    // ∂S/∂ψ = ρ t + ρe′ e + ze′ k and ∂S/∂η = Re(−sin η e + cos η k); their cross
    // product, turned towards the axis, is normal to the surface.
    let along = [
        rho * t[0] + radial_slope * e[0],
        rho * t[1] + radial_slope * e[1],
        axial_slope,
    ];
    let across = [-sin_m * e[0], -sin_m * e[1], cos_m];
    let mut n = cross(across, along);
    let length = dot(n, n).sqrt();
    n = n.map(|c| c / length);
    if n[0] * e[0] + n[1] * e[1] > 0.0 {
        n = n.map(|c| -c);
    }
    SurfacePoint {
        position_m: [rho * e[0], rho * e[1], side * z],
        normal: [n[0], n[1], side * n[2]],
    }
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
