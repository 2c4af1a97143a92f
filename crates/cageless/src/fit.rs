//! Fits, temperatures and speed of a mounted bearing, and the radial internal clearance that they leave.
//!
//! Rings, shaft and housing are thick-walled cylinders (Lamé), the rings up to the bottom of their grooves;
//! temperatures are uniform in each part. Inner ring and shaft grow by their rotation. The clearance that a bearing is
//! bought with holds at 20 °C and at rest.
//!
//! ```
//! use cageless::reference;
//! use cageless::Material;
//! use cageless::Fit;
//!
//! let dimensions = reference::DIMENSIONS; // Zhao 2022, Table 1
//! let fit = Fit {
//!     bore_diameter_m: Some(30e-3),
//!     shaft_interference_m: Some(10e-6),
//!     ..Fit::default()
//! };
//! let clearance = fit.operating_clearance(&dimensions, &Material::STEEL.into(), 0.0)?;
//! // A solid shaft of the same steel: d/Di of the interference.
//! let expected = 10e-6 * 30.0 / 36.48;
//! assert!((clearance.shaft_reduction_m / expected - 1.0).abs() < 1e-9);
//! # Ok::<(), cageless::InputError>(())
//! ```

mod bearing_class;
mod clearance_range;
mod interference;
mod mounting;
mod size_range;
mod tolerance_class;
mod warmth;

pub use bearing_class::BearingClass;
pub use clearance_range::ClearanceRange;
pub(crate) use interference::Interference;
pub use tolerance_class::{HoleClass, ShaftClass};

use crate::bearing::BearingDimensions;
use crate::error::{Allowed, InputError};
use crate::limits::{finite, not_negative, positive, require};
use crate::material::{Material, Materials, check_poisson_ratio};
use mounting::{Mounting, Solid};
use warmth::Warmth;

/// Temperature at which clearance and interferences are stated, °C (ISO 1).
pub const REFERENCE_TEMPERATURE_C: f64 = 20.0;
/// Coefficient of thermal expansion of bearing steel, 1/K (NTN 2203/E, Eq. (8.5); NSK E1102f, Eq. (9.6)).
pub const STEEL_EXPANSION_PER_K: f64 = 12.5e-6;
/// Largest coefficient of thermal expansion, 1/K: plastics have 2e-4.
const EXPANSION_MAX_PER_K: f64 = 1e-3;
/// Highest temperature of bearing steel, °C: what is stabilised for more is no common bearing, and every room is
/// warmer in K.
const STEEL_MAX_C: f64 = 290.0;
/// Smoothing of a ground shaft unless given, m: the middle of 1.0 to 2.5 µm (NTN 2203/E, chapter 7).
pub const SMOOTHING_M: f64 = 1.75e-6;
/// Absolute zero, °C.
const ABSOLUTE_ZERO_C: f64 = -273.15;
/// Largest gain of clearance over the diameter of the inner groove. A loss is limited by the contacts
/// ([`crate::Bearing::new`]).
const STRAIN_MAX: f64 = 0.01;

