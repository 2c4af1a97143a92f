//! Ratios of dimensions on which load ratings depend.

use crate::bearing::Bearing;

/// γ = Dw cos α0/Dpw.
pub(super) fn gamma(bearing: &Bearing) -> f64 {
    gamma_at(bearing, bearing.contact_angle_rad())
}

/// γ = Dw cos α/Dpw at another contact angle.
pub(super) fn gamma_at(bearing: &Bearing, contact_angle_rad: f64) -> f64 {
    bearing.ball_radius_m() / bearing.pitch_radius_m() * contact_angle_rad.cos()
}

/// Radii of curvature of both grooves over the ball diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Conformities {
    pub inner: f64,
    pub outer: f64,
}

impl Conformities {
    pub(super) fn of(bearing: &Bearing) -> Self {
        let d = bearing.dimensions();
        let over_diameter = |radius_m: f64| radius_m / (2.0 * d.ball_radius_m);
        Self {
            inner: over_diameter(d.inner_groove_curvature_radius_m),
            outer: over_diameter(d.outer_groove_curvature_radius_m),
        }
    }

    /// Conformities of dynamic ratings, [`STANDARD_CONFORMITY`] or more: a smaller groove radius does not necessarily
    /// raise the rating, a larger one lowers it (ISO 281:2007, 5.1).
    pub(super) fn rated(bearing: &Bearing) -> Self {
        let own = Self::of(bearing);
        Self {
            inner: own.inner.max(STANDARD_CONFORMITY),
            outer: own.outer.max(STANDARD_CONFORMITY),
        }
    }

    /// Whether a groove is closer to the balls than the table of ISO 281 rates, beyond rounding.
    pub(super) fn are_closer_than_rated(&self) -> bool {
        self.inner.min(self.outer) < STANDARD_CONFORMITY * (1.0 - 1e-6)
    }
}

/// Groove radius over Dw of the table of ISO 281.
const STANDARD_CONFORMITY: f64 = 0.52;

/// Ratio of the load ratings of a ball contact at the inner and the outer raceway without
/// its leading factor `c`: c ((1 − γ)/(1 + γ))^1.72 (ri/re · (2re − Dw)/(2ri − Dw))^0.41
/// (ISO/TR 1281-1).
pub(super) fn raceway_ratio(c: f64, gamma: f64, grooves: Conformities) -> f64 {
    let Conformities { inner, outer } = grooves;
    let osculation = inner / outer * (2.0 * outer - 1.0) / (2.0 * inner - 1.0);
    c * ((1.0 - gamma) / (1.0 + gamma)).powf(1.72) * osculation.powf(0.41)
}
