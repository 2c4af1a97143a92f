//! Steady operation.

use cageless::steady::SteadyOperation;
use cageless::tolerance::{BALL_GRADES, ball_grade};

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
            let grades: Vec<String> = BALL_GRADES.iter().map(|g| g.number.to_string()).collect();
            let allowed = format!("a grade of ISO 3290-1: {}", grades.join(", "));
            self.refuse("steady.grade", &allowed)
        })?;
        Ok(SteadyOperation {
            grade,
            start: steady.start,
            transient_orbits: steady.transient_orbits,
            measured_orbits: steady.measured_orbits,
        })
    }
}