/// How a bearing is mounted, and how warm its parts are.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Fit {
    /// d, bore diameter of the inner ring; needed with a fit on the shaft.
    pub bore_diameter_m: Option<f64>,
    /// D, outside diameter of the outer ring; needed with a fit in the housing.
    pub outside_diameter_m: Option<f64>,
    /// Tolerance class of the shaft, in place of an interference.
    pub shaft: Option<ShaftClass>,
    /// Tolerance class of the bore of the housing, in place of an interference.
    pub housing: Option<HoleClass>,
    /// Tolerance class of the bearing, of a fit by tolerance classes; Normal unless given.
    pub tolerance_class: Option<BearingClass>,
    /// Interference lost by smoothing of the surfaces, of a fit by tolerance classes; [`SMOOTHING_M`] unless given.
    pub smoothing_m: Option<f64>,
    /// Tolerance of the radial internal clearance before mounting, ±; 0 unless given.
    pub clearance_tolerance_m: f64,
    /// Effective interference of shaft and bore on the diameter, smoothing deducted; below 0 a gap. 0 unless given.
    pub shaft_interference_m: Option<f64>,
    /// Effective interference of outer ring and housing on the diameter; below 0 a gap. 0 unless given.
    pub housing_interference_m: Option<f64>,
    /// Bore of a hollow shaft; 0, a solid one.
    pub shaft_bore_diameter_m: f64,
    /// Outside diameter of the housing; a thick one unless given.
    pub housing_outside_diameter_m: Option<f64>,
    /// Young's modulus of the shaft; that of the rings unless given.
    pub shaft_youngs_modulus_pa: Option<f64>,
    /// Poisson's ratio of the shaft; that of the rings unless given.
    pub shaft_poisson_ratio: Option<f64>,
    /// Young's modulus of the housing; that of the rings unless given.
    pub housing_youngs_modulus_pa: Option<f64>,
    /// Poisson's ratio of the housing; that of the rings unless given.
    pub housing_poisson_ratio: Option<f64>,
    /// Temperature of the inner ring; 20 °C unless given.
    pub inner_ring_temperature_c: Option<f64>,
    /// Temperature of the outer ring; 20 °C unless given.
    pub outer_ring_temperature_c: Option<f64>,
    /// Temperature of the balls; the mean of both rings unless given.
    pub ball_temperature_c: Option<f64>,
    /// Temperature of the shaft; that of the inner ring unless given.
    pub shaft_temperature_c: Option<f64>,
    /// Temperature of the housing; that of the outer ring unless given.
    pub housing_temperature_c: Option<f64>,
    /// Coefficient of thermal expansion of the rings; that of bearing steel unless given.
    pub ring_expansion_per_k: Option<f64>,
    /// Coefficient of thermal expansion of the balls; that of bearing steel for steel balls unless given.
    pub ball_expansion_per_k: Option<f64>,
    /// Coefficient of thermal expansion of the shaft; that of the rings unless given.
    pub shaft_expansion_per_k: Option<f64>,
    /// Coefficient of thermal expansion of the housing; that of the rings unless given.
    pub housing_expansion_per_k: Option<f64>,
}

/// Effect of fits, temperatures and speed on the radial internal clearance, m on the diameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct OperatingClearance {
    /// Gr of the bearing by itself at 20 °C and at rest.
    pub initial_m: f64,
    /// Interference of shaft and bore at their temperatures and speed; 0 or below: a gap, without effect.
    pub shaft_interference_m: f64,
    /// Interference of outer ring and housing at their temperatures.
    pub housing_interference_m: f64,
    /// Expansion of the inner raceway by the shaft.
    pub shaft_reduction_m: f64,
    /// Contraction of the outer raceway by the housing.
    pub housing_reduction_m: f64,
    /// Change of the clearance by the thermal expansion of free rings and balls.
    pub thermal_change_m: f64,
    /// Expansion of the inner raceway by the rotation of a free inner ring.
    pub speed_reduction_m: f64,
    /// Pressure between shaft and bore, Pa.
    pub shaft_pressure_pa: f64,
    /// Pressure between outer ring and housing, Pa.
    pub housing_pressure_pa: f64,
    /// Temperatures of inner ring, balls and outer ring, °C.
    pub parts_c: [f64; 3],
    /// Coefficient of thermal expansion of the rings, 1/K.
    pub ring_expansion_per_k: f64,
    /// Range of the clearance in operation about [that of the middles](Self::operating_m); `None` without tolerances.
    pub range: Option<ClearanceRange>,
}

impl OperatingClearance {
    /// Clearance in operation: below 0, preload.
    pub fn operating_m(&self) -> f64 {
        self.initial_m + self.change_m()
    }

