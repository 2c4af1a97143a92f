//! Temperature of the oil beside those of the rings.

use super::CaseFile;
use super::unit::decimal;

const OIL: &str = "film.temperature_c";
const RINGS: [&str; 2] = [
    "fit.inner_ring_temperature_c",
    "fit.outer_ring_temperature_c",
];
/// Largest difference between the oil at the inlet and the nearer ring that passes unsaid, K.
const UNSAID_K: f64 = 10.0;

impl CaseFile {
    /// Warning about an oil whose temperature is not that of the rings of `[fit]`, between which it lies at the inlet.
    pub fn oil_temperature_warning(&self) -> Option<String> {
        let oil_c = self.document.number(OIL)?;
        let rings: Vec<(&str, f64)> = RINGS
            .into_iter()
            .filter_map(|key| Some((key, self.document.number(key)?)))
            .collect();
        let coldest_c = rings
            .iter()
            .map(|ring| ring.1)
            .fold(f64::INFINITY, f64::min);
        let warmest_c = rings
            .iter()
            .map(|ring| ring.1)
            .fold(f64::NEG_INFINITY, f64::max);
        let apart_k = (coldest_c - oil_c).max(oil_c - warmest_c);
        (!rings.is_empty() && apart_k > UNSAID_K).then(|| {
            let rings = rings.iter().map(|(key, c)| format!("{key} = {}", decimal(*c)));
            format!(
                "{OIL} = {} is {} K from {}: oil at the inlet of a contact has the temperature of the rings",
                decimal(oil_c),
                decimal(apart_k),
                rings.collect::<Vec<_>>().join(", ")
            )
        })
    }
}
