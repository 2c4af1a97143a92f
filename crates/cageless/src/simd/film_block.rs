//! Constants of the rolling force of lubricated contacts, lane by lane.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::film::{RollingCurve, RollingCurveLanes, RollingModel, TractionCurveLanes};
use crate::numerics::lanes::Lanes;

/// Constants of the contacts of the bearing of each lane.
#[derive(Clone)]
pub(super) struct FilmBlock {
    pub inner: RollingCurveLanes,
    /// Highest coefficients over the place, and the factor of the heat.
    pub highest: RollingCurveLanes,
    /// The other coefficients, from that of the power 0.
    pub lower: Vec<RollingCurveLanes>,
    /// The place is scale cos α + shift.
    pub scale: Lanes,
    /// See `scale`.
    pub shift: Lanes,
    /// Hysteresis of the outer and the inner contacts, N·m/N^1.33.
    pub hysteresis: Option<[Lanes; 2]>,
    /// Traction of the outer and the inner contacts.
    pub traction: Option<[TractionCurveLanes; 2]>,
}

impl FilmBlock {
    /// Constants of the models; lane l belongs to model l modulo their number. `None` without films.
    pub(super) fn new(models: &[Arc<Model>]) -> Option<Self> {
        let films: Option<Vec<&RollingModel>> =
            models.iter().map(|model| model.film.as_ref()).collect();
        let films = films?;
        let film = |lane: usize| films[lane % films.len()];
        let length = films
            .iter()
            .map(|film| film.outer.coefficients.len())
            .max()?;
        let number = |of: fn(&RollingModel) -> f64| Lanes(std::array::from_fn(|l| of(film(l))));
        let coefficient = |k: usize| {
            RollingCurveLanes::from_fn(|lane| RollingCurve {
                heat: film(lane).inner.heat,
                ..film(lane)
                    .outer
                    .coefficients
                    .get(k)
                    .copied()
                    .unwrap_or_default()
            })
        };
        let highest = length.checked_sub(1)?;
        let tractions: Option<Vec<_>> = films.iter().map(|film| film.traction).collect();
        let traction = tractions.map(|of| {
            let at = |lane: usize| of[lane % of.len()];
            [
                TractionCurveLanes::from_fn(|lane| at(lane).outer),
                TractionCurveLanes::from_fn(|lane| at(lane).inner),
            ]
        });
        Some(Self {
            inner: RollingCurveLanes::from_fn(|lane| film(lane).inner),
            highest: coefficient(highest),
            lower: (0..highest).map(coefficient).collect(),
            scale: number(|film| film.outer.scale),
            shift: number(|film| film.outer.shift),
            hysteresis: films.iter().any(|film| film.hysteresis.is_some()).then(|| {
                [
                    number(|film| film.hysteresis.unwrap_or_default().outer),
                    number(|film| film.hysteresis.unwrap_or_default().inner),
                ]
            }),
            traction,
        })
    }
}
