//! Support of the outer ring of a case.

use cageless::Support;
use cageless::rotor::SupportStop;

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;

impl Converter<'_> {
    pub(in crate::case_file) fn support(&self) -> Result<Option<Support>, CaseError> {
        let Some(s) = &self.document.support else {
            return Ok(None);
        };
        let stop = match (s.stop_gap_um, s.stop_stiffness_n_m) {
            (None, None) => None,
            (Some(gap), Some(stiffness)) => Some(SupportStop {
                gap_m: self.si("support.stop_gap_um", gap)?,
                stiffness_n_m: self.si("support.stop_stiffness_n_m", stiffness)?,
            }),
            (None, Some(_)) => return Err(self.missing("support", "stop_gap_um")),
            (Some(_), None) => return Err(self.missing("support", "stop_stiffness_n_m")),
        };
        Ok(Some(Support {
            mass_kg: self.si("support.mass_kg", s.mass_kg)?,
            stiffness_n_m: self.si("support.stiffness_n_m", s.stiffness_n_m)?,
            damping_n_s_m: self.si("support.damping_n_s_m", s.damping_n_s_m)?,
            stop,
        }))
    }
}
