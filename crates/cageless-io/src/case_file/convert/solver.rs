//! Solver and seed of a case.

use cageless::Solver;

use crate::case_file::converter::Converter;
use crate::case_file::declaration::Field;
use crate::case_file::error::CaseError;

/// Step of a case whose step is still to be chosen.
const PROVISIONAL_STEP_S: f64 = 1e-6;

impl Converter<'_> {
    pub(in crate::case_file) fn solver(&self) -> Result<Solver, CaseError> {
        let s = &self.document.solver;
        // An automatic step is put right once the case is known.
        let step_s = s.step_us.si(&|value| self.si("solver.step_us", value))?;
        Ok(Solver {
            method: s.method,
            step_s: step_s.unwrap_or(PROVISIONAL_STEP_S),
            tolerance: self.si("solver.tolerance", s.tolerance)?,
            duration_s: self.si("solver.duration_s", s.duration_s)?,
        })
    }

    pub(in crate::case_file) fn seed(&self) -> Result<u64, CaseError> {
        let seed = self.document.solver.seed;
        // TOML holds no larger integer, and the document must be able to go back.
        if i64::try_from(seed).is_err() {
            return Err(self.refuse("solver.seed", &seed.to_string(), "less than 2^63"));
        }
        Ok(seed)
    }
}
