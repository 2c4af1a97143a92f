//! Basis of a decision: equilibrium and life, tolerances and benefit of the raceway.

use cageless::Case;
use cageless_io::case_file::CaseFile;
use cageless_results::{Record, equilibrium_record_noted};
use serde::Serialize;

use crate::error::StudyError;
use crate::measured::Limits;
use crate::progress::Progress;
use crate::tolerance::{Request, ToleranceResult, tolerance};

/// Results on the sheet of a case.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SheetResult {
    /// Equilibrium, ratings and limits.
    #[serde(rename = "static")]
    pub equilibrium: Record,
    /// Verdict on the raceway with each tolerance at both ends, and its benefit; `None` without a raceway, and of a
    /// drop, which has no steady operation.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tolerance: Option<ToleranceResult>,
}

/// A sheet that can be computed.
#[derive(Debug)]
pub struct Sheet<'a> {
    file: &'a CaseFile,
    name: &'a str,
    equilibrium: Record,
    request: Option<Request>,
}

impl<'a> Sheet<'a> {
    /// The sheet of a case with the tolerances on its drawing, and with the benefit in long runs if it is asked for.
    /// `name` is the name of the case in messages.
    ///
    /// # Errors
    /// The case has no equilibrium, its raceway cannot be judged, or a tolerance is impossible.
    pub fn new(
        file: &'a CaseFile,
        name: &'a str,
        limits: &Limits,
        benefit: bool,
    ) -> Result<Self, StudyError> {
        let (resting, note) = file.clone().resting()?;
        resting.checked(|case| case.check_constant_operation("a static equilibrium"))?;
        limits.check()?;
        let case = file.case();
        let judged = case.rotor.is_none() && !case.raceways.is_empty();
        let request = judged.then_some(Request {
            samples: 0,
            groove_depth_um: limits.groove_depth_um,
            axial_span_um: limits.axial_span_um,
            half_angle_deg: limits.half_angle_deg,
            benefit,
            ..Request::default()
        });
        if let Some(request) = &request {
            file.checked(Case::check_run)?;
            request.check(case, name)?;
        }
        Ok(Self {
            file,
            name,
            equilibrium: equilibrium_record_noted(resting.case(), resting.particulars(), note)?,
            request,
        })
    }

    /// Computes it.
    ///
    /// # Errors
    /// A run left the physical range, or the progress ended the work before the verdict.
    pub fn compute(self, progress: &dyn Progress) -> Result<SheetResult, StudyError> {
        let judged = |request| tolerance(self.file, self.name, &request, progress);
        Ok(SheetResult {
            equilibrium: self.equilibrium,
            tolerance: self.request.map(judged).transpose()?,
        })
    }
}
