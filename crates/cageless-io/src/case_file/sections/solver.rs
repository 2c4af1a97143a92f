//! `[solver]`.

use cageless::{IntegrationMethod, Solver};

use crate::case_file::CaseError;
use crate::case_file::convert::Converter;
use crate::case_file::declaration::Field;
use crate::case_file::declaration::Line::{Commented, Shown};
use crate::case_file::declaration::Presence::Default;
use crate::case_file::declaration::section;
use crate::case_file::document::StepDocument;
use crate::case_file::unit::Unit::{Microsecond, None as Plain, Si};

/// Step of a case whose step is still to be chosen.
const PROVISIONAL_STEP_S: f64 = 1e-6;

section! {
    /// `[solver]`: integration. The error per step is a hundredth of what a figure shows.
    SolverDocument {
        method => method: IntegrationMethod = Default(IntegrationMethod::VelocityVerlet), Plain,
            "integration method",
            Commented("\"symplectic\"", "\"abm4\": the paper's; \"adaptive\": for references");
        step_us => step_s: StepDocument = Default(StepDocument::Auto), Microsecond,
            "step of the integration, from the stiffest contact unless it is a number",
            Commented("\"auto\"", "from the stiffest contact, or a number");
        tolerance => tolerance: f64 = Default(1e-8), Plain,
            "error per step of the adaptive method",
            Commented("1.0e-8", "error per step, only for \"adaptive\"");
        duration_s => duration_s: f64 = Default(0.5), Si("s"),
            "simulated time", Shown("0.5", "simulated time");
        seed: u64 = Default(0), Plain,
            "seed of random starts (run --verify, design --search) and samples (tolerance, drop)",
            Commented("0", "of the random starts and samples of run --verify,\n\
                design --search and tolerance");
    }
}

impl Converter<'_> {
    pub(in crate::case_file) fn solver(&self) -> Result<Solver, CaseError> {
        let s = &self.document.solver;
        // An automatic step is put right once the case is known.
        let step_s = s.step_us.si(self, "solver.step_us")?;
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