    /// Clearance in operation less that of the bearing by itself.
    pub fn change_m(&self) -> f64 {
        self.thermal_change_m
            - self.shaft_reduction_m
            - self.housing_reduction_m
            - self.speed_reduction_m
    }
}

impl Fit {
    /// The clearance of a bearing that is mounted like this, at a speed of its inner ring.
    ///
    /// Ring and shaft grow by their rotation as free rings, the shaft with the E/ρ of the ring; the fit takes what is
    /// left of the interference. Without a bore in the fit, that of the ring is
    /// the estimate.
    ///
    /// # Errors
    /// An [`InputError`] naming the first field that cannot be: a diameter that is needed and left out
    /// (its value is NaN) or within another, a temperature below absolute zero, a coefficient of expansion
    /// that is needed of rings or balls other than of steel, a gain of clearance that no bearing has.
    pub fn operating_clearance(
        &self,
        dimensions: &BearingDimensions,
        materials: &Materials,
        inner_speed_rad_s: f64,
    ) -> Result<OperatingClearance, InputError> {
        let mounting = self.mounting(dimensions, materials, inner_speed_rad_s)?;
        let Mounting {
            inner_m,
            outer_m,
            warmth,
            ..
        } = mounting;
        let ball_m = 2.0 * dimensions.ball_radius_m;
        let [of_shaft, of_housing] = self.interferences()?;
        let shaft_seat = mounting.on_shaft(of_shaft.mean_m);
        let housing_seat = mounting.in_housing(of_housing.mean_m);
        let rings = warmth.ring_per_k * (outer_m * warmth.outer_k - inner_m * warmth.inner_k);
        let mut found = OperatingClearance {
            initial_m: outer_m - inner_m - 2.0 * ball_m,
            shaft_interference_m: shaft_seat.interference_m,
            housing_interference_m: housing_seat.interference_m,
            shaft_reduction_m: shaft_seat.reduction_m,
            housing_reduction_m: housing_seat.reduction_m,
            thermal_change_m: rings - 2.0 * ball_m * warmth.ball_per_k * warmth.ball_k,
            speed_reduction_m: mounting.ring_growth_m(inner_m),
            shaft_pressure_pa: shaft_seat.pressure_pa,
            housing_pressure_pa: housing_seat.pressure_pa,
            parts_c: [warmth.inner_k, warmth.ball_k, warmth.outer_k]
                .map(|k| REFERENCE_TEMPERATURE_C + k),
            ring_expansion_per_k: warmth.ring_per_k,
            range: None,
        };
        if self.has_tolerances() {
            let ends_m = |half_m: fn(Interference) -> f64, sum: fn([f64; 3]) -> f64| {
                [1.0, -1.0].map(|tighter| {
                    let [shaft_m, housing_m] =
                        [of_shaft, of_housing].map(|fit| fit.mean_m + tighter * half_m(fit));
                    let changes_m = [
                        mounting.on_shaft(shaft_m).reduction_m - shaft_seat.reduction_m,
                        mounting.in_housing(housing_m).reduction_m - housing_seat.reduction_m,
                        self.clearance_tolerance_m,
                    ];
                    found.operating_m() - tighter * sum(changes_m.map(f64::abs))
                })
            };
            found.range = Some(ClearanceRange {
                probable_m: ends_m(|fit| fit.probable_m, |[a, b, c]| a.hypot(b).hypot(c)),
                extreme_m: ends_m(|fit| fit.extreme_m, |[a, b, c]| a + b + c),
            });
        }
        let strain_m = found.change_m();
        let rule = "temperatures that enlarge the clearance by no more than a hundredth of the \
                    diameter of the inner groove";
        require("fit", strain_m, strain_m <= STRAIN_MAX * inner_m, rule)?;
        Ok(found)
    }

