//! Outer dimensions of the outer ring, which only `export` needs.

use cageless::InputError;
use cageless::surface::OuterRingDimensions;

use super::converter::refused_in;
use super::key::Key;
use super::spanned_toml::join;
use super::unit::Unit;
use super::{CaseError, CaseFile, keys};

const SECTION: &str = "bearing";

impl CaseFile {
    /// The outside of the outer ring, to be blended over `blend_m`.
    ///
    /// # Errors
    /// A [`CaseError`] if the file leaves out one of its two dimensions.
    pub fn outer_ring_dimensions(&self, blend_m: f64) -> Result<OuterRingDimensions, CaseError> {
        let required = |name: &str| {
            let value = self.document.number(&join(SECTION, name));
            value
                .map(|mm| Unit::Millimetre.to_si(mm))
                .ok_or_else(|| self.missing_for_export(name))
        };
        Ok(OuterRingDimensions {
            outer_ring_outer_radius_m: match self.case.bearing.outside_radius_m() {
                Some(radius_m) => radius_m,
                None => required("outer_ring_outer_radius_mm")?,
            },
            outer_ring_width_m: required("outer_ring_width_mm")?,
            blend_m,
        })
    }

    /// Error of the outer ring in terms of the file.
    pub fn refused(&self, error: &InputError) -> CaseError {
        refused_in(&self.document, None, error, None)
    }

    fn missing_for_export(&self, name: &str) -> CaseError {
        let path = join(SECTION, name);
        let meaning = keys::find(SECTION, name).map_or_else(String::new, Key::describe);
        let message = format!(
            "{path} is missing in [{SECTION}], and the shape of the outer ring needs it: {meaning}"
        );
        self.document.tree.error(&path, message)
    }
}
