//! Contact of a ball with a raceway under its force: pressure and ellipse.

use crate::bearing::Bearing;
use crate::contact::hertz::PointContact;

/// Contact point of a ball at a raceway, by Hertz with the nominal ball.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RacewayContact {
    /// Largest contact pressure, Pa.
    pub pressure_pa: f64,
    /// Semi-axes of the contact ellipse, m: along the rolling direction, across it.
    pub semi_axes_m: [f64; 2],
}

impl RacewayContact {
    /// That of `contact` under the force `force_n`.
    pub(crate) fn new(contact: &PointContact, force_n: f64) -> Self {
        Self {
            pressure_pa: contact.peak_pressure_pa(force_n),
            semi_axes_m: contact.semi_axes_m(force_n),
        }
    }

    /// Contact at the inner raceway under the force `force_n`.
    pub fn inner(bearing: &Bearing, force_n: f64) -> Self {
        Self::new(bearing.inner_contact(), force_n)
    }

    /// Contact at the outer raceway of a ball with effective radius `r_m` under the radial force
    /// `force_n`. Where r < Rw two points share it, each with F′o = Fo·Rw/(2r) (Zhao 2022,
    /// Eq. (19)); the ring's curvature in the plane of rolling is then that of a cone at the
    /// contact point, (r/Rw)/(Ro − Rw + r).
    pub fn outer(bearing: &Bearing, r_m: f64, force_n: f64) -> Self {
        let rw = bearing.ball_radius_m();
        if r_m >= rw {
            return Self::new(bearing.outer_contact(), force_n);
        }
        let cosine = r_m / rw;
        let materials = bearing.materials();
        let contact = PointContact::between(
            [1.0 / rw; 2],
            [
                -cosine / (bearing.outer_orbit_radius_m() + r_m),
                -1.0 / bearing.dimensions().outer_groove_curvature_radius_m,
            ],
            [&materials.ball, &materials.ring],
        );
        Self::new(&contact, force_n / (2.0 * cosine))
    }
}

/// Peak Hertz pressure of [`RacewayContact::outer`], Pa.
pub fn outer_pressure_pa(bearing: &Bearing, r_m: f64, force_n: f64) -> f64 {
    RacewayContact::outer(bearing, r_m, force_n).pressure_pa
}