    /// Rings, shaft and housing, once their diameters and temperatures are checked.
    fn mounting<'a>(
        &self,
        dimensions: &BearingDimensions,
        materials: &'a Materials,
        inner_speed_rad_s: f64,
    ) -> Result<Mounting<'a>, InputError> {
        let [inner_m, outer_m] = [
            dimensions.inner_groove_bottom_radius_m,
            dimensions.outer_groove_bottom_radius_m,
        ]
        .map(|radius| 2.0 * radius);
        self.check(inner_m, outer_m)?;
        self.check_steel(materials)?;
        let ring = Solid {
            youngs_modulus_pa: materials.ring.youngs_modulus_pa,
            poisson_ratio: materials.ring.poisson_ratio,
        };
        let solid = |modulus: Option<f64>, ratio: Option<f64>| Solid {
            youngs_modulus_pa: modulus.unwrap_or(ring.youngs_modulus_pa),
            poisson_ratio: ratio.unwrap_or(ring.poisson_ratio),
        };
        let estimate_m = || 2.0 * dimensions.bore_radius_estimate_m();
        Ok(Mounting {
            ring_material: &materials.ring,
            ring,
            shaft: solid(self.shaft_youngs_modulus_pa, self.shaft_poisson_ratio),
            housing: solid(self.housing_youngs_modulus_pa, self.housing_poisson_ratio),
            inner_m,
            outer_m,
            bore_m: self.bore_diameter_m,
            ring_bore_m: self.bore_diameter_m.unwrap_or_else(estimate_m),
            shaft_bore_m: self.shaft_bore_diameter_m,
            outside_m: self.outside_diameter_m,
            housing_outside_m: self.housing_outside_diameter_m.unwrap_or(f64::INFINITY),
            inner_speed_rad_s,
            warmth: self.warmth(materials)?,
        })
    }

    /// Temperatures and expansion of the parts.
    fn warmth(&self, materials: &Materials) -> Result<Warmth, InputError> {
        let warmer = |given: Option<f64>, otherwise: f64| {
            given.map_or(otherwise, |t| t - REFERENCE_TEMPERATURE_C)
        };
        let inner_k = warmer(self.inner_ring_temperature_c, 0.0);
        let outer_k = warmer(self.outer_ring_temperature_c, 0.0);
        let ball_k = warmer(self.ball_temperature_c, 0.5 * (inner_k + outer_k));
        let shaft_k = warmer(self.shaft_temperature_c, inner_k);
        let housing_k = warmer(self.housing_temperature_c, outer_k);
        let warm = [inner_k, outer_k, ball_k, shaft_k, housing_k];
        let is_warm = warm.iter().any(|k| *k != 0.0);
        let of_steel = |field, given: Option<f64>, material: &Material| match given {
            Some(value) => Ok(value),
            None if material.is_steel() || !is_warm => Ok(STEEL_EXPANSION_PER_K),
            None => Err(InputError::new(field, f64::NAN, Allowed::AtLeast(0.0, ""))),
        };
        let (of_ring, of_ball) = (self.ring_expansion_per_k, self.ball_expansion_per_k);
        let ring_per_k = of_steel("ring_expansion_per_k", of_ring, &materials.ring)?;
        Ok(Warmth {
            inner_k,
            outer_k,
            ball_k,
            shaft_k,
            housing_k,
            ring_per_k,
            ball_per_k: of_steel("ball_expansion_per_k", of_ball, &materials.ball)?,
            shaft_per_k: self.shaft_expansion_per_k.unwrap_or(ring_per_k),
            housing_per_k: self.housing_expansion_per_k.unwrap_or(ring_per_k),
        })
    }

    /// Whether the clearance in operation has a range.
    fn has_tolerances(&self) -> bool {
        self.shaft.is_some() || self.housing.is_some() || self.clearance_tolerance_m > 0.0
    }

    /// Interference on the shaft and in the housing, at 20 °C and at rest.
    fn interferences(&self) -> Result<[Interference; 2], InputError> {
        let class = self.tolerance_class.unwrap_or_default();
        let smoothing_m = self.smoothing_m.unwrap_or(SMOOTHING_M);
        let mut found = [self.shaft_interference_m, self.housing_interference_m]
            .map(|given| Interference::exact(given.unwrap_or(0.0)));
        if let Some((shaft, bore)) = self.shaft.zip(self.bore_diameter_m) {
            let limits = shaft.limits_m(bore).zip(class.bore_limits_m(bore));
            let (shaft, ring) = limits.ok_or_else(|| no_limits("bore_diameter_m", bore, class))?;
            found[0] = Interference::of_limits(shaft, ring, smoothing_m);
        }
        if let Some((hole, outside)) = self.housing.zip(self.outside_diameter_m) {
            let limits = (hole.limits_m(outside)).zip(class.outside_limits_m(outside));
            let (hole, ring) =
                limits.ok_or_else(|| no_limits("outside_diameter_m", outside, class))?;
            found[1] = Interference::of_limits(ring, hole, smoothing_m);
        }
        Ok(found)
    }

    /// Refuses what a fit by tolerance classes excludes or alone has.
    fn check_classes(&self) -> Result<(), InputError> {
        for (named, field, given) in [
            (
                self.shaft.is_some(),
                "shaft_interference_m",
                self.shaft_interference_m,
            ),
            (
                self.housing.is_some(),
                "housing_interference_m",
                self.housing_interference_m,
            ),
        ] {
            if let (true, Some(given)) = (named, given) {
                let rule = "left out: the tolerance class gives the interference";
                return Err(InputError::rule(field, given, rule));
            }
        }
        let is_named = self.shaft.is_some() || self.housing.is_some();
        for (field, given) in [
            ("tolerance_class", self.tolerance_class.map(|_| f64::NAN)),
            ("smoothing_m", self.smoothing_m),
        ] {
            if let (false, Some(given)) = (is_named, given) {
                let rule = "left out, or shaft or housing a tolerance class";
                return Err(InputError::rule(field, given, rule));
            }
        }
        not_negative("clearance_tolerance_m", self.clearance_tolerance_m)?;
        not_negative("smoothing_m", self.smoothing_m.unwrap_or(0.0))
    }

    /// Refuses steel that is no longer hard, and temperatures in K.
    fn check_steel(&self, materials: &Materials) -> Result<(), InputError> {
        let [ring, ball] = [&materials.ring, &materials.ball].map(Material::is_steel);
        let why = "bearing steel softens above; 293 K are 20 °C";
        for (is_steel, field, value) in [
            (
                ring,
                "inner_ring_temperature_c",
                self.inner_ring_temperature_c,
            ),
            (
                ring,
                "outer_ring_temperature_c",
                self.outer_ring_temperature_c,
            ),
            (ball, "ball_temperature_c", self.ball_temperature_c),
        ] {
            if let Some(value) = value.filter(|_| is_steel) {
                Allowed::AtMost(STEEL_MAX_C, why).check(field, value)?;
            }
        }
        Ok(())
    }

    fn check(&self, inner_m: f64, outer_m: f64) -> Result<(), InputError> {
        self.check_classes()?;
        let interferes = |given: Option<f64>| given.is_some_and(|given| given != 0.0);
        let bore = within_wall(
            "bore_diameter_m",
            self.bore_diameter_m,
            self.shaft.is_some()
                || interferes(self.shaft_interference_m)
                || self.shaft_temperature_c.is_some(),
            0.0,
            inner_m,
        )?;
        within_wall(
            "outside_diameter_m",
            self.outside_diameter_m,
            self.housing.is_some()
                || interferes(self.housing_interference_m)
                || self.housing_temperature_c.is_some(),
            outer_m,
            f64::INFINITY,
        )?;
        for (field, value) in [
            ("shaft_interference_m", self.shaft_interference_m),
            ("housing_interference_m", self.housing_interference_m),
        ] {
            finite(field, value.unwrap_or(0.0))?;
        }
        self.check_counterparts(bore, outer_m)?;
        self.check_warmth()
    }

    /// Checks shaft and housing.
    fn check_counterparts(&self, bore: Option<f64>, outer_m: f64) -> Result<(), InputError> {
        not_negative("shaft_bore_diameter_m", self.shaft_bore_diameter_m)?;
        if let Some(bore) = bore {
            Allowed::Below(bore, "the bore of the inner ring")
                .check("shaft_bore_diameter_m", self.shaft_bore_diameter_m)?;
        }
        if let Some(value) = self.housing_outside_diameter_m {
            let outside = self.outside_diameter_m.unwrap_or(outer_m);
            Allowed::Above(outside, "the outside of the outer ring")
                .check("housing_outside_diameter_m", value)?;
        }
        for (field, value) in [
            ("shaft_youngs_modulus_pa", self.shaft_youngs_modulus_pa),
            ("housing_youngs_modulus_pa", self.housing_youngs_modulus_pa),
        ] {
            value.map_or(Ok(()), |value| positive(field, value))?;
        }
        for (field, value) in [
            ("shaft_poisson_ratio", self.shaft_poisson_ratio),
            ("housing_poisson_ratio", self.housing_poisson_ratio),
        ] {
            value.map_or(Ok(()), |value| check_poisson_ratio(field, value))?;
        }
        Ok(())
    }

    /// Checks temperatures and coefficients of expansion.
    fn check_warmth(&self) -> Result<(), InputError> {
        for (field, value) in [
            ("inner_ring_temperature_c", self.inner_ring_temperature_c),
            ("outer_ring_temperature_c", self.outer_ring_temperature_c),
            ("ball_temperature_c", self.ball_temperature_c),
            ("shaft_temperature_c", self.shaft_temperature_c),
            ("housing_temperature_c", self.housing_temperature_c),
        ] {
            let Some(value) = value else { continue };
            finite(field, value)?;
            Allowed::Above(ABSOLUTE_ZERO_C, "absolute zero").check(field, value)?;
        }
        for (field, value) in [
            ("ring_expansion_per_k", self.ring_expansion_per_k),
            ("ball_expansion_per_k", self.ball_expansion_per_k),
            ("shaft_expansion_per_k", self.shaft_expansion_per_k),
            ("housing_expansion_per_k", self.housing_expansion_per_k),
        ] {
            let Some(value) = value else { continue };
            let kept = (0.0..=EXPANSION_MAX_PER_K).contains(&value);
            require(
                field,
                value,
                kept,
                format!("from 0 to {EXPANSION_MAX_PER_K}"),
            )?;
        }
        Ok(())
    }
}

