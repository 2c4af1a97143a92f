//! Ratings of the bearing as catalogues and standards state them: basic load ratings
//! (ISO 281, ISO 76), rating life (ISO 281, ISO/TS 16281), static safety, passing frequencies,
//! speed parameter.
//!
//! All of them are closed forms of the dimensions, the operating conditions and the loads of
//! the balls in static equilibrium; none needs a run. The standards are for steel bearings
//! with plain grooves: of a discrete raceway and of ceramic balls the lives are an indication.
//!
//! ```
//! use cageless::reference::Structure;
//! use cageless::{equilibrium, rating::Rating};
//!
//! let case = Structure::D.case(); // Zhao 2022, Table 2, structure (d)
//! let rating = Rating::new(&case, &equilibrium::solve(&case)?);
//!
//! assert!((rating.basic.dynamic_n - 22_102.0).abs() < 1.0);
//! assert!(rating.l10r_mrev.is_some_and(|life| life > 1000.0));
//! # Ok::<(), cageless::equilibrium::EquilibriumError>(())
//! ```

mod basic_ratings;
mod equivalent_load;
mod friction_torque;
mod load_distribution;
mod load_factor;
mod lubrication;
mod passing_frequencies;
mod ratios;
mod reference_life;
mod skf_friction;
mod speed_factor;

use std::f64::consts::TAU;

use crate::ball::BothContacts;
use crate::bearing::Bearing;
use crate::case::Case;
use crate::equilibrium::Equilibrium;
use crate::equilibrium::space::{SpatialEquilibrium, forces_at_rest};
use crate::material::{Material, Materials};

pub use basic_ratings::BasicRatings;
#[cfg(test)]
pub(crate) use basic_ratings::static_factor;

#[cfg(test)]
pub(crate) use basic_ratings::dynamic_factor;
pub use equivalent_load::EquivalentLoad;
#[cfg(test)]
pub(crate) use equivalent_load::LoadFactors;
#[cfg(test)]
pub(crate) use equivalent_load::RowArrangement;
pub use friction_torque::{rolling_torque_n_m, skf_friction_torque_n_m};
pub(crate) use load_distribution::rigid_ring_forces_n;
use load_factor::load_factor;
#[cfg(test)]
pub(crate) use lubrication::life_modification_factor;
#[cfg(test)]
pub(crate) use lubrication::minimum_radial_load_n;
#[cfg(test)]
pub(crate) use lubrication::reference_viscosity_m2_s;
pub use lubrication::{LubricatedRating, VISCOSITY_RATIO_MIN};
pub use passing_frequencies::PassingFrequencies;
pub(crate) use passing_frequencies::loaded_contact_angle_rad;
#[cfg(test)]
pub(crate) use ratios::Conformities;
pub(crate) use reference_life::ReferenceLife;
pub use skf_friction::SkfFriction;
#[cfg(test)]
pub(crate) use skf_friction::SkfOperation;
#[cfg(test)]
pub(crate) use speed_factor::SPEED_PARAMETER_MAX_MM_RPM;
pub(crate) use speed_factor::speed_factor_mm_rpm;
pub use speed_factor::speed_warning;

/// Ratings of a bearing at its operating point.
#[derive(Debug, Clone, PartialEq)]
pub struct Rating {
    /// Basic load ratings.
    pub basic: BasicRatings,
    /// P of ISO 281 and P0 of ISO 76; `None` without load, with moments or a tilt.
    pub equivalent: Option<EquivalentLoad>,
    /// L10 = (Cr/P)³ of ISO 281, million revolutions; `None` without P.
    pub l10_mrev: Option<f64>,
    /// L10r of ISO/TS 16281, million revolutions: rigid rings under the radial load, without
    /// weight and centrifugal force; `None` without radial load.
    pub l10r_mrev: Option<f64>,
    /// L10r with the forces of the balls in equilibrium, weight and centrifugal force included,
    /// million revolutions; `None` if no ball is loaded.
    pub l10r_at_speed_mrev: Option<f64>,
    /// s0 = C0r/P0 of ISO 76; `None` without P0.
    pub static_safety_factor: Option<f64>,
    /// Factor on radial load, axial load and moments together at which the largest contact pressure in equilibrium
    /// reaches 4200 MPa, preload, weights and speed unchanged; `None` without load, and where a contact leaves its
    /// groove before.
    pub pressure_safety: Option<f64>,
    /// Passing frequencies.
    pub passing: PassingFrequencies,
    /// Contact angle of the loaded bearing, rad; `None` in the plane, and if no ball is loaded.
    pub loaded_contact_angle_rad: Option<f64>,
    /// n·Dpw, speed of the inner ring times pitch diameter, mm/min.
    pub speed_factor_mm_rpm: f64,
    /// Materials, of which the standards rate the first two.
    pub materials: RatedMaterials,
    /// Whether a groove is closer to the balls than ISO 281 rates: the dynamic rating is that of 0.52 Dw.
    pub has_close_grooves: bool,
}

