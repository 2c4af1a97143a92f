//! Basic reference rating life from the load of every ball (ISO/TS 16281).

use super::basic_ratings::BasicRatings;
use super::ratios::{Conformities, gamma, raceway_ratio};
use crate::ball::BothContacts;
use crate::bearing::Bearing;

/// 0.407 = Jr/J1: radial load integral of a half-loaded bearing over the mean effective load
/// of the ring that turns under the load.
const ROTATING: f64 = 0.407;
/// 0.389 = Jr/J2: the same for the ring that stands still under the load.
const STATIONARY: f64 = 0.389;

/// Dynamic load ratings of a single ball at each raceway of a bearing whose inner ring turns
/// under a load that stands still.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ReferenceLife {
    /// Qci, rating of a ball at the inner raceway, N.
    pub inner_rating_n: f64,
    /// Qce, rating of a ball at the outer raceway, N.
    pub outer_rating_n: f64,
}

impl ReferenceLife {
    /// Ratings of the balls of a bearing with a plain outer raceway:
    ///
    ///   Qci = Cr/(0.407 Z cos^0.7 α0) (1 + a^(10/3))^(3/10),
    ///   Qce = Cr/(0.389 Z cos^0.7 α0) (1 + a^(−10/3))^(3/10),
    ///   a = 1.044 ((1 − γ)/(1 + γ))^1.72 (ri/re · (2re − Dw)/(2ri − Dw))^0.41.
    pub(crate) fn new(bearing: &Bearing) -> Self {
        let across = bearing.contact_angle_rad().cos().powf(0.7);
        let per_ball = BasicRatings::new(bearing).dynamic_n / bearing.balls() as f64 / across;
        let ratio = raceway_ratio(1.044, gamma(bearing), Conformities::rated(bearing));
        let rating = |integral: f64, exponent: f64| {
            per_ball / integral * (1.0 + ratio.powf(exponent)).powf(0.3)
        };
        Self {
            inner_rating_n: rating(ROTATING, 10.0 / 3.0),
            outer_rating_n: rating(STATIONARY, -10.0 / 3.0),
        }
    }

    /// L10r, million revolutions, from the force of every ball at both raceways; `None` if
    /// there is no force:
    ///
    ///   Qei = (Σ Fi³/Z)^(1/3), Qee = (Σ Fo^(10/3)/Z)^(3/10),
    ///   L10r = ((Qci/Qei)^(−10/3) + (Qce/Qee)^(−10/3))^(−9/10).
    ///
    /// At speed the outer forces hold the centrifugal forces as well.
    pub(crate) fn l10r_mrev(&self, inner_force_n: &[f64], outer_force_n: &[f64]) -> Option<f64> {
        self.l10r_of_rows_mrev([BothContacts {
            outer: outer_force_n,
            inner: inner_force_n,
        }])
    }

    /// L10r of a bearing of several rows, million revolutions, from the forces of each at both
    /// raceways: L10r = (Σ Lk^(−10/9))^(−9/10).
    pub(crate) fn l10r_of_rows_mrev<'f>(
        &self,
        rows: impl IntoIterator<Item = BothContacts<&'f [f64]>>,
    ) -> Option<f64> {
        let of_row = |forces_n: BothContacts<&[f64]>| {
            let inner = effective_load_n(forces_n.inner, 3.0) / self.inner_rating_n;
            let outer = effective_load_n(forces_n.outer, 10.0 / 3.0) / self.outer_rating_n;
            inner.powf(10.0 / 3.0) + outer.powf(10.0 / 3.0)
        };
        let sum = rows.into_iter().map(of_row).reduce(|a, b| a + b)?;
        (sum > UNLOADED.powf(10.0 / 3.0)).then(|| sum.powf(-0.9))
    }
}

/// Share of its rating below which a force is none, but what the search for an equilibrium leaves: the life would be
/// above 1e18 million revolutions.
const UNLOADED: f64 = 1e-6;

/// Power mean of the forces.
fn effective_load_n(force_n: &[f64], exponent: f64) -> f64 {
    let sum: f64 = force_n.iter().map(|f| f.powf(exponent)).sum();
    (sum / force_n.len() as f64).powf(1.0 / exponent)
}
