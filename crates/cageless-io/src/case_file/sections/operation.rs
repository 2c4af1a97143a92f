//! `[operation]`.

use cageless::Operation;

use crate::case_file::CaseError;
use crate::case_file::convert::Converter;
use crate::case_file::declaration::Line::Shown;
use crate::case_file::declaration::Presence::{Default, Required};
use crate::case_file::declaration::section;
use crate::case_file::unit::Unit::{RevolutionPerMinute, Si};

section! {
    /// `[operation]`: speed and load.
    OperationDocument {
        inner_speed_rpm => inner_speed_rad_s: f64 = Required, RevolutionPerMinute,
            "speed of the inner ring", Shown("12000.0", "counter-clockwise (paper)");
        radial_load_n => radial_load_n: f64 = Required, Si("N"),
            "Fr, load on the inner ring, downwards", Shown("1500.0", "Fr, downwards (paper)");
        gravity_m_s2 => gravity_m_s2: f64 = Default(9.81), Si("m/s^2"),
            "g, downwards", Shown("9.81", "downwards");
    }
}

impl Converter<'_> {
    /// Speed and load.
    pub(in crate::case_file) fn operation(&self) -> Result<Operation, CaseError> {
        let o = &self.document.operation;
        Ok(Operation {
            inner_speed_rad_s: self.si("operation.inner_speed_rpm", o.inner_speed_rpm)?,
            radial_load_n: self.si("operation.radial_load_n", o.radial_load_n)?,
            gravity_m_s2: self.si("operation.gravity_m_s2", o.gravity_m_s2)?,
            inner_speed_table: None,
            radial_load_table: None,
        })
    }
}