/// Materials of a bearing as the standards of load ratings tell them apart.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RatedMaterials {
    /// Balls and rings of steel: ISO 281 and ISO 76.
    Steel,
    /// Balls of silicon nitride in steel rings: ISO 20056.
    Hybrid,
    /// Others, which no standard rates.
    Other,
}

impl RatedMaterials {
    fn of(bearing: &Bearing) -> Self {
        let Materials { ball, ring } = bearing.materials();
        match (ball.is_steel(), ring.is_steel()) {
            (true, true) => Self::Steel,
            (false, true) if is_silicon_nitride(ball) => Self::Hybrid,
            _ => Self::Other,
        }
    }
}

impl Rating {
    /// Ratings of a case in equilibrium.
    pub fn new(case: &Case, equilibrium: &Equilibrium) -> Self {
        let reference = ReferenceLife::new(&case.bearing);
        let at_rest = rigid_ring_forces_n(case).and_then(|q| reference.l10r_mrev(&q, &q));
        let (inner_n, outer_n) = (&equilibrium.inner_force_n, &equilibrium.outer_force_n);
        Self {
            l10r_at_speed_mrev: reference.l10r_mrev(inner_n, outer_n),
            ..Self::with_reference_life(case, at_rest)
        }
    }

    /// Ratings of a case in equilibrium in space: L10r from the loads of the balls under all loads.
    pub fn in_space(case: &Case, space: &SpatialEquilibrium) -> Self {
        let reference = ReferenceLife::new(&case.bearing);
        let life = |e: &SpatialEquilibrium| {
            let (inner, outer) = (&e.rest.inner_force_n, &e.rest.outer_force_n);
            let rows = e.row.chunk_by(|a, b| a == b).scan(0, |from, row| {
                let range = *from..*from + row.len();
                *from = range.end;
                Some(BothContacts {
                    outer: &outer[range.clone()],
                    inner: &inner[range],
                })
            });
            reference.l10r_of_rows_mrev(rows)
        };
        let at_rest = forces_at_rest(case).ok().and_then(|e| life(&e));
        Self {
            loaded_contact_angle_rad: loaded_contact_angle_rad(space),
            l10r_at_speed_mrev: life(space),
            ..Self::with_reference_life(case, at_rest)
        }
    }

    /// Ratings with this L10r, that at speed left out.
    fn with_reference_life(case: &Case, l10r_mrev: Option<f64>) -> Self {
        let bearing = &case.bearing;
        let basic = BasicRatings::of_rows(bearing, case.rows.len().max(1));
        let equivalent = EquivalentLoad::new(case);
        let l10_mrev = equivalent.map(|load| basic.l10_mrev(load.dynamic_n));
        Self {
            equivalent,
            l10_mrev,
            l10r_mrev,
            l10r_at_speed_mrev: None,
            static_safety_factor: equivalent.map(|load| basic.static_safety_factor(load.static_n)),
            pressure_safety: load_factor(case),
            passing: PassingFrequencies::new(case),
            loaded_contact_angle_rad: None,
            speed_factor_mm_rpm: speed_factor_mm_rpm(case),
            materials: RatedMaterials::of(bearing),
            has_close_grooves: ratios::Conformities::of(bearing).are_closer_than_rated(),
            basic,
        }
    }

    /// Running time of a life in million revolutions at the speed of the case, h; `None` at
    /// standstill.
    pub fn hours(case: &Case, life_mrev: f64) -> Option<f64> {
        let per_hour = case.operation.inner_speed_rad_s.abs() / TAU * 3600.0;
        (per_hour > 0.0).then(|| life_mrev * 1e6 / per_hour)
    }

    /// Warnings for what no bearing stands; that of the contact pressure is
    /// `Equilibrium::overload`.
    pub fn warnings(&self) -> Vec<String> {
        let unsafe_load = self.static_safety_factor.filter(|s| *s < 1.0).map(|s| {
            format!(
                "the static safety s0 = C0r/P0 is {s:.2}, below 1: the load exceeds the basic \
                 static load rating of {:.0} N (ISO 76)",
                self.basic.static_n
            )
        });
        unsafe_load
            .into_iter()
            .chain(self.short_life())
            .chain(speed_warning(self.speed_factor_mm_rpm))
            .collect()
    }
}

/// L10r over L10 below which the second says little.
const SHORT: f64 = 0.5;

impl Rating {
    /// Warning that L10 and s0 know nothing of what makes the life of this bearing short.
    fn short_life(&self) -> Option<String> {
        let [l10, l10r] = [self.l10_mrev?, self.l10r_mrev?];
        (l10r < SHORT * l10).then(|| {
            format!(
                "L10 is {:.1} times L10r: ISO 281 and ISO 76 know neither clearance nor preload, which shorten the life \
                 of this bearing; L10r (ISO 16281) has the load of every ball",
                l10 / l10r
            )
        })
    }
}

/// Whether a material is a silicon nitride for balls (ISO 26602) by its modulus and density.
fn is_silicon_nitride(material: &Material) -> bool {
    (270e9..=330e9).contains(&material.youngs_modulus_pa)
        && (3000.0..=3400.0).contains(&material.density_kg_m3)
}
