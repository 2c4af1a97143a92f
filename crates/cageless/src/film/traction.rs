//! Traction of a film that shares the load of a contact with asperities.
//!
//! With the area of Hertz A = πab, the viscosity η̄ at the mean pressure Q/A (Roelands) and the central film h of
//! Hamrock & Dowson, film and elastic creep in series have the slope
//!
//!   1/g = h/(η̄ A) + V/(G ab C11),   V² = u² + u₀²,
//!
//! and so shear at ΔV₀ = A τ/g = τ h/η̄ + πτ V/(G C11). Asperities carry φ = exp(−2.1 (h/R_q)^0.85).

use super::Film;
use super::contact::LubricatedContact;
use super::rolling_force::Rolling;
use super::thickness::{ASPERITY_EXPONENT, ASPERITY_FACTOR};
use crate::contact::FilmTraction;
use crate::contact::creep::rolling_speed_m_s;
use crate::numerics::exponential::{exponential, logarithm};
use crate::numerics::inverse_root::inverse_cube_root;
use crate::numerics::lanes::lane_struct;

/// τ, stress from which the shear of oil is no longer viscous (Eyring), Pa.
const STRESS_PA: f64 = 5e6;
/// Constants of Roelands' viscosity, ln(η̄/η) = (ln η + 9.67) ((1 + 5.1·10⁻⁹ p)^Z − 1).
const ROELANDS: [f64; 2] = [9.67, 5.1e-9];
/// h ∝ (u¹⁰/Q)^0.067.
const THICKNESS_EXPONENT: f64 = 0.067;
/// Load below which films no longer change, N: keeps 0/0 out.
const LEAST_LOAD_N: f64 = 1e-9;
/// Least exponent.
const LEAST: f64 = -80.0;

lane_struct! {
    /// Constants of the traction of one contact in one oil.
    pub(crate) struct TractionCurve per lane TractionCurveLanes {
        /// μ, limit of the friction of the film over the load.
        limit,
        /// A τ/(μ Q^(2/3)), N^(1/3).
        stress,
        /// ln (τ h/η) at 1 N and 1 m/s, m/s.
        fluidity,
        /// ln (2.1 (h/R_q)^0.85) at 1 N and 1 m/s.
        asperity,
        /// d ln h/d(1 − cos α).
        flank,
        /// d ln A/d(1 − cos α).
        widening,
        /// 5.1·10⁻⁹ Q^(2/3)/A, N^(−1/3).
        pressure,
        /// Z of Roelands.
        exponent,
        /// ln η + 9.67.
        stiffening,
        /// πτ/(G C11).
        creep,
    }
}

/// Contact of a ball with a ring of another curvature, against the contact that a [`TractionCurve`] is of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct ContactShape {
    /// ln of the ratio of the films.
    pub thickening: f64,
    /// Ratio of the areas of Hertz.
    pub area: f64,
    /// Inverse of the ratio of the areas.
    pub inverse_area: f64,
    /// Ratio of 1/C11.
    pub creep: f64,
}

/// Contact of a film with asperities.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TractionContact {
    /// On the plain raceway.
    pub contact: LubricatedContact,
    /// On a flank of this 1 − cos α, if there are any.
    pub flank: Option<(LubricatedContact, f64)>,
    /// G ca cb C11, N^(1/3).
    pub creep_stiffness_n1_3: f64,
}

impl TractionCurve {
    /// Constants of a contact in a film.
    pub(super) fn new(film: &Film, of: &TractionContact) -> Self {
        let oil = &film.oil;
        let one = Rolling {
            load_n: 1.0,
            speed_m_s: 1.0,
        };
        let thickness_m = |contact: &LubricatedContact| contact.film_thickness(oil, one).central_m;
        let h = thickness_m(&of.contact);
        let area = of.contact.area_m2_n2_3();
        let over_angle = |value: &dyn Fn(&LubricatedContact) -> f64| {
            let flank = of.flank.as_ref();
            flank.map_or(0.0, |(contact, raised)| {
                (value(contact) / value(&of.contact)).ln() / raised
            })
        };
        let stiffening = oil.viscosity_pa_s.ln() + ROELANDS[0];
        let limit = film.traction_coefficient;
        Self {
            limit,
            stress: match limit > 0.0 {
                true => area * STRESS_PA / limit,
                false => 0.0,
            },
            fluidity: (STRESS_PA * h / oil.viscosity_pa_s).ln(),
            asperity: ASPERITY_FACTOR.ln() + ASPERITY_EXPONENT * (h / film.roughness_m).ln(),
            flank: over_angle(&thickness_m),
            widening: over_angle(&LubricatedContact::area_m2_n2_3),
            pressure: ROELANDS[1] / area,
            exponent: oil.pressure_viscosity_1_pa / (ROELANDS[1] * stiffening),
            stiffening,
            creep: STRESS_PA * area / of.creep_stiffness_n1_3,
        }
    }

