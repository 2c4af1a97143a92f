//! Contact path of Zhao 2022, Eq. (4) to (6), quartic in x.

use crate::bearing::Bearing;
use crate::error::InputError;
use crate::numerics::chebyshev::Polynomial;
use crate::numerics::root;

/// Contact path y = a x⁴ + b x² + c of a raceway in local coordinates, with its middle at −Y.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct ContactPath {
    /// lC, m.
    axial_span_m: f64,
    /// θ.
    half_angle_rad: f64,
    /// Rw.
    ball_radius_m: f64,
    /// Ro.
    groove_bottom_radius_m: f64,
    /// Re.
    groove_curvature_radius_m: f64,
    /// a, b, c of Zhao 2022, Eq. (5): m⁻³, m⁻¹, m.
    coefficients: [f64; 3],
}

/// Fraction of the way to an end of the path up to which slopes follow from r; closer to it r r′/z
/// and r′/sin α are mostly rounding.
const NEAR_END: f64 = 1.0 - 1e-4;
/// Error of the direction factor.
const DIRECTION_TOLERANCE: f64 = 1e-13;

impl ContactPath {
    /// Lays the path (Zhao 2022, Eq. (5)) and checks that it stays within the groove.
    ///
    /// # Errors
    /// An [`InputError`] if the path leaves the plain raceway outwards (Eq. (9)).
    pub(super) fn new(
        axial_span_m: f64,
        half_angle_rad: f64,
        bearing: &Bearing,
    ) -> Result<Self, InputError> {
        let d = bearing.dimensions();
        let path = Self {
            axial_span_m,
            half_angle_rad,
            ball_radius_m: d.ball_radius_m,
            groove_bottom_radius_m: d.outer_groove_bottom_radius_m,
            groove_curvature_radius_m: d.outer_groove_curvature_radius_m,
            coefficients: coefficients(bearing, axial_span_m, half_angle_rad),
        };
        path.check()?;
        Ok(path)
    }

    /// Zhao 2022, Eq. (9), r ≤ Rw, all along the path.
    fn check(&self) -> Result<(), InputError> {
        let theta = self.half_angle_rad;
        let end = self.end_m();
        let (a, b) = (self.coefficients[0], self.coefficients[1]);
        let places = (0..1000).map(|k| f64::from(k) / 1000.0);
        for place in places.chain([NEAR_END]) {
            let x = end * place;
            let rho = x.hypot(self.y_m(x));
            // Going along the path, ψ and r must both grow from the middle to the end.
            let turning = -self.y_m(x) + x * x * (4.0 * a * x * x + 2.0 * b);
            let rising = x == 0.0 || x + self.y_m(x) * self.slope(x) > 0.0;
            let within = rho < self.groove_bottom_radius_m && self.end_curvature_per_m() > 0.0;
            if !within || turning <= 0.0 || !rising {
                let rule = format!(
                    "an angle at which the contact path rises steadily to the plain raceway \
                     (Zhao 2022, Eq. (9)): for axial_span_m = {} it turns back or leaves the groove",
                    self.axial_span_m
                );
                return Err(InputError::rule("half_angle_rad", theta, rule));
            }
        }
        Ok(())
    }

    /// Centre of groove curvature Oe at path abscissa x, branch z > 0 of the contact
    /// point (Zhao 2022, Eq. (7)), in local coordinates.
    #[cfg(test)]
    pub(crate) fn groove_centre_m(&self, x_m: f64) -> [f64; 3] {
        let (rw, re) = (self.ball_radius_m, self.groove_curvature_radius_m);
        let y = self.y_m(x_m);
        let rho = x_m.hypot(y);
        let s = ((rw - re) * rho + self.outer_orbit_radius_m() * re) / (rw * rho);
        [x_m * s, y * s, self.z_m(x_m) * (rw - re) / rw]
    }

    /// a (m⁻³), b (m⁻¹) and c (m) of Zhao 2022, Eq. (5).
    pub(crate) fn coefficients(&self) -> [f64; 3] {
        self.coefficients
    }

    /// Ro sin θ, where the path meets the plain raceway.
    pub(crate) fn end_m(&self) -> f64 {
        self.groove_bottom_radius_m * self.half_angle_rad.sin()
    }

    /// y = a x⁴ + b x² + c (Zhao 2022, Eq. (4)).
    pub(crate) fn y_m(&self, x_m: f64) -> f64 {
        let [a, b, c] = self.coefficients;
        let x2 = x_m * x_m;
        (a * x2 + b) * x2 + c
    }

    /// dy/dx of the path.
    pub(crate) fn slope(&self, x_m: f64) -> f64 {
        let [a, b, _] = self.coefficients;
        x_m * (4.0 * a * x_m * x_m + 2.0 * b)
    }

    /// z ≥ 0 of the path (Zhao 2022, Eq. (4)); the other branch is its mirror image.
    pub(crate) fn z_m(&self, x_m: f64) -> f64 {
        let r = self.effective_radius_at_x_m(x_m);
        (self.ball_radius_m.powi(2) - r * r).max(0.0).sqrt()
    }

