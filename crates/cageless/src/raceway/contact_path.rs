//! Contact path of a discrete raceway and the effective contact radius along it (Zhao 2022,
//! Eq. (4) to (6)).

use super::{NEAR_END, Raceway};
use crate::numerics::angle::wrap_angle_rad;
use crate::numerics::chebyshev::Polynomial;
use crate::numerics::root;

impl Raceway {
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
        let near = self.path_end_m() * NEAR_END;
        // The slope itself is smooth.
        let x = x_m.clamp(-near, near);
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

    pub(super) fn outer_orbit_radius_m(&self) -> f64 {
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

    pub(super) fn radius_by_root(&self, local_angle_rad: f64) -> f64 {
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

    /// −d²r/dx² at the end X of the path, where r = Rw and r′ = 0: the path reaches the plain raceway
    /// from below where it is above 0.
    pub(super) fn end_curvature_per_m(&self) -> f64 {
        let [a, b, _] = self.path;
        let x = self.path_end_m();
        let (y, slope) = (self.path_y_m(x), self.path_slope(x));
        let bend = 12.0 * a * x * x + 2.0 * b;
        -(1.0 + slope * slope + y * bend) / self.groove_bottom_radius_m
    }

    /// dα/dψ at +θ: r ≈ Rw − κ/2 (X − x)², so that α ≈ √(κ/Rw) (X − x).
    fn contact_angle_end_slope(&self) -> f64 {
        let x = self.path_end_m();
        let (y, slope) = (self.path_y_m(x), self.path_slope(x));
        let turning = (x * slope - y) / self.groove_bottom_radius_m.powi(2);
        -(self.end_curvature_per_m() / self.ball_radius_m).sqrt() / turning
    }
}