    /// Film of a contact under a load, whose u² + u₀² is `speed_square`, on a flank of the 1 − cos α `raised`.
    #[inline(always)]
    pub(crate) fn at(&self, load_n: f64, speed_square: f64, raised: f64) -> FilmTraction {
        // Linear, for areas differ by less than a hundredth.
        let wider = self.widening * raised;
        let shape = ContactShape {
            thickening: self.flank * raised,
            area: 1.0 + wider,
            inverse_area: 1.0 - wider,
            creep: 1.0,
        };
        self.of_shape(load_n, speed_square, &shape)
    }

    /// Film of a contact of another shape under a load, whose u² + u₀² is `speed_square`.
    #[inline(always)]
    pub(crate) fn of_shape(
        &self,
        load_n: f64,
        speed_square: f64,
        shape: &ContactShape,
    ) -> FilmTraction {
        let load = load_n + LEAST_LOAD_N;
        let root = inverse_cube_root(load);
        let grown = 1.0 + self.pressure * shape.inverse_area * (load * root * root);
        let thicker = self.stiffening * (exponential(self.exponent * logarithm(grown)) - 1.0);
        let square = speed_square * speed_square;
        let film = THICKNESS_EXPONENT * logarithm(square * square * speed_square / load)
            + shape.thickening;
        let viscous = exponential((self.fluidity + film - thicker).max(LEAST));
        let bearing = exponential(self.asperity + ASPERITY_EXPONENT * film);
        let asperity_share = exponential((-bearing).max(LEAST));
        FilmTraction {
            asperity_share,
            limit: (1.0 - asperity_share) * self.limit * load_n,
            stress_ratio: self.stress * shape.area * root,
            inverse_speed: 1.0 / (viscous + self.creep * shape.creep * speed_square.sqrt()),
        }
    }

    /// Slope of friction over ΔV at rest, of the film alone, N·s/m.
    pub(crate) fn slope_n_s_m(&self, rolling: Rolling) -> f64 {
        let speed_m_s = rolling_speed_m_s(rolling.speed_m_s);
        let film = self.at(rolling.load_n, speed_m_s * speed_m_s, 0.0);
        let [_, slope] = film.mixed([0.0; 2], 0.0);
        slope
    }
}

/// Constants of the contacts of a bearing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct TractionModel {
    pub outer: TractionCurve,
    pub inner: TractionCurve,
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::super::Oil;
    use super::*;
    use crate::film::thickness::asperity_share;
    use crate::reference;

    /// Film, asperities and slope of any contact are those of the formulas.
    #[test]
    fn curve_follows_the_formulas() {
        let bearing = reference::bearing();
        let [raised, stiffness] = [0.1, 3e3];
        let contacts = [1.0, 1.0 - raised].map(|cosine| LubricatedContact::outer(&bearing, cosine));
        let area =
            |of: &LubricatedContact, load_n| PI * of.cross_axis_m(load_n).powi(2) * of.axis_ratio;
        for mpa_s in [0.5, 5.0, 300.0] {
            let film = Film::flooded(Oil::mineral(1e-3 * mpa_s, 0.035));
            let of = TractionContact {
                contact: contacts[0],
                flank: Some((contacts[1], raised)),
                creep_stiffness_n1_3: stiffness,
            };
            let curve = TractionCurve::new(&film, &of);
            for (load_n, speed_m_s) in [(1e-2, 0.1), (20.0, 13.75), (470.0, 70.0), (4e3, 1.0)] {
                for (contact, raised) in contacts.iter().zip([0.0, raised]) {
                    let at = Rolling { load_n, speed_m_s };
                    let what = format!("{mpa_s} {load_n} {raised}");
                    let h = contact.film_thickness(&film.oil, at).central_m;
                    let found = curve.at(load_n, speed_m_s * speed_m_s, raised);
                    let share = asperity_share(h / film.roughness_m);
                    assert!((found.asperity_share - share).abs() < 1e-7, "{what}");
                    let eta = film.oil.viscosity_pa_s;
                    let stiff = eta.ln() + 9.67;
                    let z = film.oil.pressure_viscosity_1_pa / (5.1e-9 * stiff);
                    let pressure = load_n / area(contact, load_n);
                    let power = (1.0 + 5.1e-9 * pressure).powf(z) - 1.0;
                    let viscous = h / (eta * (stiff * power).exp());
                    let creep = speed_m_s * area(&contacts[0], 1.0) / stiffness;
                    let scale = found.inverse_speed * 5e6 * (viscous + creep);
                    let within = if raised > 0.0 { 1e-3 } else { 3e-6 };
                    assert!((scale - 1.0).abs() < within, "{what}: {scale}");
                    let limit = found.limit / ((1.0 - share) * 0.05 * load_n);
                    assert!((limit - 1.0).abs() < 2e-6, "{what}: {limit}");
                    let ratio = found.stress_ratio * pressure * 0.05 / 5e6;
                    assert!((ratio - 1.0).abs() < 1e-4, "{what}: {ratio}");
                }
            }
            let unloaded = curve.at(0.0, 1e-6, 0.0);
            assert_eq!(unloaded.mixed([0.0; 2], 3.0), [0.0; 2]);
        }
    }
}