    /// dz/dx of the branch z > 0: z′ = −r r′/z. At the ends, where r = Rw and
    /// r′ = 0, the limit from within.
    pub(crate) fn axial_slope(&self, x_m: f64) -> f64 {
        let near = self.end_m() * NEAR_END;
        // The slope itself is smooth.
        let x = x_m.clamp(-near, near);
        let y = self.y_m(x);
        let rho = x.hypot(y);
        let slope = (x + y * self.slope(x)) / rho;
        -self.effective_radius_at_x_m(x) * slope / self.z_m(x)
    }

    /// r at the point of the path with abscissa x (Zhao 2022, Eq. (6)).
    pub(crate) fn effective_radius_at_x_m(&self, x_m: f64) -> f64 {
        if x_m.abs() < self.end_m() {
            x_m.hypot(self.y_m(x_m)) - self.outer_orbit_radius_m()
        } else {
            self.ball_radius_m
        }
    }

    /// Abscissa of the contact point of a ball at local ψ: tan ψ = x/(−y).
    pub(crate) fn x_m(&self, local_angle_rad: f64) -> f64 {
        let (sin, cos) = local_angle_rad.abs().sin_cos();
        let x = root::brent(
            |x| x * cos + self.y_m(x) * sin,
            0.0,
            self.end_m() * (1.0 + 1e-12),
            0.0,
        );
        x.unwrap_or_else(|| self.end_m()).copysign(local_angle_rad)
    }

    pub(super) fn radius_by_root(&self, local_angle_rad: f64) -> f64 {
        let x = self.x_m(local_angle_rad);
        x.hypot(self.y_m(x)) - self.outer_orbit_radius_m()
    }

    /// α, the contact angle at local ψ within ±θ (cos α = r/Rw, from the radial direction,
    /// branch z > 0), and dα/dψ. At the ends the slope is the limit from within; it is not
    /// 0 there, which is the kink.
    pub(crate) fn contact_angle_rad(&self, local_angle_rad: f64) -> [f64; 2] {
        let theta = self.half_angle_rad;
        let local = local_angle_rad.abs().min(theta);
        // Beyond, α goes by its slope.
        let near = theta * NEAR_END;
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
        let x = self.x_m(local_angle_rad);
        let (y, slope) = (self.y_m(x), self.slope(x));
        let rho = x.hypot(y);
        let z = self.z_m(x);
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

    /// −d²r/dx² at the end X of the path, where r = Rw and r′ = 0: the path reaches the plain raceway
    /// from below where it is above 0.
    pub(super) fn end_curvature_per_m(&self) -> f64 {
        let [a, b, _] = self.coefficients;
        let x = self.end_m();
        let (y, slope) = (self.y_m(x), self.slope(x));
        let bend = 12.0 * a * x * x + 2.0 * b;
        -(1.0 + slope * slope + y * bend) / self.groove_bottom_radius_m
    }

    /// dα/dψ at +θ: r ≈ Rw − κ/2 (X − x)², so that α ≈ √(κ/Rw) (X − x).
    fn contact_angle_end_slope(&self) -> f64 {
        let x = self.end_m();
        let (y, slope) = (self.y_m(x), self.slope(x));
        let turning = (x * slope - y) / self.groove_bottom_radius_m.powi(2);
        -(self.end_curvature_per_m() / self.ball_radius_m).sqrt() / turning
    }

    /// 1/√(1 + y′² + z′²) as a polynomial in sin²ψ.
    pub(crate) fn direction_polynomial(&self) -> Polynomial {
        let direction = |s: f64| {
            let x = self.x_m(s.sqrt().asin());
            let (dy, dz) = (self.slope(x), self.axial_slope(x));
            1.0 / (1.0 + dy * dy + dz * dz).sqrt()
        };
        let end = self.half_angle_rad.sin().powi(2);
        Polynomial::fit(direction, 0.0, end, DIRECTION_TOLERANCE)
    }

    fn outer_orbit_radius_m(&self) -> f64 {
        self.groove_bottom_radius_m - self.ball_radius_m
    }
}

/// a, b, c of Zhao 2022, Eq. (5).
fn coefficients(bearing: &Bearing, span_m: f64, theta: f64) -> [f64; 3] {
    let ro = bearing.dimensions().outer_groove_bottom_radius_m;
    let rw = bearing.ball_radius_m();
    let (sin, cos) = theta.sin_cos();
    let c = -(bearing.outer_orbit_radius_m() + (rw * rw - span_m * span_m / 4.0).sqrt());
    let rise = ro * sin * theta.tan();
    let a = (rise + 2.0 * ro * cos + 2.0 * c) / (2.0 * ro.powi(4) * sin.powi(4));
    let b = -(4.0 * c + rise + 4.0 * ro * cos) / (2.0 * ro * ro * sin * sin);
    [a, b, c]
}
