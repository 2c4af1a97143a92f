//! Thermal numbers of the materials of a case: those of its keys, or of the materials by name.

use cageless::touchdown::Thermal;
use cageless::{Fit, Material};

use super::CaseFile;
use super::convert::completed;
use super::converter::Converter;
use super::sections::CaseSections;
use super::sections::material::{
    MaterialHeat, MaterialPreset, PartMaterialSection, STEEL_SOFTENING_C,
};

/// Thermal numbers of the materials by name of rings and balls.
struct Heats {
    ring: Option<MaterialHeat>,
    ball: Option<MaterialHeat>,
}

impl Heats {
    fn of(sections: &CaseSections) -> Self {
        let of = |own: Option<&PartMaterialSection>| {
            let preset = own.map_or(sections.material.preset, |own| own.preset);
            preset.map(MaterialPreset::heat)
        };
        Self {
            ring: of(sections.ring_material.as_ref()),
            ball: of(sections.ball_material.as_ref()),
        }
    }
}

impl Converter<'_> {
    /// `[thermal]`.
    pub(super) fn thermal(&self) -> Thermal {
        let heats = Heats::of(self.sections);
        let mut thermal = self.sections.thermal.clone().unwrap_or_default();
        let specific = |heat: Option<MaterialHeat>| Some(heat?.specific_heat_j_kg_k);
        let (ring, ball) = (specific(heats.ring), specific(heats.ball));
        thermal.ring_specific_heat_j_kg_k = thermal.ring_specific_heat_j_kg_k.or(ring);
        thermal.ball_specific_heat_j_kg_k = thermal.ball_specific_heat_j_kg_k.or(ball);
        thermal
    }

    /// `[fit]`.
    pub(super) fn fit(&self) -> Option<Fit> {
        Some(expanding(self.sections.fit.clone()?, self.sections))
    }
}

/// Fits with the expansion of the materials by name.
fn expanding(mut fit: Fit, sections: &CaseSections) -> Fit {
    let heats = Heats::of(sections);
    let expansion = |heat: Option<MaterialHeat>| Some(heat?.expansion_per_k);
    fit.ring_expansion_per_k = fit.ring_expansion_per_k.or(expansion(heats.ring));
    fit.ball_expansion_per_k = fit.ball_expansion_per_k.or(expansion(heats.ball));
    fit
}

impl CaseFile {
    /// Dotted keys without which the parts of the bearing have no temperature after a drop, and of a
    /// bearing that drops again warm also those without which it has no clearance then.
    pub fn missing_of_heat(&self, warm: bool) -> Vec<&'static str> {
        let (case, Some(sections)) = (&self.case, self.sections()) else {
            return vec![];
        };
        let materials = case.bearing.materials();
        let (thermal, fit) = (
            &self.particulars.thermal,
            expanding(sections.fit.clone().unwrap_or_default(), &sections),
        );
        let needed = |key, material: &Material, given: Option<f64>| {
            (given.is_none() && !material.is_steel()).then_some(key)
        };
        let heat = [
            needed(
                "thermal.ring_specific_heat_j_kg_k",
                &materials.ring,
                thermal.ring_specific_heat_j_kg_k,
            ),
            needed(
                "thermal.ball_specific_heat_j_kg_k",
                &materials.ball,
                thermal.ball_specific_heat_j_kg_k,
            ),
        ];
        let expansion = [
            needed(
                "fit.ring_expansion_per_k",
                &materials.ring,
                fit.ring_expansion_per_k,
            ),
            needed(
                "fit.ball_expansion_per_k",
                &materials.ball,
                fit.ball_expansion_per_k,
            ),
        ];
        let expansion = expansion.into_iter().filter(|_| warm);
        heat.into_iter().chain(expansion).flatten().collect()
    }

    fn sections(&self) -> Option<CaseSections> {
        CaseSections::read(&completed(&self.document).tree).ok()
    }

    /// Temperatures above which inner ring, balls and outer ring soften, °C; `None` of what is not steel.
    pub fn softening_c(&self) -> [Option<f64>; 3] {
        let sections = self.sections();
        let heats = sections.as_ref().map(Heats::of);
        let of = |heat: Option<MaterialHeat>, material: &Material| match heat {
            Some(heat) => heat.softening_c,
            None => material.is_steel().then_some(STEEL_SOFTENING_C),
        };
        let materials = self.case.bearing.materials();
        let ring = of(heats.as_ref().and_then(|heats| heats.ring), &materials.ring);
        let ball = of(heats.as_ref().and_then(|heats| heats.ball), &materials.ball);
        [ring, ball, ring]
    }
}
