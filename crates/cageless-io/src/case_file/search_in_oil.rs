//! Ranges of `[search]` that a film leaves no room for.

use cageless_design::STEADY_GAP;
use cageless_design::search::Request;

use super::CaseFile;
use super::error::CaseError;
use super::value::CaseValue;

/// Keys of operating points, each with what a search in oil takes of it and how many values that is.
const POINTS: [(&str, &str, usize); 4] = [
    ("search.inner_speed_rpm", ONE, 1),
    ("search.radial_load_n", ONE, 1),
    ("search.axial_load_n", ONE, 1),
    ("search.map_speed_rpm", NONE, 0),
];
const ONE: &str = "one number or left out";
const NONE: &str = "left out";
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
        for (key, taken, most) in POINTS {
            let beyond = |values: &[f64]| most == 0 || values.len() > most;
            let beyond =
                matches!(self.value(key), Some(CaseValue::Numbers(values)) if beyond(&values));
            if beyond {
                let allowed = format!(
                    "{taken}: a search with [film] has one speed and one load, as the lag in oil differs with each"
                );
                return Err(self.refuse(key, &allowed));
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
