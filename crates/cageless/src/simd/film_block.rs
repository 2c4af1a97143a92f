//! Constants of the rolling force of lubricated contacts, lane by lane.

use std::sync::Arc;

use crate::dynamics::Model;
use crate::film::{RollingCurveLanes, RollingModel};
use crate::numerics::lanes::Lanes;

/// Constants of the contacts of the bearing of each lane.
#[derive(Clone)]
pub(super) struct FilmBlock {
    pub inner: RollingCurveLanes,
    /// Coefficients over the place.
    pub outer: Vec<RollingCurveLanes>,
    /// The place is scale cos α + shift.
    pub scale: Lanes,
    /// See `scale`.
    pub shift: Lanes,
}

impl FilmBlock {
    /// Constants of the models; lane l belongs to model l modulo their number. `None` without films.
    pub(super) fn new(models: &[Arc<Model>]) -> Option<Self> {
        let films: Option<Vec<&RollingModel>> =
            models.iter().map(|model| model.film.as_ref()).collect();
        let films = films?;
        let film = |lane: usize| films[lane % films.len()];
        let length = films.iter().map(|film| film.outer.len()).max()?;
        let number = |of: fn(&RollingModel) -> f64| Lanes(std::array::from_fn(|l| of(film(l))));
        let coefficient = |k: usize| {
            RollingCurveLanes::from_fn(|lane| film(lane).outer.get(k).copied().unwrap_or_default())
        };
        Some(Self {
            inner: RollingCurveLanes::from_fn(|lane| film(lane).inner),
            outer: (0..length).map(coefficient).collect(),
            scale: number(|film| film.scale),
            shift: number(|film| film.shift),
        })
    }
}