/// A diameter on the far side of a ring from its groove; NaN in the error of one that is needed.
fn within_wall(
    field: &'static str,
    value: Option<f64>,
    needed: bool,
    least: f64,
    most: f64,
) -> Result<Option<f64>, InputError> {
    let allowed = if most.is_finite() {
        Allowed::Between(least, most, "the bottom of the inner groove")
    } else {
        Allowed::Above(least, "the bottom of the outer groove")
    };
    match value {
        Some(value) if value > least && value < most => Ok(Some(value)),
        None if !needed => Ok(None),
        _ => Err(InputError::new(field, value.unwrap_or(f64::NAN), allowed)),
    }
}

/// Error of a diameter that the tables of tolerances do not have.
fn no_limits(field: &'static str, diameter_m: f64, class: BearingClass) -> InputError {
    let [least_m, most_m] = size_range::SIZES_MM.map(|mm| mm * size_range::MILLIMETRE_M);
    let why = "tolerance classes of ISO 286 go from 1 to 500 mm";
    let allowed = if diameter_m < least_m {
        Allowed::AtLeast(least_m, why)
    } else if diameter_m > most_m {
        Allowed::AtMost(most_m, why)
    } else {
        let most_m = class.largest_bore_m();
        Allowed::AtMost(most_m, "the largest bore of this tolerance_class")
    };
    InputError::new(field, diameter_m, allowed)
}
