//! Contact of a ball with a raceway under its force: pressure and ellipse.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::{RacewayContact, RacewayPoint};
//!
//! let bearing = Structure::D.case().bearing; // Zhao 2022, Table 1
//! let pressure = |cosine: f64| {
//!     let point = RacewayPoint::of_outer(cosine, 500.0);
//!     RacewayContact::outer(&bearing, point).pressure_pa
//! };
//! // At 30° two points share the force, which press less than one on the plain raceway.
//! assert!(pressure(30f64.to_radians().cos()) < pressure(1.0));
//! // The pressure of a point rises with the cube root of its force.
//! let inner = |force_n| RacewayContact::inner(&bearing, RacewayPoint { force_n, cosine: 1.0 }).pressure_pa;
//! assert!((inner(80.0) / inner(10.0) - 2.0).abs() < 1e-12);
//! ```

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

/// Point at which a ball bears on a raceway.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RacewayPoint {
    /// Normal force, N.
    pub force_n: f64,
    /// Cosine of the angle of the normal from the radius, above 0.
    pub cosine: f64,
}

impl RacewayPoint {
    /// Either point at the outer raceway of a ball whose effective radius is `cosine` times its
    /// own, under the radial force `force_n`: where that is less than 1, two share the force, each
    /// with F′o = Fo·Rw/(2r) (Zhao 2022, Eq. (19)).
    pub fn of_outer(cosine: f64, force_n: f64) -> Self {
        let points = if cosine < 1.0 { 2.0 * cosine } else { 1.0 };
        Self {
            force_n: force_n / points,
            cosine,
        }
    }
}

impl RacewayContact {
    /// Peak pressure and semi-axes of `contact` under the force `force_n`.
    pub(crate) fn new(contact: &PointContact, force_n: f64) -> Self {
        Self {
            pressure_pa: contact.peak_pressure_pa(force_n),
            semi_axes_m: contact.semi_axes_m(force_n),
        }
    }

    /// Contact at the inner raceway.
    pub fn inner(bearing: &Bearing, point: RacewayPoint) -> Self {
        let contact = match point.cosine < 1.0 {
            true => &bearing.contacts_at([point.cosine.acos(); 2])[0],
            false => bearing.inner_contact(),
        };
        Self::new(contact, point.force_n)
    }

    /// Contact at the outer raceway. The ring's curvature in the plane of rolling is that of a
    /// cone at the contact point, cos α/(Ro − Rw + Rw cos α).
    pub fn outer(bearing: &Bearing, point: RacewayPoint) -> Self {
        let RacewayPoint { force_n, cosine } = point;
        if cosine >= 1.0 {
            return Self::new(bearing.outer_contact(), force_n);
        }
        let rw = bearing.ball_radius_m();
        let materials = bearing.materials();
        let contact = PointContact::between(
            [1.0 / rw; 2],
            [
                -cosine / (bearing.outer_orbit_radius_m() + rw * cosine),
                -1.0 / bearing.dimensions().outer_groove_curvature_radius_m,
            ],
            [&materials.ball, &materials.ring],
        );
        Self::new(&contact, force_n)
    }
}
