//! Ranges of `[search]` that a film leaves no room for.

use cageless::design::STEADY_GAP;
use cageless::design::search::Request;

use super::CaseFile;
use super::error::CaseError;
use super::value::CaseValue;

/// Keys of operating points, of which a search in oil has one.
const POINTS: [&str; 4] = [
    "search.inner_speed_rpm",
    "search.radial_load_n",
    "search.axial_load_n",
    "search.map_speed_rpm",
];
const LEAST_GAP: &str = "search.critical_gap_min_fraction";

impl CaseFile {
    /// The request of a search that is to run, else that of [`CaseFile::search`].
    ///
    /// # Errors
    /// A key of `[search]` that a case with `[film]` must leave out.
    pub fn request_to_run(&self) -> Result<&Request, CaseError> {
        if self.case.film.is_none() {
            return Ok(self.search());
        }
        for key in POINTS {
            let several = match self.value(key) {
                Some(CaseValue::Numbers(values)) => {
                    key.ends_with("map_speed_rpm") || values.len() > 1
                }
                _ => false,
            };
            if several {
                let allowed = "one number or left out: a search with [film] has one speed and one load, as the lag \
                               in oil differs with each";
                let allowed = match key.ends_with("map_speed_rpm") {
                    true => allowed.trim_start_matches("one number or "),
                    false => allowed,
                };
                return Err(self.refuse(key, allowed));
            }
        }
        let usual = STEADY_GAP.limit();
        match self.value(LEAST_GAP) {
            Some(CaseValue::Number(fraction)) if fraction != usual => {
                let allowed = format!(
                    "left out, or {usual}: a search with [film] seeks critical gaps of 1 to 1.1 of the steady-state gap"
                );
                Err(self.refuse(LEAST_GAP, &allowed))
            }
            _ => Ok(self.search()),
        }
    }

    fn refuse(&self, key: &str, allowed: &str) -> CaseError {
        let value = self.value(key).map(|value| value.written());
        let tree = &self.document.tree;
        tree.refusal(key, &value.unwrap_or_default(), allowed)
    }
}
