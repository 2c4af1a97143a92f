//! Materials of a case.

use cageless::Material;

use crate::case_file::converter::Converter;
use crate::case_file::document::{MaterialPreset, PartMaterialDocument};
use crate::case_file::error::CaseError;
use crate::case_file::named::Named;
use crate::case_file::sections::material::NUMBERS;
use crate::case_file::spanned_toml::join;

impl Converter<'_> {
    /// Material of balls or rings; `[material]` unless it has its own.
    pub(in crate::case_file) fn material_of(
        &self,
        section: &str,
        own: Option<&PartMaterialDocument>,
    ) -> Result<Material, CaseError> {
        match own {
            Some(m) => {
                let numbers = [m.density_kg_m3, m.youngs_modulus_gpa, m.poisson_ratio];
                self.material(section, m.preset, numbers)
            }
            None => {
                let m = &self.document.material;
                let numbers = [m.density_kg_m3, m.youngs_modulus_gpa, m.poisson_ratio];
                self.material("material", m.preset, numbers)
            }
        }
    }

    fn material(
        &self,
        section: &str,
        preset: Option<MaterialPreset>,
        given: [Option<f64>; 3],
    ) -> Result<Material, CaseError> {
        let mut si = [0.0; 3];
        for (k, name) in NUMBERS.into_iter().enumerate() {
            let path = join(section, name);
            let value = match (preset, given[k]) {
                (Some(preset), Some(value)) if value != preset.numbers()[k] => {
                    let allowed = format!(
                        "left out with {section}.preset = \"{}\", which has {}",
                        preset.name(),
                        preset.numbers()[k]
                    );
                    return Err(self.refuse(&path, &value.to_string(), &allowed));
                }
                (Some(preset), _) => preset.numbers()[k],
                (None, Some(value)) => value,
                (None, None) => {
                    let error = self.missing(section, name);
                    let choice =
                        format!("; or give {section}.preset, {}", MaterialPreset::choices());
                    return Err(error.with_more(&choice));
                }
            };
            si[k] = self.si(&path, value)?;
        }
        let [density_kg_m3, youngs_modulus_pa, poisson_ratio] = si;
        let material = Material {
            density_kg_m3,
            youngs_modulus_pa,
            poisson_ratio,
        };
        material
            .check()
            .map_err(|e| self.refused_in(Some(section), &e, None))?;
        Ok(material)
    }
}
