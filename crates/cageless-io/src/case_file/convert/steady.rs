//! Steady operation.

use cageless::steady::{BenefitWeights, SteadyOperation};
use cageless::{ball_grade, ball_grades_text};

use crate::case_file::converter::Converter;
use crate::case_file::error::CaseError;

impl Converter<'_> {
    /// The steady operation of `[steady]`.
    pub(in crate::case_file) fn steady(&self) -> Result<SteadyOperation, CaseError> {
        let Some(steady) = &self.sections.steady else {
            return Ok(SteadyOperation::default());
        };
        let grade = u32::try_from(steady.grade).ok().and_then(ball_grade);
        let grade = grade.ok_or_else(|| {
            let allowed = format!("a grade of ISO 3290-1: {}", ball_grades_text());
            self.refuse("steady.grade", &allowed)
        })?;
        let weights = BenefitWeights {
            contacts: steady.weight_contacts,
            spacing: steady.weight_spacing,
            force: steady.weight_force,
        };
        if weights.contacts + weights.spacing + weights.force <= 0.0 {
            let allowed = "more than 0 where steady.weight_spacing and steady.weight_force are 0";
            return Err(self.refuse("steady.weight_contacts", allowed));
        }
        Ok(SteadyOperation {
            grade,
            start: steady.start,
            transient_orbits: steady.transient_orbits,
            measured_orbits: steady.measured_orbits,
            weights,
        })
    }
}
