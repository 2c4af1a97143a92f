//! `[support]`: what carries the outer ring under a falling rotor.

use cageless::Support;
use cageless::rotor::SupportStop;

use crate::case_file::CaseError;
use crate::case_file::convert::Converter;
use crate::case_file::declaration::Line::{Absent, Shown};
use crate::case_file::declaration::Presence::{Optional, Required};
use crate::case_file::declaration::section;
use crate::case_file::unit::Unit::{Micrometre, Si};

section! {
    /// `[support]`: the support of the outer ring and housing under a falling rotor; without it
    /// they are fixed.
    SupportDocument {
        mass_kg -> support_mass_kg: f64 = Required, Si("kg"),
            "mass of outer ring and housing", Shown("0.5", "outer ring and housing");
        stiffness_n_m -> support_stiffness_n_m: f64 = Required, Si("N/m"),
            "stiffness of the support", Shown("2.0e7", "ribbon or O-ring: 1e6 to 5e7");
        damping_n_s_m -> support_damping_n_s_m: f64 = Required, Si("N s/m"),
            "damping of the support", Shown("4.0e3", "");
        stop_gap_um -> stop_gap_m: Option<f64> = Optional, Micrometre,
            "way of the outer ring to a hard stop; none unless given", Absent;
        stop_stiffness_n_m -> stop_stiffness_n_m: Option<f64> = Optional, Si("N/m"),
            "stiffness of the hard stop", Absent;
    }
}

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
