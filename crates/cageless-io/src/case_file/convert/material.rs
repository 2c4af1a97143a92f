//! Materials of a case.

use cageless::Material;

use crate::case_file::converter::{Converter, refused_in};
use crate::case_file::error::CaseError;
use crate::case_file::named::Named;
use crate::case_file::sections::material::{MaterialPreset, NUMBERS, PartMaterialSection};
use crate::case_file::spanned_toml::join;
use crate::case_file::unit::Unit;

impl Converter<'_> {
    /// Material of balls or rings; `[material]` unless it has its own.
    pub(in crate::case_file) fn material_of(
        &self,
        section: &str,
        own: Option<&PartMaterialSection>,
    ) -> Result<Material, CaseError> {
        let general = &self.sections.material;
        match own {
            Some(own) => self.material(section, own.preset, own.numbers()),
            None => self.material("material", general.preset, general.numbers()),
        }
    }

    fn material(
        &self,
        section: &str,
        preset: Option<MaterialPreset>,
        given: [Option<f64>; 3],
    ) -> Result<Material, CaseError> {
        let typical = preset.map(|preset| {
            let [density, modulus_gpa, ratio] = preset.numbers();
            [density, Unit::Gigapascal.to_si(modulus_gpa), ratio]
        });
        let mut numbers = [0.0; 3];
        for (k, name) in NUMBERS.into_iter().enumerate() {
            numbers[k] = match (preset, typical, given[k]) {
                (Some(preset), Some(typical), Some(value)) if value != typical[k] => {
                    let allowed = format!(
                        "left out with {section}.preset = \"{}\", which has {}",
                        preset.name(),
                        preset.numbers()[k]
                    );
                    return Err(self.refuse(&join(section, name), &allowed));
                }
                (_, Some(typical), _) => typical[k],
                (_, None, Some(value)) => value,
                (_, None, None) => {
                    let error = self.missing(section, name);
                    let choice =
                        format!("; or give {section}.preset, {}", MaterialPreset::choices());
                    return Err(error.with_more(&choice));
                }
            };
        }
        let [density_kg_m3, youngs_modulus_pa, poisson_ratio] = numbers;
        let material = Material {
            density_kg_m3,
            youngs_modulus_pa,
            poisson_ratio,
        };
        let refused = |e| refused_in(self.document, Some(section), &e, None);
        material.check().map_err(refused)?;
        Ok(material)
    }
}
