//! A touch-down bearing on which its rotor has come to rest.

use cageless::{Rotor, Shaft};

use super::unit::Unit;
use super::{CaseError, CaseFile};

/// Sections that a bearing on which a rotor rests does not have.
const OF_A_DROP: [&str; 4] = ["rotor", "support", "limit", "start"];

impl CaseFile {
    /// The case of a drop with the weight of its rotor as the load, at the speed of the rotor, and a sentence
    /// that says so; any other case as it is.
    ///
    /// # Errors
    /// A [`CaseError`] if the bearing cannot turn at this speed under this load.
    pub fn resting(self) -> Result<(Self, Option<String>), CaseError> {
        let Some(rotor) = &self.case.rotor else {
            return Ok((self, None));
        };
        let ring_kg = self.case.bearing.dimensions().inner_ring_mass_kg;
        let [radial_n, axial_n] = loads_n(rotor, self.case.operation.gravity_m_s2, ring_kg);
        let speed_rpm = Unit::RevolutionPerMinute.of_si(rotor.speed_rad_s);
        let mut document = self.document.clone();
        for section in OF_A_DROP {
            document.remove(section);
        }
        document.set("operation.inner_speed_rpm", speed_rpm);
        document.set("operation.radial_load_n", radial_n);
        if axial_n != 0.0 {
            document.set("operation.axial_load_n", axial_n);
        }
        if rotor.shaft == Shaft::Vertical {
            document.set("operation.gravity_m_s2", 0.0);
        }
        // No run follows.
        document.set("solver.step_us", "auto");
        let said = format!(
            "the load is that of the rotor at rest in the bearing, {radial_n:.1} N across and {axial_n:.1} N \
             along the axis, at {speed_rpm:.0} rpm; `cageless drop` drops it"
        );
        Ok((self.with_document(document)?, Some(said)))
    }
}

/// Radial and axial load of a rotor at rest; along the axis with the weight of the inner ring.
fn loads_n(rotor: &Rotor, gravity_m_s2: f64, inner_ring_kg: f64) -> [f64; 2] {
    match rotor.shaft {
        Shaft::Horizontal => [rotor.mass_kg * gravity_m_s2, rotor.axial_load_n],
        Shaft::Vertical => {
            let mass_kg = rotor.mass_kg + inner_ring_kg;
            [0.0, rotor.axial_load_n - mass_kg * gravity_m_s2]
        }
    }
}
