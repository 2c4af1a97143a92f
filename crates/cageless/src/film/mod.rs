//! Oil film of the rolling contacts: viscosity, thickness, and the force that resists rolling.
//!
//! The pressure at the inlet of a lubricated contact pushes back at both surfaces, F_R each (Biboulet & Houpert, Proc.
//! IMechE J 224 (2010) 777). An unloaded ball loses some per cent of its speed by it in half an orbit.
//!
//! ```
//! use cageless::film::OilGrade;
//!
//! let [warm, hot] = [40.0, 70.0].map(|temperature_c| OilGrade::IsoVg32.at(temperature_c));
//! assert!(hot.viscosity_pa_s < warm.viscosity_pa_s);
//! ```

mod contact;
mod curve;
mod curve_polynomial;
mod free_arc;
mod groove_curves;
mod groove_traction;
pub(crate) mod hysteresis;
mod motion;
mod oil;
mod range;
mod rest;
mod rolling_ball;
mod rolling_force;
mod spacing;
mod starvation;
mod thickness;
mod traction;
mod traction_at_rest;
mod unreached_arc;

use crate::error::{Allowed, InputError};
use crate::limits::{from_to, require};

pub(crate) use contact::LubricatedContact;
pub(crate) use curve::{RollingCurve, RollingCurveLanes};
pub(crate) use curve_polynomial::CurvePolynomial;
#[cfg(test)]
pub(crate) use free_arc::FreeBall;
pub(crate) use groove_curves::GrooveCurves;
pub(crate) use groove_traction::{GrooveFilms, SlotEdge};
pub(crate) use motion::RollingModel;
pub use oil::{Oil, OilGrade, TEMPERATURES_C, VISCOSITIES_PA_S, VISCOSITY_TEMPERATURE_MAX_1_K};
pub use rest::{FilmAtRest, WEIGHT_MAX};
pub(crate) use rolling_force::Rolling;
pub use spacing::{QUEUE, free_share, opening_gap_rad};
pub use starvation::INLET_RATIO_MIN;
#[cfg(test)]
pub(crate) use starvation::starved_share;
#[cfg(test)]
pub(crate) use thickness::asperity_share;
pub(crate) use traction::{TractionCurve, TractionCurveLanes};
pub(crate) use traction_at_rest::MixedFriction;

/// Supply of contacts that flood.
pub const FLOODED: f64 = 1.0;
/// Supply of contacts with two drops of oil: balls of 7.94 mm measured beside races of their size carry 0.62 to 0.73 of
/// the force of flooded ones (Bălan et al., Lubricants 3 (2015) 222).
pub const TWO_DROPS: f64 = 0.65;
/// Largest composite roughness of a raceway and a ball, m.
const ROUGHNESS_MAX_M: f64 = 1e-5;

crate::named_enum! {
    /// Friction of lubricated contacts with raceways.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Traction {
        /// The law of friction of the case.
        Law = "law",
        /// Friction of a film, shared by asperities with the law of the case.
        Film = "film",
    }
}

/// Oil film of all contacts of balls with raceways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Film {
    /// Oil at the inlet of the contacts.
    pub oil: Oil,
    /// Share of the rolling force of a flooded contact, 0 to 1.
    pub supply: f64,
    /// S that the supply follows from, film at the inlet over the least flooded one; `None` of a supply by itself.
    pub inlet_ratio: Option<f64>,
    /// R_q, composite roughness of ball and raceway, m.
    pub roughness_m: f64,
    /// Whether shear heats the inlet.
    pub inlet_heat: bool,
    /// Whether the hysteresis of the steel resists rolling as well.
    pub hysteresis: bool,
    /// Friction of the contacts.
    pub traction: Traction,
    /// μ, limit of the friction of the film over the load; of [`Traction::Film`].
    pub traction_coefficient: f64,
}

impl Film {
    /// Limit of the friction of a film over its load, unless one is given.
    pub const TRACTION_COEFFICIENT: f64 = 0.05;
    /// Largest limit of the friction of a film over its load.
    const TRACTION_COEFFICIENT_MAX: f64 = 0.2;

    /// Flooded contacts of the usual roughness, 0.1 µm, with a heated inlet.
    pub fn flooded(oil: Oil) -> Self {
        Self {
            oil,
            supply: FLOODED,
            inlet_ratio: None,
            roughness_m: 1e-7,
            inlet_heat: true,
            hysteresis: false,
            traction: Traction::Law,
            traction_coefficient: Self::TRACTION_COEFFICIENT,
        }
    }

    /// Whether oil reaches the contacts.
    pub fn has_oil(&self) -> bool {
        self.supply > 0.0
    }

    /// Checks that oil and supply can be.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be.
    pub fn check(&self) -> Result<(), InputError> {
        self.oil.check()?;
        let why = "a share of the rolling force of a flooded contact";
        from_to("supply", self.supply, 0.0..=FLOODED, why)?;
        let (limit, most) = (self.traction_coefficient, Self::TRACTION_COEFFICIENT_MAX);
        Allowed::AtLeast(0.0, "").check("traction_coefficient", limit)?;
        let why = "traction fluids have 0.12; it is no percentage";
        Allowed::AtMost(most, why).check("traction_coefficient", limit)?;
        let (least, most) = (1e-9, ROUGHNESS_MAX_M);
        let kept = (least..=most).contains(&self.roughness_m);
        require("roughness_m", self.roughness_m, kept, "from 0.001 to 10 µm")
    }

    /// Rolling force on either surface of a contact, N, with the heat of the inlet and the supply; odd in the speed.
    pub(crate) fn rolling_force_n(&self, contact: &LubricatedContact, rolling: Rolling) -> f64 {
        let force = contact.rolling_force(&self.oil, rolling);
        let heat = match self.inlet_heat {
            true => force.heat_factor,
            false => 1.0,
        };
        self.supply * heat * force.isothermal_n()
    }
}
